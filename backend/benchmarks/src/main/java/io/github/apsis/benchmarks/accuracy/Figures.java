package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.math.Aabb;

/** What can be read off a snapshot. */
final class Figures {
    private Figures() {}

    static double speed(WorldSnapshot now, int i) {
        return Math.hypot(now.vx(i), now.vy(i));
    }

    static double fastest(WorldSnapshot now) {
        double fastest = 0;
        for (int i = 0; i < now.count(); i++) {
            fastest = Math.max(fastest, speed(now, i));
        }
        return fastest;
    }

    static double momentumX(WorldSnapshot now) {
        double sum = 0;
        for (int i = 0; i < now.count(); i++) {
            sum += now.mass(i) * now.vx(i);
        }
        return sum;
    }

    static double momentumY(WorldSnapshot now) {
        double sum = 0;
        for (int i = 0; i < now.count(); i++) {
            sum += now.mass(i) * now.vy(i);
        }
        return sum;
    }

    static double kineticEnergy(WorldSnapshot now) {
        double sum = 0;
        for (int i = 0; i < now.count(); i++) {
            sum += 0.5 * now.mass(i) * (now.vx(i) * now.vx(i) + now.vy(i) * now.vy(i));
        }
        return sum;
    }

    /** The deepest overlap of two bodies, or of one with a floor at y = 0, length. */
    static double overlap(WorldSnapshot now, boolean hasFloor) {
        double deepest = 0;
        for (int i = 0; i < now.count(); i++) {
            if (hasFloor) {
                deepest = Math.max(deepest, now.radius(i) - now.y(i));
            }
            for (int j = i + 1; j < now.count(); j++) {
                double gap = Math.hypot(now.x(j) - now.x(i), now.y(j) - now.y(i)) - now.radius(i) - now.radius(j);
                deepest = Math.max(deepest, -gap);
            }
        }
        return deepest;
    }

    static boolean allInside(WorldSnapshot now, Aabb box) {
        for (int i = 0; i < now.count(); i++) {
            if (!box.contains(now.x(i), now.y(i))) {
                return false;
            }
        }
        return true;
    }
}
