package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * The bounces of a tick, each at its true time and with its true normal, in the order of their times.
 *
 * <p>An impulse j = (1+e) c / (1/m1 + 1/m2) along the line of centres turns the closing speed c into e c. Both paths bend
 * there, so both bodies look for their next partner from there on. A contact whose closing speed is no more than what the
 * forces give in two ticks is no bounce but a contact at rest, and left to {@link RestingContacts}.
 */
final class Impacts {
    /**
     * A body that is hit more often in one tick is in a collapse (e &lt; 1: infinitely many bounces in finite time) or a
     * bullet in a box. From then on its contacts of this tick are inelastic, and after as many again they are at rest.
     */
    private static final int MOST_BOUNCES_PER_BODY = 64;

    /** A closing speed below this share of the speeds it is the difference of is rounding. */
    private static final double ROUNDING = 1e-12;

    private final double restitution;
    private final double wallRestitution;
    private final @Nullable BroadPhase broadPhase;
    private final @Nullable WallSet walls;
    private final @Nullable Period period;
    private final Paths paths;
    private final Touching touching;
    private final ContactGeometry contact;
    private final ImpactQueue queue = new ImpactQueue();

    private int bentCount;
    private int[] bent = new int[16]; // bodies whose path is no longer the one in the tree
    private double closingSpeed;

    Impacts(
            double restitution,
            double wallRestitution,
            @Nullable BroadPhase broadPhase,
            @Nullable WallSet walls,
            @Nullable Period period,
            Paths paths,
            Touching touching) {
        this.restitution = restitution;
        this.wallRestitution = wallRestitution;
        this.broadPhase = broadPhase;
        this.walls = walls;
        this.period = period;
        this.paths = paths;
        this.touching = touching;
        this.contact = new ContactGeometry(walls, period);
    }

    /** Resolves all bounces of the tick; fills the list of contacts at rest. */
    void resolve(Bodies bodies) {
        queue.clear();
        touching.clear();
        bentCount = 0;
        predictAll(bodies);
        while (!queue.isEmpty()) {
            double t = queue.time();
            int a = queue.first();
            int b = queue.second();
            boolean current = queue.firstVersion() == paths.impacts(a) && queue.secondVersion() == version(b);
            queue.pop();
            if (current) { // otherwise it was predicted anew when the path was bent
                bounce(bodies, a, b, t);
            }
        }
    }

    private void predictAll(Bodies bodies) {
        for (int i = 0; i < bodies.count(); i++) {
            predictWalls(bodies, i);
        }
        if (broadPhase != null) {
            broadPhase.build(bodies, paths);
            for (int i = 0; i < bodies.count(); i++) {
                int hits = broadPhase.findNear(bodies, paths, i);
                for (int hit = 0; hit < hits; hit++) {
                    if (broadPhase.near(hit) > i) {
                        predict(bodies, i, broadPhase.near(hit));
                    }
                }
            }
        }
    }

    private int mostImpacts(int a, int b) {
        return Math.max(paths.impacts(a), version(b));
    }

    private int version(int partner) {
        return partner < 0 ? 0 : paths.impacts(partner);
    }

    private void predictWalls(Bodies bodies, int i) {
        if (walls == null || walls.contains(bodies, i) || bodies.isFixed(i)) {
            return;
        }
        double t0 = paths.startTime(i);
        double r = bodies.radius(i);
        for (int wall = WallSet.LEFT; wall >= WallSet.TOP; wall--) {
            double gap0 = walls.gap(wall, paths.startX(i), paths.startY(i), r);
            double gap1 = walls.gap(wall, bodies.x(i), bodies.y(i), r);
            if (gap1 > 0) {
                continue;
            }
            double inwards = Paths.accelerationX(bodies, i) * WallSet.normalX(wall)
                    + Paths.accelerationY(bodies, i) * WallSet.normalY(wall);
            double t = TimeOfImpact.ofWall(gap0, gap1, inwards, t0, paths.dt());
            enqueue(bodies, i, wall, t);
        }
    }

    private void predict(Bodies bodies, int a, int b) {
        double t0 = Math.max(paths.startTime(a), paths.startTime(b));
        double d0x = paths.xAt(bodies, b, t0) - paths.xAt(bodies, a, t0);
        double d0y = paths.yAt(bodies, b, t0) - paths.yAt(bodies, a, t0);
        double d1x = bodies.x(b) - bodies.x(a);
        double d1y = bodies.y(b) - bodies.y(a);
        if (period != null) {
            double shiftX = period.nearestX(d0x) - d0x;
            double shiftY = period.nearestY(d0y) - d0y;
            d0x += shiftX;
            d0y += shiftY;
            d1x += shiftX;
            d1y += shiftY;
        }
        double sumOfRadii = bodies.radius(a) + bodies.radius(b);
        double bx = Paths.accelerationX(bodies, b) - Paths.accelerationX(bodies, a);
        double by = Paths.accelerationY(bodies, b) - Paths.accelerationY(bodies, a);
        double t = TimeOfImpact.ofCircles(d0x, d0y, d1x, d1y, bx, by, t0, paths.dt(), sumOfRadii);
        if (Double.isNaN(t)) {
            if (d1x * d1x + d1y * d1y < sumOfRadii * sumOfRadii) {
                measure(bodies, a, b, t0); // born inside each other, or pressed together: separating, but not yet apart
                touching.add(a, b, contact);
            }
            return;
        }
        enqueue(bodies, a, b, t);
    }

