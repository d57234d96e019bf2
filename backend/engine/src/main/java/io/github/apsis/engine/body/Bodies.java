package io.github.apsis.engine.body;

import java.util.Arrays;

/**
 * All bodies of one world, every quantity in its own column.
 *
 * <p>A <em>slot</em> is an index into the columns: dense, in the order in which bodies were added, valid until the next
 * {@link #add} or {@link #remove}. Loops use slots; what leaves the engine uses {@link BodyId}. Columns behind accessors
 * cost nothing against bare arrays, and an object per body was 3 to 18 times slower to integrate.
 */
public final class Bodies {
    /** A coordinate that reaches this is out of the world, length: two of them still have a finite difference. */
    public static final double FARTHEST = 1e300;

    /** A speed that reaches this is out of the world, length / time: its square is still a number. */
    public static final double FASTEST = 1e150;

    /**
     * In contacts a body without mass is the limit m → 0: against this inverse mass that of any body with mass vanishes, two
     * of them share an impulse evenly, and the impulse that turns a speed of 1e-150 is still a normal number.
     */
    private static final double MASSLESS = 1e150; // 1 / mass

    /** A position so many times its step away from 0 loses a millionth of the step to rounding. */
    private static final double FAR = 1e10;

    private static final BodyKind[] KINDS = BodyKind.values();
    private static final int FIXED = 0x40; // of a byte whose other bits are a kind
    private static final double[] NONE = new double[0];

    private int count;
    private long lastId;
    private boolean accelerationsCurrent;
    private boolean isForced; // false where no acceleration differs from 0
    private long revision;
    private long removals;
    private final Ledger ledger = new Ledger();
    private double outsideX; // force on all free bodies from fields and from what is fixed, mass · length / time²
    private double outsideY;
    private double outsideMoment; // about the origin, mass · length² / time²

    private long[] id = new long[16];
    private byte[] kind = new byte[16]; // its ordinal, and FIXED where the body is
    private double[] x = new double[16];
    private double[] y = new double[16];
    private double[] vx = new double[16];
    private double[] vy = new double[16];
    private double[] ax = new double[16];
    private double[] ay = new double[16];
    private double[] mass = new double[16];
    private double[] radius = new double[16];

    // What a position has below its last bit: most integrators carry none on, and a drift does only where a body is far
    // from the origin, or next to at rest.
    private final LowParts low = new LowParts();

    // The same of velocities. Nothing while that is 0 for all.
    private double[] vxLow = NONE;
    private double[] vyLow = NONE;

    private final ShipColumns ships = new ShipColumns();

    /** Adds a body and returns its slot. Invalidates nothing: earlier slots keep their meaning. */
    public int add(BodyDef def) {
        if (count == id.length) {
            grow(count + Math.max(16, count >> 5)); // a body is added seldom, and kept long
        }
        int i = count++;
        id[i] = ++lastId;
        kind[i] = (byte) (def.kind().ordinal() | (def.mobility() == Mobility.FIXED ? FIXED : 0));
        x[i] = def.x();
        y[i] = def.y();
        vx[i] = def.vx();
        vy[i] = def.vy();
        ax[i] = 0;
        ay[i] = 0;
        mass[i] = def.mass();
        radius[i] = def.radius();
        low.clear(i);
        if (vxLow.length > 0) {
            vxLow[i] = 0;
            vyLow[i] = 0;
        }
        ShipLimits limits = def.limits();
        if (limits != null) {
            ships.add(i, id.length, limits, def.vx(), def.vy());
        }
        accelerationsCurrent = false;
        revision++;
        return i;
    }

    /** Removes the body in slot {@code i}; those behind it move up by one, so the order of loops stays. */
    public void remove(int i) {
        int behind = --count - i;
        System.arraycopy(id, i + 1, id, i, behind);
        System.arraycopy(kind, i + 1, kind, i, behind);
        for (double[] column : columns()) {
            System.arraycopy(column, i + 1, column, i, behind);
        }
        low.remove(i, count);
        if (vxLow.length > 0) {
            System.arraycopy(vxLow, i + 1, vxLow, i, behind);
            System.arraycopy(vyLow, i + 1, vyLow, i, behind);
        }
        ships.remove(i);
        accelerationsCurrent = false;
        revision++;
        removals++;
    }

    /** How many bodies have been removed: when it grows, slots mean other bodies. */
    public long removals() {
        return removals;
    }

    private double[][] columns() {
        return new double[][] {x, y, vx, vy, ax, ay, mass, radius};
    }

