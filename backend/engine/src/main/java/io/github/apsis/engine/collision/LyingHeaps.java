package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import java.util.Arrays;
import java.util.BitSet;

/**
 * The heaps that have ended a tick where it began, see {@link Standstill}. When the next tick would draw all their bodies to the
 * same places, it is the same tick again: they need the same impulses and end where they begin, so none are looked for. A heap at
 * rest then costs hardly more than looking who is near whom.
 *
 * <p>When somebody else touches one of them, all are solved in that tick, from the impulses that are kept here. So nothing has to be
 * told when to wake them.
 */
final class LyingHeaps {
    private final Paths paths;
    private final Touching touching;
    private boolean isOn; // in this tick
    private long ticks; // that it has been on for
    private long removals; // of bodies, when all was forgotten last

    // Bodies, fixed ones that bear them among them.
    private final BitSet lies = new BitSet();
    private int bodies;
    private int[] body = new int[0];
    private double[] drawnX = new double[0]; // where the forces alone drew them
    private double[] drawnY = new double[0];

    private int contacts;
    private int[] first = new int[0];
    private int[] second = new int[0];
    private double[] holding = new double[0]; // impulses
    private double[] settling = new double[0];

    LyingHeaps(Paths paths, Touching touching) {
        this.paths = paths;
        this.touching = touching;
    }

    /** Looks whether this tick is the last one again for all that lie; if not, they are awake. */
    void begin(Bodies all) {
        boolean were = isOn;
        boolean sameSlots = all.removals() == removals;
        isOn = bodies > 0 && sameSlots && areDrawnAgain(all);
        ticks = isOn ? ticks + 1 : 0;
        if (!isOn && !(were && sameSlots)) {
            forget(all); // what is not forgotten has to be recalled
        }
    }

    private boolean areDrawnAgain(Bodies all) {
        for (int k = 0; k < bodies; k++) {
            if (all.x(body[k]) != drawnX[k] || all.y(body[k]) != drawnY[k]) {
                return false;
            }
        }
        return true;
    }

    /** Whether there are any, and they need no impulses in this tick. */
    boolean areLeftAlone() {
        return isOn;
    }

    /** For how many ticks they have been left alone, this one among them. */
    long ticks() {
        return ticks;
    }

    /** Whether a body is left alone in this tick, or a fixed one bears such a body. */
    boolean contains(int i) {
        return isOn && i >= 0 && lies.get(i);
    }

    /** Whether such a body could move. */
    boolean containsFree(Bodies all, int i) {
        return contains(i) && !all.isFixed(i);
    }

    /** Forgets them: from now on they are not left alone. What is noted later in the tick counts in the next one. */
    void forget(Bodies all) {
        isOn = false;
        ticks = 0;
        removals = all.removals();
        lies.clear();
        bodies = 0;
        contacts = 0;
    }

    /** Notes a body that lies, and where it was drawn before it was held. */
    void note(int i, double x, double y) {
        if (lies.get(i)) {
            return;
        }
        if (bodies == body.length) {
            int capacity = Math.max(touching.size() / 2 + 16, bodies + bodies / 8);
            body = Arrays.copyOf(body, capacity);
            drawnX = Arrays.copyOf(drawnX, capacity);
            drawnY = Arrays.copyOf(drawnY, capacity);
        }
        lies.set(i);
        body[bodies] = i;
        drawnX[bodies] = x;
        drawnY[bodies] = y;
        bodies++;
    }

    /** Notes a contact in a heap that lies. */
    void noteContact(int k) {
        if (contacts == first.length) {
            int capacity = Math.max(touching.size(), contacts + contacts / 8 + 8);
            first = Arrays.copyOf(first, capacity);
            second = Arrays.copyOf(second, capacity);
            holding = Arrays.copyOf(holding, capacity);
            settling = Arrays.copyOf(settling, capacity);
        }
        first[contacts] = touching.first(k);
        second[contacts] = touching.second(k);
        holding[contacts] = touching.holding(k);
        settling[contacts] = touching.settling(k);
        contacts++;
    }

    int contacts() {
        return contacts;
    }

    int first(int k) {
        return first[k];
    }

    int second(int k) {
        return second[k];
    }

    double holding(int k) {
        return holding[k];
    }

    double settling(int k) {
        return settling[k];
    }

    /** In the middle of a tick: what {@link ContactPushes#pushHolding} did in the last one. */
    void hold(Bodies all) {
        double work = 0;
        for (int k = 0; k < bodies; k++) {
            int i = body[k];
            if (!all.isFixed(i)) {
                double x = paths.startX(i);
                double y = paths.startY(i);
                work -= all.mass(i) * ((x - all.x(i)) * all.ax(i) + (y - all.y(i)) * all.ay(i));
                all.moveTo(i, x, y);
            }
        }
        all.ledger().bookEnergy(work);
        stop(all, 0.5 * paths.dt());
    }

    /** At the end of a tick: what {@link ContactPushes#pushSettling} did in the last one. */
    void settle(Bodies all) {
        stop(all, 0);
    }

    /** Stops all, and books to what bears them the impulses and their work on the velocities at the end of the tick. */
    private void stop(Bodies all, double untilEnd) {
        double work = 0;
        double px = 0;
        double py = 0;
        double moment = 0;
        for (int k = 0; k < bodies; k++) {
            int i = body[k];
            if (!all.isFixed(i)) {
                double m = all.mass(i);
                double vx = all.vx(i);
                double vy = all.vy(i);
                all.push(i, -vx, -vy);
                work -= m * (vx * (0.5 * vx + untilEnd * all.ax(i)) + vy * (0.5 * vy + untilEnd * all.ay(i)));
                px -= m * vx;
                py -= m * vy;
                moment -= m * (all.x(i) * vy - all.y(i) * vx);
            }
        }
        all.ledger().bookEnergy(work);
        all.ledger().bookMomentum(px, py);
        all.ledger().bookAngularMomentum(moment);
    }
}
