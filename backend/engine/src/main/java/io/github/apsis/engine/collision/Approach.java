package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;

/** How two partners meet at a time within the tick: the geometry of their contact, and how fast they close. */
final class Approach {
    /** A closing speed below this share of the speeds it is the difference of is rounding. */
    private static final double ROUNDING = 1e-12;

    /** The same where it was found in another way, and a path may be many radii long. */
    private static final double DOUBT = 1e-8;

    /** Sums and squares may round to either side. */
    private static final double SURELY = 1 - 1e-12;

    private final Paths paths;
    private final ContactGeometry contact;
    private final Touching touching;
    private final ContactMode mode;
    private double closingRate;
    private double closingSpeed; // length / time, negative when they separate

    Approach(Paths paths, ContactGeometry contact, Touching touching, ContactMode mode) {
        this.paths = paths;
        this.contact = contact;
        this.touching = touching;
        this.mode = mode;
    }

    /** Fills in normal and gap of a body and its partner, a body or a wall, at time t. */
    void locate(Bodies bodies, int a, int b, double t) {
        double xb = b < 0 ? 0 : paths.xAt(bodies, b, t);
        double yb = b < 0 ? 0 : paths.yAt(bodies, b, t);
        contact.fill(bodies, a, paths.xAt(bodies, a, t), paths.yAt(bodies, a, t), b, xb, yb);
    }

    /** The same, and the closing speed. */
    void measure(Bodies bodies, int a, int b, double t) {
        locate(bodies, a, b, t);
        double wx = (b < 0 ? 0 : paths.vxAt(bodies, b, t)) - paths.vxAt(bodies, a, t);
        double wy = (b < 0 ? 0 : paths.vyAt(bodies, b, t)) - paths.vyAt(bodies, a, t);
        closingSpeed = -(wx * contact.nx + wy * contact.ny);
    }

    /**
     * The same without the gap, with the normal from where an impulse at time t acts in the integrator's own steps: straight back from the end
     * of the path. With it the two impulses of a contact have no moment, and angular momentum stays; without forces, and where
     * these act along the line of centres, it is the line of centres itself. Exact contacts have the line of centres always.
     */
    void measureImpact(Bodies bodies, int a, int b, double t) {
        if (b < 0 || mode == ContactMode.EXACT) {
            measure(bodies, a, b, t);
        } else {
            double left = paths.dt() - t;
            contact.fillLine(
                    bodies,
                    a,
                    b,
                    bodies.x(b) - bodies.vx(b) * left - (bodies.x(a) - bodies.vx(a) * left),
                    bodies.y(b) - bodies.vy(b) * left - (bodies.y(a) - bodies.vy(a) * left));
        }
        double wx = (b < 0 ? 0 : paths.vxAt(bodies, b, t)) - paths.vxAt(bodies, a, t);
        double wy = (b < 0 ? 0 : paths.vyAt(bodies, b, t)) - paths.vyAt(bodies, a, t);
        closingSpeed = -(wx * contact.nx + wy * contact.ny);
        double lineX = contact.lineX;
        double lineY = contact.lineY;
        closingRate = -(wx * lineX + wy * lineY) / (lineX * lineX + lineY * lineY);
    }

    /** The closing velocity as a share of the line of the contact, which {@link #measureImpact} filled in; 1 / time. */
    double closingRate() {
        return closingRate;
    }

    ContactGeometry contact() {
        return contact;
    }

    double closingSpeed() {
        return closingSpeed;
    }

    /**
     * Whether the partners close no faster than the forces push them together in two ticks, or as the {@link ContactMode}
     * says: that is rest, not a bounce. Two bodies that fall side by side are not pushed together; one that lies on something is,
     * by as much as that bears of its fall.
     */
    boolean isGentle(Bodies bodies, int a, int b) {
        return isGentle(bodies, a, b, contact, closingSpeed, mode.restingTicks());
    }

    /** Whether two bodies that close so fast bounce whatever their normal is, when no body is accelerated more. */
    boolean isSurelyBounce(Bodies bodies, int a, int b, double closing, double mostAcceleration) {
        double pressed = 2 * mostAcceleration * paths.dt();
        double borne = Math.max(touching.support(a), touching.support(b));
        return closing > mode.restingTicks() * pressed + 2 * borne + DOUBT * speeds(bodies, a, b);
    }

    /** Whether two bodies move past each other so slowly all through the tick that no normal could make their contact a bounce. */
    boolean isGentleAlways(Bodies bodies, int a, int b) {
        double wx = Math.abs(bodies.vx(b) - bodies.vx(a));
        double wy = Math.abs(bodies.vy(b) - bodies.vy(a));
        double bx = Math.abs(Paths.accelerationX(bodies, b) - Paths.accelerationX(bodies, a));
        double by = Math.abs(Paths.accelerationY(bodies, b) - Paths.accelerationY(bodies, a));
        double most = wx + wy + 0.5 * paths.dt() * (bx + by);
        return most * most <= SURELY * 4 * Math.max(touching.supportSquared(a), touching.supportSquared(b));
    }

    /** The separating speed that the forces have used up after so long: with it, what comes to rest ends the tick where it lies. */
    double hop(Bodies bodies, int a, int b, double left) {
        return 0.5 * Math.max(0, -contact.separatingAcceleration(bodies, a, b)) * left;
    }

    /** Whether two partners, as they are at the end of a tick, close no faster than in two ticks. */
    boolean isGentleNow(Bodies bodies, int a, int b, ContactGeometry now) {
        return isGentle(bodies, a, b, now, now.closingSpeed(bodies, a, b), ContactMode.TICK.restingTicks());
    }

    private boolean isGentle(Bodies bodies, int a, int b, ContactGeometry at, double closing, double ticks) {
        double pressed = Math.max(0, -at.separatingAcceleration(bodies, a, b)) * paths.dt();
        double borne = Math.max(touching.support(a), touching.support(b));
        return closing <= Math.max(ticks * pressed, 2 * borne) + ROUNDING * speeds(bodies, a, b);
    }

    private static double speeds(Bodies bodies, int a, int b) {
        double speed = Math.abs(bodies.vx(a)) + Math.abs(bodies.vy(a));
        return b < 0 ? speed : speed + Math.abs(bodies.vx(b)) + Math.abs(bodies.vy(b));
    }
}
