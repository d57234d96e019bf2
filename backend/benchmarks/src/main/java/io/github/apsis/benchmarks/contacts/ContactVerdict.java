package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.engine.body.BodyDef;
import java.util.Locale;

/** What to say of a run: {@code ok}, or what is outside its tolerance, by the rules of the reference format. */
final class ContactVerdict {
    static final String OK = "ok";
    static final String OUTSIDE = "outside tolerance: ";
    static final String FAILED = "failed: ";
    static final String SKIPPED = "skipped: ";

    private static final double MOMENTUM_KEPT = 1e-14;
    private static final double MOMENTUM_KEPT_BY_TICKS = 1e-15; // times the root of their number: a walk of roundings
    private static final double ENERGY_KEPT = 1e-13;
    private static final double HEAD_ON = 1e-12;

    private ContactVerdict() {}

    static String of(ContactCase known, ContactMode mode, ContactErrors errors, double dt) {
        if (!errors.finite()) {
            return FAILED + "a body is lost, or no number any more";
        }
        boolean swings = mode == ContactMode.TICK && known.g() != 0; // as any symplectic method under gravity does
        String broken = always(known, errors, swings, mode == ContactMode.TICK ? walked(known, dt) : MOMENTUM_KEPT);
        if (broken.isEmpty()) {
            broken = mode == ContactMode.EXACT ? exact(errors) : tick(known, errors, dt);
        }
        return broken.isEmpty() ? OK : OUTSIDE + broken;
    }

    static boolean isBad(String status) {
        return status.startsWith(OUTSIDE) || status.startsWith(FAILED);
    }

    private static String always(ContactCase known, ContactErrors errors, boolean energySwings, double momentum) {
        if (!(errors.momentum() <= momentum)) {
            return compared("momentum", errors.momentum(), momentum);
        }
        if (energySwings) {
            return "";
        }
        if (!(errors.energyGain() <= ENERGY_KEPT)) {
            return compared("energy gained", errors.energyGain(), ENERGY_KEPT);
        }
        if (known.isElastic() && !(Math.abs(errors.energyChange()) <= ENERGY_KEPT)) {
            return compared("energy", Math.abs(errors.energyChange()), ENERGY_KEPT);
        }
        return "";
    }

    private static double walked(ContactCase known, double dt) {
        return Math.max(MOMENTUM_KEPT, MOMENTUM_KEPT_BY_TICKS * Math.sqrt(known.end() / dt));
    }

    // --- exact contacts: everything as the case says ---

    private static String exact(ContactErrors errors) {
        EventOrder order = errors.order();
        if (!order.oddity().isEmpty()) {
            return order.oddity();
        }
        if (order.time().isBeyond()) {
            return order.time().complaint("time of a bounce");
        }
        if (errors.position().isBeyond()) {
            return errors.position().complaint("position");
        }
        return errors.velocities().isBeyond() ? errors.velocities().complaint("velocity") : "";
    }

    // --- contacts by ticks: what the format asks of pairs, bullets and drops ---

    private static String tick(ContactCase known, ContactErrors errors, double dt) {
        boolean free = known.g() == 0 && known.fieldX() == 0 && known.fieldY() == 0;
        if (known.bodies().size() == 2 && known.walls().isEmpty() && free) {
            return pair(known, errors, dt);
        }
        return drop(known, errors, dt);
    }

    /** A pair must hit or miss as it should, and leave as it should: exactly head-on, else by the normal of some other moment. */
    private static String pair(ContactCase known, ContactErrors errors, double dt) {
        if (!errors.order().oddity().isEmpty()) {
            return errors.order().oddity();
        }
        double limit = normalIsOff(known, dt);
        return errors.velocity().largest() > limit
                ? compared("velocity", errors.velocity().largest(), limit)
                : "";
    }

    /**
     * The normal of a discrete contact is off by up to |v| dt / (r₁ + r₂), and the impulse of up to (1 + e) |v| per unit of mass
     * is turned by that; 1e-12 where the velocity is along the line of centres.
     */
    private static double normalIsOff(ContactCase known, double dt) {
        BodyDef a = known.bodies().get(0);
        BodyDef b = known.bodies().get(1);
        double dx = b.x() - a.x();
        double dy = b.y() - a.y();
        double dvx = b.vx() - a.vx();
        double dvy = b.vy() - a.vy();
        double speed = Math.hypot(dvx, dvy);
        boolean headOn = Math.abs(dx * dvy - dy * dvx) <= HEAD_ON * Math.hypot(dx, dy) * speed;
        double turned = Math.min(Math.PI, speed * dt / (a.radius() + b.radius()));
        return headOn ? HEAD_ON : (1 + known.restitution()) * speed * turned / known.velocityScale();
    }

    /** Apex n within (1 + n) |v| dt of the true height, v the speed at the first bounce, and none above the one before. */
    private static String drop(ContactCase known, ContactErrors errors, double dt) {
        double[] heights = errors.apexHeights();
        double fastest = known.events().isEmpty() ? 0 : known.events().get(0).closingSpeed();
        double before = Double.POSITIVE_INFINITY;
        for (int n = 1; n <= heights.length; n++) {
            double height = heights[n - 1];
            double limit = (1 + n) * fastest * dt;
            if (Math.abs(height - known.apexHeights()[n - 1]) > limit) {
                return compared("apex " + n, Math.abs(height - known.apexHeights()[n - 1]), limit);
            }
            if (height > before * (1 + ENERGY_KEPT)) {
                return "apex " + n + " is above the one before: " + Cells.figure(height) + " > " + Cells.figure(before);
            }
            before = Double.isNaN(height) ? before : height;
        }
        return "";
    }

    private static String compared(String what, double error, double limit) {
        return String.format(Locale.ROOT, "%s %.1e > %.1e", what, error, limit);
    }
}
