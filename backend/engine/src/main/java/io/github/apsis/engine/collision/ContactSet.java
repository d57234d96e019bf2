package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Contacts of one instant, where the bodies stand, and the impulses that they pass on together: these push and never pull, and
 * leave no contact with less than the separating speed that it should have.
 *
 * <pre>
 *   w' ≥ wanted     λ ≥ 0     λ · (w' − wanted) = 0
 * </pre>
 */
public final class ContactSet {
    private static final int MOST_ROUNDS = 10_000;
    private static final double SETTLED =
            1e-16; // change of a speed in a round, as a share of the largest wanted or present

    private final @Nullable WallSet walls;

    private int size;
    private int[] first = new int[16];
    private int[] second = new int[16];
    private double[] nx = new double[16];
    private double[] ny = new double[16];
    private double[] distance = new double[16];
    private double[] gap = new double[16];
    private double[] speed = new double[16];
    private double[] wanted = new double[16];
    private double[] impulse = new double[16];

    private final ImpulseSolver solver = new ImpulseSolver();

    public ContactSet(@Nullable WallSet walls) {
        this.walls = walls;
    }

    public void clear() {
        size = 0;
    }

    public int size() {
        return size;
    }

    /** Adds the contact of a body and another, or a wall as a negative number; the next {@link #measure} fills it in. */
    public void add(int a, int b) {
        if (size == first.length) {
            grow(2 * size);
        }
        first[size] = a;
        second[size] = b;
        size++;
    }

    private void grow(int capacity) {
        first = Arrays.copyOf(first, capacity);
        second = Arrays.copyOf(second, capacity);
        nx = Arrays.copyOf(nx, capacity);
        ny = Arrays.copyOf(ny, capacity);
        distance = Arrays.copyOf(distance, capacity);
        gap = Arrays.copyOf(gap, capacity);
        speed = Arrays.copyOf(speed, capacity);
        wanted = Arrays.copyOf(wanted, capacity);
        impulse = Arrays.copyOf(impulse, capacity);
    }

    /** Forgets the last contact that was added. */
    public void removeLast() {
        size--;
    }

    /** Forgets the k-th contact; those behind it move up by one. */
    public void remove(int k) {
        int behind = --size - k;
        System.arraycopy(first, k + 1, first, k, behind);
        System.arraycopy(second, k + 1, second, k, behind);
    }

    public boolean contains(int a, int b) {
        for (int k = 0; k < size; k++) {
            if (first[k] == a && second[k] == b) {
                return true;
            }
        }
        return false;
    }

    public int first(int k) {
        return first[k];
    }

    /** The other body, or a wall as a negative number. */
    public int second(int k) {
        return second[k];
    }

    /** From the first partner to the second. */
    public double normalX(int k) {
        return nx[k];
    }

    public double normalY(int k) {
        return ny[k];
    }

    /** Of the centres, length; infinite to a wall, which does not bend. */
    public double distance(int k) {
        return distance[k];
    }

    /** Length, negative where partners overlap. */
    public double gap(int k) {
        return gap[k];
    }

    /** Length / time, negative where partners close. */
    public double separatingSpeed(int k) {
        return speed[k];
    }

    /** What {@link #push} has passed on, mass · length / time. */
    public double impulse(int k) {
        return impulse[k];
    }

    /** What a gap is small against: the sum of the radii; to a wall the radius and the distance from the origin. */
    public double size(Bodies bodies, int k) {
        int a = first[k];
        return second[k] < 0
                ? bodies.radius(a) + Math.abs(bodies.x(a)) + Math.abs(bodies.y(a))
                : bodies.radius(a) + bodies.radius(second[k]);
    }

    /** Normal, gap and separating speed of all contacts, as the bodies stand and move now. */
    public void measure(Bodies bodies) {
        for (int k = 0; k < size; k++) {
            measure(bodies, k);
        }
    }