    /** Queues a bounce at time t, or lists a contact at rest; NaN for a body that is beyond a wall and on its way back. */
    private void enqueue(Bodies bodies, int a, int b, double t) {
        measure(bodies, a, b, Double.isNaN(t) ? paths.startTime(a) : t);
        if (contact.inverseMass == 0) {
            return; // two fixed bodies
        }
        double pressedPerTick = Math.max(0, -contact.separatingAcceleration(bodies, a, b)) * paths.dt();
        boolean gentle = closingSpeed <= 2 * pressedPerTick + ROUNDING * speeds(bodies, a, b);
        if (Double.isNaN(t) || gentle || mostImpacts(a, b) >= 2 * MOST_BOUNCES_PER_BODY) {
            touching.add(a, b, contact);
        } else {
            queue.push(t, a, b, paths.impacts(a), version(b));
        }
    }

    /** Fills in the normal and the closing speed of two partners at time t. */
    private void measure(Bodies bodies, int a, int b, double t) {
        double xb = b < 0 ? 0 : paths.xAt(bodies, b, t);
        double yb = b < 0 ? 0 : paths.yAt(bodies, b, t);
        contact.fill(bodies, a, paths.xAt(bodies, a, t), paths.yAt(bodies, a, t), b, xb, yb);
        double wx = (b < 0 ? 0 : paths.vxAt(bodies, b, t)) - paths.vxAt(bodies, a, t);
        double wy = (b < 0 ? 0 : paths.vyAt(bodies, b, t)) - paths.vyAt(bodies, a, t);
        closingSpeed = -(wx * contact.nx + wy * contact.ny);
    }

    private static double speeds(Bodies bodies, int a, int b) {
        double speed = Math.abs(bodies.vx(a)) + Math.abs(bodies.vy(a));
        return b < 0 ? speed : speed + Math.abs(bodies.vx(b)) + Math.abs(bodies.vy(b));
    }

    private void bounce(Bodies bodies, int a, int b, double t) {
        measure(bodies, a, b, t);
        boolean collapsed = mostImpacts(a, b) >= MOST_BOUNCES_PER_BODY;
        double e = collapsed ? 0 : b < 0 ? wallRestitution : restitution;
        double impulse = (1 + e) * closingSpeed / contact.inverseMass;
        bookWork(bodies, a, b, t, impulse);
        double px = impulse * contact.nx;
        double py = impulse * contact.ny;
        bend(bodies, a, t, -px, -py);
        if (b >= 0) {
            bend(bodies, b, t, px, py);
        }
        bookOutside(bodies, a, b, px, py);
        predictNext(bodies, a, b);
        if (b >= 0) {
            predictNext(bodies, b, a);
            predict(bodies, a, b);
        }
    }

    /**
     * Books what a bounce takes, −(1 − e²) c² / (2 (1/m1 + 1/m2)). Thrust books its own work by kicks at the two ends of the
     * tick, so the speed that it has added or not yet added by now is none of the bounce's.
     */
    private void bookWork(Bodies bodies, int a, int b, double t, double impulse) {
        double thrustX = -bodies.thrustX(a) * bodies.inverseMass(a);
        double thrustY = -bodies.thrustY(a) * bodies.inverseMass(a);
        if (b >= 0) {
            thrustX += bodies.thrustX(b) * bodies.inverseMass(b);
            thrustY += bodies.thrustY(b) * bodies.inverseMass(b);
        }
        double byThrust = (thrustX * contact.nx + thrustY * contact.ny) * (t - 0.5 * paths.dt());
        bodies.ledger().bookEnergy(impulse * (0.5 * impulse * contact.inverseMass - closingSpeed - byThrust));
    }

    /** An impulse on a wall or on a fixed body leaves the world. */
    static void bookOutside(Bodies bodies, int a, int b, double px, double py) {
        if (b < 0 || bodies.isFixed(b)) {
            bodies.ledger().bookMomentum(-px, -py);
        } else if (bodies.isFixed(a)) {
            bodies.ledger().bookMomentum(px, py);
        }
    }

    private void bend(Bodies bodies, int i, double t, double px, double py) {
        if (bodies.isFixed(i)) {
            return;
        }
        if (paths.impacts(i) == 0) {
            if (bentCount == bent.length) {
                bent = Arrays.copyOf(bent, 2 * bentCount);
            }
            bent[bentCount++] = i;
        }
        paths.bend(bodies, i, t, px * bodies.inverseMass(i), py * bodies.inverseMass(i));
    }

    private void predictNext(Bodies bodies, int i, int partner) {
        if (bodies.isFixed(i)) {
            return;
        }
        predictWalls(bodies, i);
        if (broadPhase == null) {
            return;
        }
        int hits = broadPhase.findNear(bodies, paths, i);
        for (int hit = 0; hit < hits; hit++) {
            int other = broadPhase.near(hit);
            if (other != i && other != partner && paths.impacts(other) == 0) {
                predict(bodies, Math.min(i, other), Math.max(i, other));
            }
        }
        // The tree knows bent paths only as they were, so those few are asked one by one.
        for (int k = 0; k < bentCount; k++) {
            int other = bent[k];
            if (other != i && other != partner) {
                predict(bodies, Math.min(i, other), Math.max(i, other));
            }
        }
    }
}
