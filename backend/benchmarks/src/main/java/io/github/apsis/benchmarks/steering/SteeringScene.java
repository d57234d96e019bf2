package io.github.apsis.benchmarks.steering;

import java.util.Locale;

/**
 * One instance of a scene: where everything is at the start, and how long it lasts. Ships are discs of mass 1 and radius
 * {@link #SHIP_RADIUS}.
 *
 * @param name of the scene
 * @param seed of the instance, or its number
 * @param ticks how long it lasts
 * @param wrapX half the width in which drifting bodies repeat themselves, length; 0 if they do not
 * @param wrapY half the height
 * @param box half the side of the walls around the ships, length; 0 for none
 * @param wander whether ships wander; otherwise they seek their goals
 * @param dock whether a ship that arrives is done
 * @param ships x, y, vx, vy, goal x, goal y: a column each
 * @param bodies all others
 */
record SteeringScene(
        String name,
        long seed,
        int ticks,
        double wrapX,
        double wrapY,
        double box,
        boolean wander,
        boolean dock,
        double[][] ships,
        Obstacles bodies) {
    static final double DT = 1.0 / 150;
    static final double SHIP_RADIUS = 8;
    static final double TOP_SPEED = 120;
    static final double TOP_ACCELERATION = 200;
    static final double CRUISE_SPEED = 72;
    static final double SLOWING_RADIUS = 100;
    static final double PERCEPTION = 300;
    static final int TICKS_PER_SECOND = 150;

    static final int X = 0;
    static final int Y = 1;
    static final int VX = 2;
    static final int VY = 3;
    static final int GOAL_X = 4;
    static final int GOAL_Y = 5;
    static final int SHIP_COLUMNS = 6;

    /** How a body moves by itself. */
    enum Motion {
        LINEAR,
        ORBIT,
        STATIC;

        static Motion of(String name) {
            return valueOf(name.toUpperCase(Locale.ROOT));
        }
    }

    /**
     * Bodies that are no ships, a column for each quantity.
     *
     * @param mu of their gravity, length³ / time²
     * @param omega angular speed about the origin, 1 / time
     */
    record Obstacles(
            Motion[] motion,
            double[] x,
            double[] y,
            double[] vx,
            double[] vy,
            double[] radius,
            double[] mu,
            double[] omega) {
        static Obstacles of(int count) {
            Motion[] motion = new Motion[count];
            java.util.Arrays.fill(motion, Motion.LINEAR);
            return new Obstacles(
                    motion,
                    new double[count],
                    new double[count],
                    new double[count],
                    new double[count],
                    new double[count],
                    new double[count],
                    new double[count]);
        }

        int count() {
            return x.length;
        }
    }

    int shipCount() {
        return ships[X].length;
    }

    /** FNV-1a over the little-endian bytes of the columns: ship x, y, vx, vy, goal x, goal y, body x, y, vx, vy, radius. */
    String checksum() {
        long hash = 0xcbf29ce484222325L;
        for (double[] column : ships) {
            hash = fold(hash, column);
        }
        for (double[] column : new double[][] {bodies.x, bodies.y, bodies.vx, bodies.vy, bodies.radius}) {
            hash = fold(hash, column);
        }
        return String.format(Locale.ROOT, "%016x", hash);
    }

    private static long fold(long from, double[] column) {
        long hash = from;
        for (double value : column) {
            long bits = Double.doubleToRawLongBits(value + 0.0); // −0 becomes 0
            for (int shift = 0; shift < 64; shift += 8) {
                hash = (hash ^ ((bits >>> shift) & 0xff)) * 0x100000001b3L;
            }
        }
        return hash;
    }
}
