package io.github.apsis.engine.body;

import java.util.Arrays;

/**
 * What ships alone have, each quantity in its own column. A row belongs to one ship, in the order of their slots; the first row
 * stands for all that is no ship. A world without ships keeps this row and nothing else, where columns by slot were half of what
 * a body took.
 */
final class ShipColumns {
    private static final double NO_TARGET = Double.NaN;
    private static final int WORD = 6; // bits of the number of a bit in a word

    private int[] slots = new int[0]; // ascending; exactly as many as there are ships

    // Rows by slot: a bit for each, and by word of bits how many ships are before; empty while there are no ships.
    private long[] isShip = new long[0];
    private int[] shipsBefore = new int[0];

    private double[] maxSpeed = new double[1];
    private double[] maxForce = new double[1];
    private double[] thrustX = new double[1];
    private double[] thrustY = new double[1];
    private double[] targetX = {NO_TARGET};
    private double[] targetY = {NO_TARGET};
    private double[] headingX = new double[1];
    private double[] headingY = new double[1];
    private double[] turnRate = new double[1];
    private double[] courseX = new double[1];
    private double[] courseY = new double[1];
    private boolean[] evading = new boolean[1];
    private long[] threat = new long[1];
    private double[] contactIn = {Double.POSITIVE_INFINITY};

    /** The slots of all ships, ascending. Not to be written. */
    int[] slots() {
        return slots;
    }

    /** Makes room for bodies in so many slots. */
    void reserve(int capacity) {
        if (slots.length > 0) {
            widen(capacity);
        }
    }

    private void widen(int capacity) {
        int known = isShip.length;
        int words = (capacity + Long.SIZE - 1) / Long.SIZE;
        if (words > known) {
            isShip = Arrays.copyOf(isShip, words);
            shipsBefore = Arrays.copyOf(shipsBefore, words);
            Arrays.fill(shipsBefore, known, words, slots.length);
        }
    }

    /** The body in the last slot is a ship. */
    void add(int slot, int capacity, ShipLimits limits, double vx, double vy) {
        widen(capacity);
        slots = Arrays.copyOf(slots, slots.length + 1);
        slots[slots.length - 1] = slot;
        int r = slots.length;
        isShip[slot >> WORD] |= 1L << slot;
        Arrays.fill(shipsBefore, (slot >> WORD) + 1, shipsBefore.length, r);
        if (r == maxSpeed.length) {
            grow(r + 1 + r / 8);
        }
        maxSpeed[r] = limits.maxSpeed();
        maxForce[r] = limits.maxForce();
        thrustX[r] = 0;
        thrustY[r] = 0;
        targetX[r] = NO_TARGET;
        targetY[r] = NO_TARGET;
        double speed = Math.sqrt(vx * vx + vy * vy);
        headingX[r] = speed > 0 ? vx / speed : 1;
        headingY[r] = speed > 0 ? vy / speed : 0;
        turnRate[r] = 0;
        courseX[r] = vx;
        courseY[r] = vy;
        evading[r] = false;
        threat[r] = 0;
        contactIn[r] = Double.NaN;
    }

    private void grow(int rows) {
        maxSpeed = Arrays.copyOf(maxSpeed, rows);
        maxForce = Arrays.copyOf(maxForce, rows);
        thrustX = Arrays.copyOf(thrustX, rows);
        thrustY = Arrays.copyOf(thrustY, rows);
        targetX = Arrays.copyOf(targetX, rows);
        targetY = Arrays.copyOf(targetY, rows);
        headingX = Arrays.copyOf(headingX, rows);
        headingY = Arrays.copyOf(headingY, rows);
        turnRate = Arrays.copyOf(turnRate, rows);
        courseX = Arrays.copyOf(courseX, rows);
        courseY = Arrays.copyOf(courseY, rows);
        evading = Arrays.copyOf(evading, rows);
        threat = Arrays.copyOf(threat, rows);
        contactIn = Arrays.copyOf(contactIn, rows);
    }