    private void grow(int capacity) {
        id = Arrays.copyOf(id, capacity);
        kind = Arrays.copyOf(kind, capacity);
        x = Arrays.copyOf(x, capacity);
        y = Arrays.copyOf(y, capacity);
        vx = Arrays.copyOf(vx, capacity);
        vy = Arrays.copyOf(vy, capacity);
        ax = Arrays.copyOf(ax, capacity);
        ay = Arrays.copyOf(ay, capacity);
        mass = Arrays.copyOf(mass, capacity);
        radius = Arrays.copyOf(radius, capacity);
        low.grow(capacity);
        if (vxLow.length > 0) {
            vxLow = Arrays.copyOf(vxLow, capacity);
            vyLow = Arrays.copyOf(vyLow, capacity);
        }
        ships.reserve(capacity);
    }

    private void carryVelocities() {
        if (vxLow.length == 0) {
            vxLow = new double[id.length];
            vyLow = new double[id.length];
        }
    }

    public int count() {
        return count;
    }

    /** The slot of a body, or a negative number when it is not there. */
    public int slotOf(BodyId body) {
        return Arrays.binarySearch(id, 0, count, body.value()); // ids grow with slots
    }

    public BodyId id(int i) {
        return new BodyId(id[i]);
    }

    /** The value of {@link #id} without the object, for hashes and seeds. */
    public long idValue(int i) {
        return id[i];
    }

    public BodyKind kind(int i) {
        return KINDS[kind[i] & ~FIXED];
    }

    public double x(int i) {
        return x[i];
    }

    public double y(int i) {
        return y[i];
    }

    public double vx(int i) {
        return vx[i];
    }

    public double vy(int i) {
        return vy[i];
    }

    /** What {@link #x} has lost to rounding: the true position is their sum. 0 unless the integrator carries it on. */
    public double xLow(int i) {
        return low.x(i);
    }

    public double yLow(int i) {
        return low.y(i);
    }

    public double vxLow(int i) {
        return vxLow.length == 0 ? 0 : vxLow[i];
    }

    public double vyLow(int i) {
        return vxLow.length == 0 ? 0 : vyLow[i];
    }

    /** Acceleration by the force laws at the last evaluation; thrust is apart. */
    public double ax(int i) {
        return ax[i];
    }

    public double ay(int i) {
        return ay[i];
    }

    public double mass(int i) {
        return mass[i];
    }

    /** 1 / mass; 0 for a fixed body, and 1e150 for one without mass or with next to none. */
    public double inverseMass(int i) {
        return isFixed(i) ? 0 : Math.min(1 / mass[i], MASSLESS);
    }

    public boolean isFixed(int i) {
        return (kind[i] & FIXED) != 0;
    }

    public double radius(int i) {
        return radius[i];
    }

    // --- motion ---

    /** Puts a body elsewhere: accelerations no longer belong to the positions. */
    public void moveTo(int i, double newX, double newY) {
        x[i] = newX;
        y[i] = newY;
        low.clear(i);
        accelerationsCurrent = false;
        revision++;
    }

    /** Puts a body on its image in a world that repeats itself; the forces there are the same. */
    public void moveToImage(int i, double newX, double newY) {
        x[i] = newX;
        y[i] = newY;
        revision++;
    }

    /** Shifts a body: accelerations no longer belong to the positions. */
    public void shift(int i, double dx, double dy) {
        x[i] += dx;
        y[i] += dy;
        accelerationsCurrent = false;
        revision++;
    }

    /** Changes a velocity by an impulse per mass. */
    public void push(int i, double dvx, double dvy) {
        vx[i] += dvx;
        vy[i] += dvy;
        revision++;
    }

    /** Grows whenever a body is added, removed, moved or pushed by anything but an integrator. */
    public long revision() {
        return revision;
    }

    /** Puts a body where an integrator has found it; the low parts are what the position has below its last bit. */
    public void place(int i, double newX, double newXLow, double newY, double newYLow) {
        x[i] = newX;
        y[i] = newY;
        if (newXLow != 0 || newYLow != 0) {
            low.makeColumn(id.length);
        }
        if (low.isColumn()) {
            low.set(i, newXLow, newYLow);
        } else {
            low.clear(i);
        }
        accelerationsCurrent = false;
    }

    /** Gives a body the velocity that an integrator has found. */
    public void setVelocity(int i, double newVx, double newVxLow, double newVy, double newVyLow) {
        vx[i] = newVx;
        vy[i] = newVy;
        if (newVxLow != 0 || newVyLow != 0) {
            carryVelocities();
        }
        if (vxLow.length > 0) {
            vxLow[i] = newVxLow;
            vyLow[i] = newVyLow;
        }
    }

