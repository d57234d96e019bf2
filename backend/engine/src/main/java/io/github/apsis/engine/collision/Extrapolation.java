package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import java.util.Arrays;

/**
 * Where rounds of sequential impulses lead to, when a heavy body lies on a light one: Aitken's method (Aitken 1926, Proc. R.
 * Soc. Edinburgh 46, 289) on the impulses λ of all contacts.
 *
 * <pre>
 *   g = λ after a round − λ before it        ρ = g·g' / |g'|²        λ += g ρ / (1 − ρ)        g' of the round before
 * </pre>
 *
 * <p>Each round then undoes the same small share 1 − ρ of what is wrong, so rounds alone would need about as many as the ratio
 * of the masses, 10⁶ for 10⁶. The jump is taken only where g and g' are parallel so closely that it is right to a tenth.
 */
final class Extrapolation {
    private static final double ERROR = 0.1; // of a jump, as a share of it

    private double[] before = new double[16]; // λ before the round
    private double[] lastChange = new double[16]; // g'
    private double[] extra = new double[16];
    private double longest; // jump that the masses can explain

    /** Before the first round; all impulses are 0. */
    void begin(Bodies bodies, Touching touching) {
        int size = touching.size();
        if (size > before.length) {
            int capacity = Math.max(size, 2 * before.length);
            before = new double[capacity];
            lastChange = new double[capacity];
            extra = new double[capacity];
        }
        Arrays.fill(before, 0, size, 0);
        Arrays.fill(lastChange, 0, size, 0);
        longest = longest(bodies, touching);
    }

    /** A chain of n equal bodies leaves about 1/n² a round; a heavy body on a light one the ratio of their masses. */
    private static double longest(Bodies bodies, Touching touching) {
        double lightest = 0; // as 1/m
        double heaviest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < touching.size(); k++) {
            double first = bodies.inverseMass(touching.first(k));
            double second = touching.second(k) < 0 ? 0 : bodies.inverseMass(touching.second(k));
            lightest = Math.max(lightest, Math.max(first, second));
            heaviest = Math.min(heaviest, first == 0 ? heaviest : first);
            heaviest = Math.min(heaviest, second == 0 ? heaviest : second);
        }
        return lightest / heaviest * touching.size() * touching.size();
    }

    /**
     * After a round that another will follow.
     *
     * @return whether there is something to gain: then each contact should add its {@link #extra}
     */
    boolean proceed(Touching touching) {
        double jump = jump(touching);
        for (int k = 0; k < touching.size(); k++) {
            double g = touching.impulse(k) - before[k];
            extra[k] = jump * g;
            before[k] = touching.impulse(k) + extra[k];
            lastChange[k] = jump > 0 ? 0 : g; // after a jump two plain rounds must agree anew
        }
        return jump > 0;
    }

    /** ρ / (1 − ρ), or 0 where the changes of two rounds are not parallel enough. */
    private double jump(Touching touching) {
        double gg = 0;
        double gl = 0;
        double ll = 0;
        for (int k = 0; k < touching.size(); k++) {
            double g = touching.impulse(k) - before[k];
            gg += g * g;
            gl += g * lastChange[k];
            ll += lastChange[k] * lastChange[k];
        }
        double ratio = gl / ll;
        double aside = 0; // |g − ρ g'|²
        for (int k = 0; k < touching.size(); k++) {
            double d = touching.impulse(k) - before[k] - ratio * lastChange[k];
            aside += d * d;
        }
        double allowed = ERROR * (1 - ratio);
        boolean isParallel = ratio > 0 && ratio < 1 && aside <= allowed * allowed * gg; // false for NaN
        double jump = ratio / (1 - ratio);
        return isParallel && jump <= longest ? jump : 0;
    }

    double extra(int k) {
        return extra[k];
    }
}
