package io.github.apsis.engine.stepping;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.collision.ClosingGap;
import io.github.apsis.engine.collision.ContactSet;
import io.github.apsis.engine.collision.WallSet;
import io.github.apsis.engine.integration.DensePath;
import io.github.apsis.engine.integration.TaylorStep;
import org.jspecify.annotations.Nullable;

/**
 * The first contact on the paths of a step: each pair by the search of {@link ClosingGap}, with the acceleration that the sum of
 * the coefficients of its path cannot exceed. A search that comes close to something it does not meet ends there, and goes on
 * from a series about that moment.
 */
final class FirstContact {
    private final @Nullable WallSet walls;
    private final ContactSet overlapping;
    private final DensePath path;
    private double[] most = new double[0]; // acceleration of each body in the step

    private double time;

    FirstContact(@Nullable WallSet walls, DensePath scratch) {
        this.walls = walls;
        this.overlapping = new ContactSet(walls);
        this.path = scratch;
    }

    /**
     * Looks along a step that has just begun. What is found is a time until which nothing meets but those that are held together;
     * mostly the time of a contact.
     *
     * @return infinity when nothing meets in the whole step
     */
    double find(Bodies bodies, TaylorStep step, ContactSet held) {
        time = Double.POSITIVE_INFINITY;
        overlapping.clear();
        boundAccelerations(bodies, step);
        for (int i = 0; i < bodies.count(); i++) {
            if (walls != null && !bodies.isFixed(i)) {
                findWalls(bodies, step, held, walls, i);
            }
            for (int j = i + 1; j < bodies.count(); j++) {
                if (mayMeet(bodies, i, j, Math.min(time, step.length()))) {
                    findPair(bodies, step, held, i, j);
                }
            }
        }
        return time;
    }

    /** Partners that overlap at the beginning of the step, be it by rounding. */
    ContactSet overlapping() {
        return overlapping;
    }

    private void boundAccelerations(Bodies bodies, TaylorStep step) {
        if (most.length < bodies.count()) {
            most = new double[2 * bodies.count()];
        }
        for (int i = 0; i < bodies.count(); i++) {
            step.copyPath(i, path);
            most[i] = path.mostAcceleration(step.length());
        }
    }

    /** What most pairs fail at: their gap at the end of the search would be open even under the largest accelerations. */
    private boolean mayMeet(Bodies bodies, int i, int j, double until) {
        double radii = bodies.radius(i) + bodies.radius(j);
        if (radii == 0 || bodies.isFixed(i) && bodies.isFixed(j)) {
            return false; // points never touch, and their contact would have no normal
        }
        double dx = bodies.x(j) - bodies.x(i);
        double dy = bodies.y(j) - bodies.y(i);
        double distance = Math.sqrt(dx * dx + dy * dy);
        double rate = (dx * (bodies.vx(j) - bodies.vx(i)) + dy * (bodies.vy(j) - bodies.vy(i))) / distance;
        double gap = distance - radii;
        double left = gap + until * (rate - 0.5 * (most[i] + most[j]) * until);
        return !(gap > 1e-9 * distance && left > 1e-9 * distance);
    }

    private void findPair(Bodies bodies, TaylorStep step, ContactSet held, int i, int j) {
        double radii = bodies.radius(i) + bodies.radius(j);
        step.copyPath(i, j, path);
        path.lookAt(0);
        if (path.x() * path.x() + path.y() * path.y() < radii * radii) {
            overlapping.add(i, j);
        }
        if (held.contains(i, j)) {
            return;
        }
        double horizon = Math.min(time, step.length());
        double acceleration = path.mostAcceleration(horizon);
        double t = 0;
        for (int look = 0; look < ClosingGap.MOST_LOOKS; look++) {
            path.lookAt(t);
            double distance = Math.sqrt(path.x() * path.x() + path.y() * path.y());
            double rate = distance > 0 ? (path.x() * path.vx() + path.y() * path.vy()) / distance : path.vx();
            double next = ClosingGap.next(t, distance - radii, rate, acceleration, radii);
            if (!(next < horizon)) {
                return;
            }
            if (next == t) {
                break;
            }
            t = next;
        }
        time = t;
    }

    private void findWalls(Bodies bodies, TaylorStep step, ContactSet held, WallSet set, int i) {
        boolean copied = false;
        for (int wall = -1; wall > set.end(); wall--) {
            double horizon = Math.min(time, step.length());
            double gap = set.gap(wall, bodies.x(i), bodies.y(i), bodies.radius(i));
            double rate = set.normalX(wall) * bodies.vx(i) + set.normalY(wall) * bodies.vy(i);
            if (gap < 0) {
                overlapping.add(i, wall);
            }
            double left = gap + horizon * (rate - 0.5 * most[i] * horizon);
            double doubt = 1e-9 * (bodies.radius(i) + Math.abs(bodies.x(i)) + Math.abs(bodies.y(i)));
            if (gap > doubt && left > doubt || held.contains(i, wall)) {
                continue;
            }
            if (!copied) {
                step.copyPath(i, path);
                copied = true;
            }
            findWall(set, wall, bodies.radius(i), horizon, most[i]);
        }
    }

    private void findWall(WallSet set, int wall, double radius, double horizon, double acceleration) {
        double t = 0;
        for (int look = 0; look < ClosingGap.MOST_LOOKS; look++) {
            path.lookAt(t);
            double rate = set.normalX(wall) * path.vx() + set.normalY(wall) * path.vy();
            double size = radius + Math.abs(path.x()) + Math.abs(path.y());
            double next = ClosingGap.next(t, set.gap(wall, path.x(), path.y(), radius), rate, acceleration, size);
            if (!(next < horizon)) {
                return;
            }
            if (next == t) {
                break;
            }
            t = next;
        }
        time = t;
    }
}