    /** Gives a body the mean acceleration of its path, for those who look along it; it is not that of the laws. */
    public void setAcceleration(int i, double newAx, double newAy) {
        ax[i] = newAx;
        ay[i] = newAy;
        isForced = true;
        accelerationsCurrent = false;
    }

    /** Adds to the acceleration of a body; what a force law may do, and all that it may do. */
    public void accelerate(int i, double dax, double day) {
        ax[i] += dax;
        ay[i] += day;
    }

    /**
     * x += v · h for every body. Where rounding takes more than a millionth of a step, far from the origin or at next to no
     * speed, the next step makes up for it (Kahan 1965, Comm. ACM 8, 40): otherwise a body stands still, and falls without moving.
     */
    public void drift(double h) {
        if (low.isColumn()) {
            for (int i = 0; i < count; i++) {
                drift(i, vx[i] * h + low.x(i), vy[i] * h + low.y(i));
            }
        } else if (low.isEmpty() && !mayLose(h)) {
            move(x, vx, h);
            move(y, vy, h);
        } else {
            driftFewLow(h);
        }
        accelerationsCurrent = false;
    }

    /** Whether a sum of this drift may be one of which {@link #lost} is not 0. */
    private boolean mayLose(double h) {
        double far = 0.5 * FAR * h;
        boolean may = false;
        for (int i = 0; i < count; i++) {
            may |= Math.abs(x[i]) > Math.abs(vx[i] * far) | Math.abs(y[i]) > Math.abs(vy[i] * far);
        }
        return may;
    }

    private void move(double[] what, double[] velocity, double h) {
        for (int i = 0; i < count; i++) {
            what[i] += velocity[i] * h;
        }
    }

    private void drift(int i, double stepX, double stepY) {
        double newX = x[i] + stepX;
        double newY = y[i] + stepY;
        low.set(i, lost(x[i], stepX, newX), lost(y[i], stepY, newY));
        x[i] = newX;
        y[i] = newY;
    }

    private void driftFewLow(double h) {
        int listed = 0;
        int nextListed = low.slotAt(listed);
        for (int i = 0; i < count; i++) {
            double stepX = vx[i] * h;
            double stepY = vy[i] * h;
            if (i == nextListed) {
                stepX += low.listedX(listed);
                stepY += low.listedY(listed);
                nextListed = low.slotAt(++listed);
            }
            double newX = x[i] + stepX;
            double newY = y[i] + stepY;
            double lostX = lost(x[i], stepX, newX);
            double lostY = lost(y[i], stepY, newY);
            if (lostX != 0 || lostY != 0) {
                low.note(i, lostX, lostY);
            }
            x[i] = newX;
            y[i] = newY;
        }
        low.turn(count, id.length);
    }

    /** {@link #drift} that carries on what each sum loses to rounding (Kahan 1965, Comm. ACM 8, 40; Knuth's two-sum). */
    public void driftCompensated(double h) {
        low.makeColumn(id.length);
        carryVelocities();
        for (int i = 0; i < count; i++) {
            double step = vx[i] * h + (low.x(i) + vxLow[i] * h);
            double sum = x[i] + step;
            double taken = sum - x[i];
            double lowX = (x[i] - (sum - taken)) + (step - taken);
            x[i] = sum;
            step = vy[i] * h + (low.y(i) + vyLow[i] * h);
            sum = y[i] + step;
            taken = sum - y[i];
            low.set(i, lowX, (y[i] - (sum - taken)) + (step - taken));
            y[i] = sum;
        }
        accelerationsCurrent = false;
    }

    /** {@link #kick} that carries on what each sum loses to rounding. */
    public void kickCompensated(double h) {
        carryVelocities();
        for (int i = 0; i < count; i++) {
            double step = ax[i] * h + vxLow[i];
            double sum = vx[i] + step;
            double taken = sum - vx[i];
            vxLow[i] = (vx[i] - (sum - taken)) + (step - taken);
            vx[i] = sum;
            step = ay[i] * h + vyLow[i];
            sum = vy[i] + step;
            taken = sum - vy[i];
            vyLow[i] = (vy[i] - (sum - taken)) + (step - taken);
            vy[i] = sum;
        }
        kickByOthers(h);
    }