    /** The same of the k-th alone. */
    public void measure(Bodies bodies, int k) {
        int a = first[k];
        int b = second[k];
        if (b < 0) {
            measureWall(bodies, k, a, b);
        } else {
            double dx = bodies.x(b) - bodies.x(a) + (bodies.xLow(b) - bodies.xLow(a));
            double dy = bodies.y(b) - bodies.y(a) + (bodies.yLow(b) - bodies.yLow(a));
            double d = Math.sqrt(dx * dx + dy * dy);
            distance[k] = d;
            // Coincident centres have no line between them: the x axis is as good as any, and always the same.
            nx[k] = d > 0 ? dx / d : 1;
            ny[k] = d > 0 ? dy / d : 0;
            gap[k] = d - bodies.radius(a) - bodies.radius(b);
        }
        speed[k] = separating(bodies, k);
    }

    private void measureWall(Bodies bodies, int k, int a, int wall) {
        if (walls == null) {
            return;
        }
        nx[k] = -walls.normalX(wall);
        ny[k] = -walls.normalY(wall);
        distance[k] = Double.POSITIVE_INFINITY;
        gap[k] = walls.gap(wall, bodies.x(a), bodies.y(a), bodies.radius(a))
                - (nx[k] * bodies.xLow(a) + ny[k] * bodies.yLow(a));
    }

    private double separating(Bodies bodies, int k) {
        int a = first[k];
        int b = second[k];
        double wx = (b < 0 ? 0 : bodies.vx(b) + bodies.vxLow(b)) - bodies.vx(a);
        double wy = (b < 0 ? 0 : bodies.vy(b) + bodies.vyLow(b)) - bodies.vy(a);
        return (wx - bodies.vxLow(a)) * nx[k] + (wy - bodies.vyLow(a)) * ny[k];
    }

    /** Asks for a separating speed; negative infinity leaves a contact out. */
    public void want(int k, double separatingSpeed) {
        wanted[k] = separatingSpeed;
    }

    /**
     * Gives every contact its wanted speed, and books what that does: Σ λ (w + w')/2 of work, and the impulses that leave the
     * world through walls and fixed bodies.
     *
     * @return whether any impulse was needed
     */
    public boolean push(Bodies bodies) {
        int asked = 0;
        boolean needed = false;
        solver.begin(size, bodies);
        for (int k = 0; k < size; k++) {
            if (wanted[k] != Double.NEGATIVE_INFINITY) {
                solver.add(first[k], second[k], nx[k], ny[k], 0);
                solver.measured(asked++, speed[k] - wanted[k]);
                needed |= speed[k] < wanted[k];
            }
        }
        if (!needed) {
            return false;
        }
        solver.solve(SETTLED, 0, MOST_ROUNDS);
        solver.push();
        asked = 0;
        for (int k = 0; k < size; k++) {
            impulse[k] = wanted[k] == Double.NEGATIVE_INFINITY ? 0 : solver.impulse(asked++);
            if (impulse[k] > 0) {
                book(bodies, k, change(k, asked - 1));
            }
        }
        for (int number = 1; number < solver.numbers(); number++) {
            if (solver.pushX(number) != 0 || solver.pushY(number) != 0) {
                bodies.push(solver.slot(number), solver.pushX(number), solver.pushY(number));
            }
        }
        return true;
    }

    /** Of the separating speed, of a contact that the solver was asked for. */
    private double change(int k, int asked) {
        int a = solver.firstNumber(asked);
        int b = solver.secondNumber(asked);
        return (solver.pushX(b) - solver.pushX(a)) * nx[k] + (solver.pushY(b) - solver.pushY(a)) * ny[k];
    }

    private void book(Bodies bodies, int k, double change) {
        int a = first[k];
        int b = second[k];
        bodies.ledger().bookEnergy(impulse[k] * (speed[k] + 0.5 * change));
        double px = impulse[k] * nx[k];
        double py = impulse[k] * ny[k];
        if (b < 0 || bodies.isFixed(b)) {
            bodies.ledger().bookImpulse(-px, -py, bodies.x(a), bodies.y(a));
        } else if (bodies.isFixed(a)) {
            bodies.ledger().bookImpulse(px, py, bodies.x(b), bodies.y(b));
        }
    }
}
