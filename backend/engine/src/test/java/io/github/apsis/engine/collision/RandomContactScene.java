package io.github.apsis.engine.collision;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.Mobility;
import io.github.apsis.engine.collision.Boundary.HalfPlane;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * A crowd of circles from a seed: masses 1e-6 to 1e6, radii 0.01 to 100, speeds to 10⁴ radii a second, any restitution, any edge, under
 * no force, a uniform field or their own gravity. Some bodies are fixed, some have no mass, some scenes begin with overlaps.
 *
 * <p>Gravity is slow against the tick: no pair could circle at its surface faster than 3 radians a second, and nothing flies farther
 * than a fifth of a radius in a tick. Anything else would test the integrator.
 */
final class RandomContactScene {
    enum Pull {
        NONE,
        FIELD,
        GRAVITY
    }

    private static final double FASTEST = 1e4; // radii / time
    private static final double FASTEST_UNDER_GRAVITY = 30; // radii / time
    private static final double FASTEST_ORBIT = 3; // radians / time

    private final long seed;
    private final Rng rng;
    private final Pull pull;
    private final boolean placedApart;
    private final double lightest;
    private final double heaviest;
    private final double smallest;
    private final double largest;
    private final double fastest;
    private final double fixedShare;
    private final double masslessShare;
    private double field; // length / time²
    private final List<BodyDef> bodies = new ArrayList<>();
    private final WorldSpec spec;

    RandomContactScene(long seed) {
        this.seed = seed;
        rng = new Rng(seed);
        pull = Pull.values()[rng.nextInt(3)];
        placedApart = rng.nextInt(4) > 0;
        lightest = logUniform(1e-6, 1e6);
        heaviest = logUniform(lightest, 1e6);
        smallest = logUniform(0.01, 100);
        largest = logUniform(smallest, 100);
        fastest = logUniform(0.1, pull == Pull.GRAVITY ? FASTEST_UNDER_GRAVITY : FASTEST);
        fixedShare = rng.nextInt(3) == 0 ? 0.2 : 0;
        masslessShare = rng.nextInt(4) == 0 ? 0.2 : 0;
        int count = 2 + rng.nextInt(rng.nextInt(2) == 0 ? 5 : 30);
        double[] radii = new double[count];
        double area = 0;
        for (int i = 0; i < count; i++) {
            radii[i] = logUniform(smallest, largest);
            area += Math.PI * radii[i] * radii[i];
        }
        double half = Math.max(0.5 * Math.sqrt(area / rng.between(0.05, 0.4)), 2.5 * largest);
        for (double radius : radii) {
            place(radius, half);
        }
        spec = spec(half);
    }

    private double logUniform(double from, double to) {
        return from * StrictMath.exp(rng.nextDouble() * StrictMath.log(to / from));
    }

    /** Puts a circle somewhere; where there is no place for it in a hundred trials, it is left out. */
    private void place(double radius, double half) {
        double mass = rng.nextDouble() < masslessShare ? 0 : logUniform(lightest, heaviest);
        boolean fixed = rng.nextDouble() < fixedShare;
        double angle = rng.between(0, 2 * Math.PI);
        double speed = radius * logUniform(0.01, 1) * fastest;
        for (int trial = 0; trial < 100; trial++) {
            BodyDef body = BodyDef.asteroid(
                    rng.between(radius - half, half - radius), rng.between(radius - half, half - radius), mass, radius);
            if (!placedApart || bodies.stream().noneMatch(other -> gap(other, body) < 0)) {
                bodies.add(
                        fixed
                                ? body.fixed()
                                : body.moving(speed * StrictMath.cos(angle), speed * StrictMath.sin(angle)));
                return;
            }
        }
    }

    private static double gap(BodyDef a, BodyDef b) {
        return Math.hypot(a.x() - b.x(), a.y() - b.y()) - a.radius() - b.radius();
    }