    /** The body in a slot is gone, and those behind it have moved up by one. */
    void remove(int slot) {
        if (slots.length == 0) {
            return;
        }
        int gone = row(slot);
        if (gone > 0) {
            removeRow(gone);
        }
        Arrays.fill(isShip, 0);
        for (int k = slots.length - 1; k >= 0; k--) {
            slots[k] -= slots[k] > slot ? 1 : 0;
            isShip[slots[k] >> WORD] |= 1L << slots[k];
        }
        int before = 0;
        for (int word = 0; word < isShip.length; word++) {
            shipsBefore[word] = before;
            before += Long.bitCount(isShip[word]);
        }
    }

    private void removeRow(int gone) {
        int behind = slots.length - gone;
        Object[] columns = {
            maxSpeed, maxForce, thrustX, thrustY, targetX, targetY, headingX, headingY, turnRate, courseX, courseY,
            evading, threat, contactIn
        };
        for (Object column : columns) {
            System.arraycopy(column, gone + 1, column, gone, behind);
        }
        int[] left = Arrays.copyOf(slots, slots.length - 1);
        System.arraycopy(slots, gone, left, gone - 1, behind);
        slots = left;
    }

    /** The number of a ship among ships, from 1 on; 0 for everything else. */
    int row(int slot) {
        if (slots.length == 0) {
            return 0;
        }
        long word = isShip[slot >> WORD];
        long bit = 1L << slot;
        return (word & bit) == 0 ? 0 : shipsBefore[slot >> WORD] + 1 + Long.bitCount(word & bit - 1);
    }

    double maxSpeed(int slot) {
        return maxSpeed[row(slot)];
    }

    double maxForce(int slot) {
        return maxForce[row(slot)];
    }

    double thrustX(int slot) {
        return thrustX[row(slot)];
    }

    double thrustY(int slot) {
        return thrustY[row(slot)];
    }

    void setThrust(int slot, double forceX, double forceY) {
        thrustX[rowOfShip(slot)] = forceX;
        thrustY[rowOfShip(slot)] = forceY;
    }

    double targetX(int slot) {
        return targetX[row(slot)];
    }

    double targetY(int slot) {
        return targetY[row(slot)];
    }

    void setTarget(int slot, double newX, double newY) {
        targetX[rowOfShip(slot)] = newX;
        targetY[rowOfShip(slot)] = newY;
    }

    void clearTarget(int slot) {
        setTarget(slot, NO_TARGET, NO_TARGET);
    }

    double headingX(int slot) {
        return headingX[row(slot)];
    }

    double headingY(int slot) {
        return headingY[row(slot)];
    }

    double turnRate(int slot) {
        return turnRate[row(slot)];
    }

    void setHeading(int slot, double newX, double newY, double newTurnRate) {
        int r = rowOfShip(slot);
        headingX[r] = newX;
        headingY[r] = newY;
        turnRate[r] = newTurnRate;
    }

    double courseX(int slot) {
        return courseX[row(slot)];
    }

    double courseY(int slot) {
        return courseY[row(slot)];
    }

    boolean isEvading(int slot) {
        return evading[row(slot)];
    }

    void setCourse(int slot, double newVx, double newVy, boolean detour) {
        int r = rowOfShip(slot);
        courseX[r] = newVx;
        courseY[r] = newVy;
        evading[r] = detour;
    }

    long threat(int slot) {
        return threat[row(slot)];
    }

    double contactIn(int slot) {
        return contactIn[row(slot)];
    }

    void setThreat(int slot, long body, double time) {
        int r = rowOfShip(slot);
        threat[r] = body;
        contactIn[r] = time;
    }

    private int rowOfShip(int slot) {
        int r = row(slot);
        if (r == 0) {
            throw new IllegalArgumentException("slot " + slot + " holds no ship");
        }
        return r;
    }

    /** Goes on with a hash over all that ships have. */
    long hash(long before) {
        long hash = before;
        double[][] columns = {
            maxSpeed, maxForce, thrustX, thrustY, targetX, targetY, headingX, headingY, turnRate, courseX, courseY,
            contactIn
        };
        for (int r = 1; r <= slots.length; r++) {
            for (double[] column : columns) {
                hash = StateHash.fold(hash, column[r]);
            }
            hash = StateHash.fold(hash, evading[r] ? 1 : 0);
            hash = StateHash.fold(hash, threat[r]);
        }
        return hash;
    }
}
