package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;

/**
 * The last word of a wall: no centre ends a tick beyond it. Contacts keep rims inside at any speed that a tick can resolve; where
 * they have given up, after 128 impacts of one body in a tick, the body is put at the wall and loses its speed towards it. What
 * that takes is booked.
 */
final class WallStop {
    private final WallSet walls;

    WallStop(WallSet walls) {
        this.walls = walls;
    }

    /** The same where nothing but bends has changed paths that were looked along before, to the walls and a little beyond. */
    void stopBent(Bodies bodies, Paths paths) {
        for (int k = 0; k < paths.bentCount(); k++) {
            if (!walls.contains(bodies, paths.bent(k), 0)) {
                stop(bodies, paths.dt()); // seldom: all of them, in the order of their slots
                return;
            }
        }
    }

    void stop(Bodies bodies, double dt) {
        for (int i = 0; i < bodies.count(); i++) {
            if (walls.contains(bodies, i, 0) || bodies.isFixed(i)) {
                continue;
            }
            for (int wall = -1; wall > walls.end(); wall--) {
                double gap = walls.gap(wall, bodies.x(i), bodies.y(i), bodies.radius(i));
                if (gap < -bodies.radius(i)) {
                    stop(bodies, i, wall, gap, 0.5 * dt);
                }
            }
        }
    }

    private void stop(Bodies bodies, int i, int wall, double gap, double untilEnd) {
        double nx = walls.normalX(wall);
        double ny = walls.normalY(wall);
        double m = bodies.mass(i);
        double an = bodies.ax(i) * nx + bodies.ay(i) * ny;
        bodies.ledger().bookEnergy(m * gap * an); // moved by −gap against the forces
        bodies.ledger().bookAngularMomentum(-m * gap * (nx * bodies.vy(i) - ny * bodies.vx(i)));
        bodies.shift(i, -gap * nx, -gap * ny);
        double vn = bodies.vx(i) * nx + bodies.vy(i) * ny;
        if (vn < 0) {
            bodies.ledger().bookEnergy(-m * vn * (0.5 * vn + untilEnd * an));
            bodies.ledger().bookImpulse(-m * vn * nx, -m * vn * ny, bodies.x(i), bodies.y(i));
            bodies.push(i, -vn * nx, -vn * ny);
        }
    }
}