    private WorldSpec spec(double half) {
        WorldSpec.Builder laws = WorldSpec.builder().contacts(restitution()).seed(seed);
        Aabb box = Aabb.centred(half, half);
        switch (rng.nextInt(3)) {
            case 0 -> laws.walls(box, restitution());
            case 1 -> laws.periodic(box);
            default -> {
                if (seed % 3 == 0) {
                    laws.halfPlanes(wedge(half), restitution());
                }
            }
        }
        if (pull == Pull.FIELD) {
            field = logUniform(0.01, 100) * half;
            double angle = rng.between(0, 2 * Math.PI);
            laws.law(new UniformField(field * StrictMath.cos(angle), field * StrictMath.sin(angle)));
        } else if (pull == Pull.GRAVITY) {
            laws.gravity(rng.between(0, 1) * FASTEST_ORBIT * FASTEST_ORBIT / densest());
        }
        return laws.build();
    }

    /** Two or three half-planes in any directions, all beyond the square of the births. */
    private List<HalfPlane> wedge(double half) {
        List<HalfPlane> insides = new ArrayList<>();
        for (int k = 2 + rng.nextInt(2); k > 0; k--) {
            double angle = rng.between(0, 2 * Math.PI);
            double c = StrictMath.cos(angle);
            double s = StrictMath.sin(angle);
            insides.add(new HalfPlane(c, s, -half * (Math.abs(c) + Math.abs(s))));
        }
        return insides;
    }

    private double restitution() {
        return switch (rng.nextInt(4)) {
            case 0 -> 0;
            case 1 -> 1;
            default -> rng.nextDouble();
        };
    }

    /** Of all pairs, (m1 + m2) / (r1 + r2)³. */
    private double densest() {
        double densest = 1e-13; // less than any two bodies with mass here
        for (BodyDef a : bodies) {
            for (BodyDef b : bodies) {
                double size = a.radius() + b.radius();
                densest = Math.max(densest, (a.mass() + b.mass()) / (size * size * size));
            }
        }
        return densest;
    }

    World world() {
        World world = new World(spec);
        bodies.forEach(world::add);
        return world;
    }

    Pull pull() {
        return pull;
    }

    /** The acceleration of the field, length / time²; 0 without. */
    double field() {
        return field;
    }

    WorldSpec spec() {
        return spec;
    }

    /** Whether no circle began inside another, in a periodic world also across the seam. */
    boolean bornApart() {
        return Depth.ofPairs(world().snapshot(), spec.boundary()) == 0;
    }

    /** A periodic world with forces has no potential: a place is known up to a period only. */
    boolean hasEnergy() {
        return pull == Pull.NONE || !isPeriodic();
    }

    boolean isPeriodic() {
        return spec.boundary() instanceof Boundary.Periodic;
    }

    boolean isFixed(int i) {
        return bodies.get(i).mobility() == Mobility.FIXED;
    }

    /** Others do not feel a body without mass, so nothing keeps two of them from squeezing it. */
    boolean canBeSqueezed(int i) {
        return bodies.get(i).mass() == 0 && !isFixed(i);
    }

    /** Σ G m1 m2 / (r1 + r2): the depth of all potentials at the surfaces. */
    double surfacePotential() {
        return gravityOverSize(1);
    }

    /** Σ G m1 m2 / (r1 + r2)²: all pulls at the surfaces. */
    double surfacePull() {
        return gravityOverSize(2);
    }

    private double gravityOverSize(int power) {
        double sum = 0;
        for (int i = 0; i < bodies.size(); i++) {
            for (int j = 0; j < i; j++) {
                BodyDef a = bodies.get(i);
                BodyDef b = bodies.get(j);
                sum += spec.gravity() * a.mass() * b.mass() / Math.pow(a.radius() + b.radius(), power);
            }
        }
        return sum;
    }

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT,
                "seed %d: %d bodies, %s, %s, e = %.3f, m = %.1e … %.1e, r = %.2g … %.2g, v to %.2g radii/s%s%s%s",
                seed,
                bodies.size(),
                pull,
                spec.boundary().getClass().getSimpleName(),
                spec.restitution().orElseThrow(),
                lightest,
                heaviest,
                smallest,
                largest,
                fastest,
                placedApart ? "" : ", born in each other",
                fixedShare > 0 ? ", some fixed" : "",
                masslessShare > 0 ? ", some without mass" : "");
    }
}