    /** The error of {@code sum = from + step} (Knuth's TwoSum) where it matters, and never that of an infinite sum. */
    private static double lost(double from, double step, double sum) {
        if (Math.abs(sum) <= FAR * Math.abs(step) || Math.abs(sum) >= FARTHEST) {
            return 0;
        }
        double took = sum - from;
        return (from - (sum - took)) + (step - took);
    }

    /** v += (a + thrust / m) · h for every free body; thrust only where there are ships, and its work is booked. */
    public void kick(double h) {
        if (isForced) {
            for (int i = 0; i < count; i++) {
                vx[i] += ax[i] * h;
                vy[i] += ay[i] * h;
            }
        }
        kickByOthers(h);
    }

    private void kickByOthers(double h) {
        for (int i : ships.slots()) {
            kickByThrust(i, h);
        }
        if (outsideX != 0 || outsideY != 0 || outsideMoment != 0) {
            ledger.bookMomentum(outsideX * h, outsideY * h);
            ledger.bookAngularMomentum(outsideMoment * h);
        }
    }

    private void kickByThrust(int i, double h) {
        double dvx = ships.thrustX(i) * inverseMass(i) * h;
        double dvy = ships.thrustY(i) * inverseMass(i) * h;
        // Of the whole kick's work m Δv · (v before + v after) / 2 this is the part of the thrust.
        double meanVx = vx[i] + 0.5 * (dvx - ax[i] * h);
        double meanVy = vy[i] + 0.5 * (dvy - ay[i] * h);
        ledger.bookEnergy(mass[i] * (dvx * meanVx + dvy * meanVy));
        ledger.bookImpulse(mass[i] * dvx, mass[i] * dvy, x[i], y[i]);
        vx[i] += dvx;
        vy[i] += dvy;
    }

    /** There are no forces: all accelerations are zero, and nobody asks for them again until then. */
    public void setUnforced() {
        if (isForced) {
            clearAccelerations();
        }
        isForced = false;
        accelerationsCurrent = true;
    }

    /** Sets every acceleration to zero, before the force laws add theirs. */
    public void clearAccelerations() {
        Arrays.fill(ax, 0, count, 0);
        Arrays.fill(ay, 0, count, 0);
        isForced = true;
        outsideX = 0;
        outsideY = 0;
        outsideMoment = 0;
    }

    /** Takes the accelerations so far as the work of outer fields: what they push is booked with every kick. */
    public void noteOutsideForces() {
        for (int i = 0; i < count; i++) {
            addOutside(i, mass[i]);
        }
    }

    private void addOutside(int i, double times) {
        outsideX += times * ax[i];
        outsideY += times * ay[i];
        outsideMoment += times * (x[i] * ay[i] - y[i] * ax[i]);
    }

    /** Fixed bodies attract and are held against what attracts them: called when all laws have spoken. */
    public void completeAccelerations() {
        for (int i = 0; i < count; i++) {
            if (isFixed(i)) {
                addOutside(i, -mass[i]); // what holds a fixed body against the others pushes on the world
                ax[i] = 0;
                ay[i] = 0;
            }
        }
        accelerationsCurrent = true;
    }

    /** Whether {@link #ax} and {@link #ay} belong to the present positions. */
    public boolean accelerationsCurrent() {
        return accelerationsCurrent;
    }

    /** Whether a body has reached {@link #FARTHEST}; false for NaN. */
    public boolean isTooFar(int i) {
        return Math.abs(x[i]) >= FARTHEST || Math.abs(y[i]) >= FARTHEST;
    }

    /** Whether a body has reached {@link #FASTEST}; false for NaN. */
    public boolean isTooFast(int i) {
        return vx[i] * vx[i] + vy[i] * vy[i] >= FASTEST * FASTEST;
    }

    /** Cuts what has passed {@link #FARTHEST} or {@link #FASTEST} back to it: no infinity reaches the other bodies. */
    public void keepFinite() {
        if (areWithinNumbers()) {
            return;
        }
        for (int i = 0; i < count; i++) {
            if (isTooFar(i) || isTooFast(i)) {
                x[i] = cut(x[i], FARTHEST);
                y[i] = cut(y[i], FARTHEST);
                vx[i] = cut(vx[i], FASTEST);
                vy[i] = cut(vy[i], FASTEST);
                accelerationsCurrent = false;
            }
        }
    }

    /** Whether no body is too far, too fast or nowhere: what every tick asks, in one pass. */
    public boolean areWithinNumbers() {
        return areOrdinary() || areAllWithinNumbers();
    }

