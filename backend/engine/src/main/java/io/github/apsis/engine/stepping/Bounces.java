package io.github.apsis.engine.stepping;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.collision.ContactListener;
import io.github.apsis.engine.collision.ContactSet;
import io.github.apsis.engine.collision.WallSet;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * What happens at the instant of a contact.
 *
 * <p>All contacts that close at this instant bounce together, each by Newton's rule w' = −e w, so that what is symmetric stays
 * so. Where that makes a neighbour close which touches already, as in a row of balls, it bounces next, at the same time, and so
 * the wave runs through. What closes too gently to bounce comes to rest.
 */
final class Bounces {
    /** Partners this near each other, in units of their size, touch: what differs by rounding is one instant. */
    private static final double TOUCHING = 1e-12;

    /**
     * A body that bounces more often in one tick is in a collapse: with e &lt; 1 infinitely many bounces may take a finite time.
     * From then on its contacts of this tick are inelastic; without loss there is no collapse, only a bullet in a box.
     */
    private static final int MOST_BOUNCES = 1000;

    /** After so many waves through bodies that touch, at one instant, they are inelastic. */
    private static final int MOST_WAVES = 1000;

    private final ContactSet touching;
    private final HeldContacts held;
    private final Pressing pressing;
    private final @Nullable WallSet walls;
    private final double restitution;
    private final double wallRestitution;

    private @Nullable ContactListener listener;
    private double[] gentle = new double[16]; // speed of each contact below which it is at rest
    private int[] bounces = new int[0]; // of each body in this tick
    private boolean[] struck = new boolean[0]; // at this instant

    Bounces(
            ContactSet scratch,
            HeldContacts held,
            Pressing pressing,
            @Nullable WallSet walls,
            double restitution,
            double wallRestitution) {
        this.touching = scratch;
        this.held = held;
        this.pressing = pressing;
        this.walls = walls;
        this.restitution = restitution;
        this.wallRestitution = wallRestitution;
    }

    void onBounce(ContactListener newListener) {
        listener = newListener;
    }

    void beginTick(Bodies bodies) {
        if (bounces.length < bodies.count()) {
            bounces = new int[2 * bodies.count()];
            struck = new boolean[2 * bodies.count()];
        }
        Arrays.fill(bounces, 0, bodies.count(), 0);
    }

    /**
     * Resolves all contacts of an instant.
     *
     * @param t of the instant in the step
     * @param time since the world began
     * @param left of the tick
     * @return whether what is held began to hop anew
     */
    boolean resolve(Bodies bodies, double t, double time, double left) {
        Arrays.fill(struck, 0, bodies.count(), false);
        gather(bodies, t);
        int wave = 0;
        while (bounceClosing(bodies, time)) {
            if (wave++ == MOST_WAVES) {
                stopAll(bodies);
                break;
            }
        }
        boolean changed = held.release(bodies, struck, t, left);
        touching.measure(bodies);
        for (int k = 0; k < touching.size(); k++) {
            if (touching.separatingSpeed(k) <= gentle[k]) {
                changed |= held.add(touching.first(k), touching.second(k));
            }
        }
        if (changed) {
            held.hold(bodies, t, left);
        }
        return changed;
    }

    private void gather(Bodies bodies, double t) {
        touching.clear();
        for (int i = 0; i < bodies.count(); i++) {
            if (walls != null && !bodies.isFixed(i)) {
                for (int wall = -1; wall > walls.end(); wall--) {
                    gather(bodies, i, wall, t);
                }
            }
            for (int j = i + 1; j < bodies.count(); j++) {
                if (isNear(bodies, i, j)) {
                    gather(bodies, i, j, t);
                }
            }
        }
    }

    private static boolean isNear(Bodies bodies, int i, int j) {
        double radii = bodies.radius(i) + bodies.radius(j);
        double dx = bodies.x(j) - bodies.x(i);
        double dy = bodies.y(j) - bodies.y(i);
        boolean free = !bodies.isFixed(i) || !bodies.isFixed(j);
        return free && radii > 0 && dx * dx + dy * dy < 1.001 * radii * radii;
    }

    private void gather(Bodies bodies, int a, int b, double t) {
        touching.add(a, b);
        int k = touching.size() - 1;
        touching.measure(bodies, k);
        if (touching.gap(k) > TOUCHING * touching.size(bodies, k)) {
            touching.removeLast();
            return;
        }
        if (k == gentle.length) {
            gentle = Arrays.copyOf(gentle, 2 * k);
        }
        double pressed = pressing.acceleration(bodies, touching, k, t);
        gentle[k] = pressing.gentleSpeed(bodies, touching, k, pressed, t) + held.unrest(a, b);
    }

    /** Lets everything bounce that touches and closes; false when nothing does. */
    private boolean bounceClosing(Bodies bodies, double time) {
        touching.measure(bodies);
        boolean closing = false;
        for (int k = 0; k < touching.size(); k++) {
            double speed = -touching.separatingSpeed(k);
            if (speed > gentle[k]) {
                touching.want(k, restitution(k) * speed);
                closing = true;
            } else {
                touching.want(k, Double.NEGATIVE_INFINITY);
            }
        }
        if (!closing) {
            return false;
        }
        touching.push(bodies);
        for (int k = 0; k < touching.size(); k++) {
            if (touching.impulse(k) > 0) {
                tell(bodies, k, time);
            }
        }
        return true;
    }

    private double restitution(int k) {
        int a = touching.first(k);
        int b = touching.second(k);
        double e = b < 0 ? wallRestitution : restitution;
        boolean collapsed = bounces[a] >= MOST_BOUNCES || b >= 0 && bounces[b] >= MOST_BOUNCES;
        return collapsed && e < 1 ? 0 : e;
    }

    private void tell(Bodies bodies, int k, double time) {
        int a = touching.first(k);
        int b = touching.second(k);
        bounces[a]++;
        struck[a] = true;
        if (b >= 0) {
            bounces[b]++;
            struck[b] = true;
        }
        if (listener != null) {
            long second = b < 0 ? b : bodies.idValue(b);
            listener.bounced(time, bodies.idValue(a), second, -touching.separatingSpeed(k), touching.impulse(k));
        }
    }

    private void stopAll(Bodies bodies) {
        touching.measure(bodies);
        for (int k = 0; k < touching.size(); k++) {
            touching.want(k, 0);
        }
        touching.push(bodies);
    }
}