    /** The same with one comparison for each body, which is half as dear; a few that are within are not this. */
    private boolean areOrdinary() {
        boolean ordinary = true;
        for (int i = 0; i < count; i++) {
            ordinary &= x[i] * x[i] + y[i] * y[i] + (vx[i] * vx[i] + vy[i] * vy[i]) < 0.1 * FASTEST * FASTEST;
        }
        return ordinary;
    }

    private boolean areAllWithinNumbers() {
        boolean within = true;
        for (int i = 0; i < count; i++) {
            double speed2 = vx[i] * vx[i] + vy[i] * vy[i];
            within &= Math.abs(x[i]) < FARTHEST && Math.abs(y[i]) < FARTHEST && speed2 < FASTEST * FASTEST;
        }
        return within;
    }

    private static double cut(double value, double most) {
        return Math.max(-most, Math.min(most, value)); // NaN stays
    }

    /** Says that another force law has taken over: accelerations no longer belong to the positions. */
    public void outdateAccelerations() {
        accelerationsCurrent = false;
    }

    /** Copies the positions of all bodies, for those who need to know the path through a tick. */
    public void copyPositions(double[] toX, double[] toY) {
        System.arraycopy(x, 0, toX, 0, count);
        System.arraycopy(y, 0, toY, 0, count);
    }

    /**
     * Finds a circle around the move of every body from where it was: its centre, and a radius that leaves room for what its
     * acceleration and thrust do in a time. Loops over columns, of which C2 makes vector code.
     *
     * @param fromX where the bodies were, length
     * @param room time², by which accelerations are multiplied
     * @param centreX is written, like the other two
     */
    public void encloseMoves(
            double[] fromX, double[] fromY, double room, double[] centreX, double[] centreY, double[] reach) {
        findMiddles(fromX, x, centreX, count);
        findMiddles(fromY, y, centreY, count);
        findDistances(fromX, x, fromY, y, reach, count);
        for (int i = 0; i < count; i++) {
            reach[i] = radius[i] + 0.5 * reach[i] + (Math.abs(ax[i]) + Math.abs(ay[i])) * room;
        }
        for (int i : ships()) {
            double distance = Math.sqrt((x[i] - fromX[i]) * (x[i] - fromX[i]) + (y[i] - fromY[i]) * (y[i] - fromY[i]));
            reach[i] = radius[i] + 0.5 * distance + accelerationWithThrust(i) * room;
        }
    }

    private static void findMiddles(double[] from, double[] to, double[] middle, int count) {
        for (int i = 0; i < count; i++) {
            middle[i] = from[i] + 0.5 * (to[i] - from[i]);
        }
    }

    private static void findDistances(
            double[] fromX, double[] toX, double[] fromY, double[] toY, double[] distance, int count) {
        for (int i = 0; i < count; i++) {
            double wx = toX[i] - fromX[i];
            double wy = toY[i] - fromY[i];
            distance[i] = Math.sqrt(wx * wx + wy * wy);
        }
    }

    /**
     * Finds the gap between the rim of every body and the nearest side of a box around all: 0 where they touch, negative beyond. A
     * side may be infinitely far. A loop over columns, of which C2 makes vector code.
     *
     * @param gap is written, length
     */
    public void findGaps(double minX, double minY, double maxX, double maxY, double[] gap) {
        for (int i = 0; i < count; i++) {
            double across = Math.min(x[i] - minX, maxX - x[i]);
            double up = Math.min(y[i] - minY, maxY - y[i]);
            gap[i] = Math.min(across, up) - radius[i];
        }
    }

    /** Narrows these gaps to that of a line as well, whose normal points to where the bodies are. */
    public void narrowGaps(double normalX, double normalY, double offset, double[] gap) {
        for (int i = 0; i < count; i++) {
            gap[i] = Math.min(gap[i], normalX * x[i] + normalY * y[i] - offset - radius[i]);
        }
    }

    /** No body accelerates more, length / time²: |ax| + |ay|, by forces, and by thrust as well. */
    public double mostAcceleration() {
        double most = isForced ? mostByForces() : 0;
        for (int i : ships()) {
            most = Math.max(most, accelerationWithThrust(i));
        }
        return most;
    }

    private double mostByForces() {
        double most = 0;
        for (int i = 0; i < count; i++) {
            double acceleration = Math.abs(ax[i]) + Math.abs(ay[i]);
            most = acceleration > most ? acceleration : most; // Math.max would wait for the one before
        }
        return most;
    }

    private double accelerationWithThrust(int i) {
        return Math.abs(ax[i] + thrustAccelerationX(i)) + Math.abs(ay[i] + thrustAccelerationY(i));
    }

    /** Copies the velocities of all bodies. */
    public void copyVelocities(double[] toVx, double[] toVy) {
        System.arraycopy(vx, 0, toVx, 0, count);
        System.arraycopy(vy, 0, toVy, 0, count);
    }

    /** The work and the impulses that came from outside the force laws. */
    public Ledger ledger() {
        return ledger;
    }

    // --- ships ---

    /** The slots of all ships, ascending. Not to be written. */
    public int[] ships() {
        return ships.slots();
    }

    /** The number of a ship among all ships, from 1 on; 0 for everything else. */
    public int shipNumber(int i) {
        return ships.row(i);
    }

    public boolean isShip(int i) {
        return kind(i) == BodyKind.SHIP;
    }

    public double maxSpeed(int i) {
        return ships.maxSpeed(i);
    }

    public double maxForce(int i) {
        return ships.maxForce(i);
    }

    /** The force of a ship's engine, held through one tick. */
    public double thrustX(int i) {
        return ships.thrustX(i);
    }

    public double thrustY(int i) {
        return ships.thrustY(i);
    }

    /** The acceleration by a ship's engine. It is asked for of every body, of which few have any. */
    public double thrustAccelerationX(int i) {
        double thrust = ships.thrustX(i);
        return thrust == 0 ? 0 : thrust * inverseMass(i);
    }

    public double thrustAccelerationY(int i) {
        double thrust = ships.thrustY(i);
        return thrust == 0 ? 0 : thrust * inverseMass(i);
    }

    public void setThrust(int i, double forceX, double forceY) {
        ships.setThrust(i, forceX, forceY);
    }

    public boolean hasTarget(int i) {
        return !Double.isNaN(ships.targetX(i));
    }

    public double targetX(int i) {
        return ships.targetX(i);
    }

    public double targetY(int i) {
        return ships.targetY(i);
    }

    public void setTarget(int i, double newX, double newY) {
        ships.setTarget(i, newX, newY);
    }

    public void clearTarget(int i) {
        ships.clearTarget(i);
    }

    /** The direction in which a wandering ship wants to go, a unit vector. */
    public double headingX(int i) {
        return ships.headingX(i);
    }

    public double headingY(int i) {
        return ships.headingY(i);
    }

    /** How fast the heading turns, radians / time. */
    public double turnRate(int i) {
        return ships.turnRate(i);
    }

    public void setHeading(int i, double newX, double newY, double newTurnRate) {
        ships.setHeading(i, newX, newY, newTurnRate);
    }

    /** The velocity that a ship is on its way to. */
    public double courseX(int i) {
        return ships.courseX(i);
    }

    public double courseY(int i) {
        return ships.courseY(i);
    }

    /** Whether the course of a ship is a detour and not what it would like best. */
    public boolean isEvading(int i) {
        return ships.isEvading(i);
    }

    public void setCourse(int i, double newVx, double newVy, boolean detour) {
        ships.setCourse(i, newVx, newVy, detour);
    }

    /** The value of the id of the body that a ship would touch first if it did as it likes; 0 when there is none. */
    public long threat(int i) {
        return ships.threat(i);
    }

    /** In how much time it would; infinite when there is none, NaN before the first look. */
    public double contactIn(int i) {
        return ships.contactIn(i);
    }

    /** Whether a ship has looked around since it was added. */
    public boolean hasLooked(int i) {
        return !Double.isNaN(ships.contactIn(i));
    }

    public void setThreat(int i, long body, double time) {
        ships.setThreat(i, body, time);
    }

    /**
     * A 64-bit FNV-1a hash over the bits of the whole state, in slot order: equal states have equal hashes, on every
     * machine.
     */
    public long hash() {
        long hash = StateHash.EMPTY;
        for (int i = 0; i < count; i++) {
            hash = StateHash.fold(hash, id[i]);
            hash = StateHash.fold(hash, kind[i]);
        }
        for (double[] column : columns()) {
            for (int i = 0; i < count; i++) {
                hash = StateHash.fold(hash, column[i]);
            }
        }
        hash = low.hash(hash, count);
        for (int i = 0; i < vxLow.length && i < count; i++) {
            hash = LowParts.fold(hash, i, vxLow[i]);
        }
        for (int i = 0; i < vyLow.length && i < count; i++) {
            hash = LowParts.fold(hash, i, vyLow[i]);
        }
        return ships.hash(hash);
    }
}
