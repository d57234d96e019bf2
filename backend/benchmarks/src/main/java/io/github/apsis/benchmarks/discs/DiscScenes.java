package io.github.apsis.benchmarks.discs;

import io.github.apsis.benchmarks.SceneRun;
import io.github.apsis.benchmarks.discs.DiscScene.Disc;
import io.github.apsis.engine.collision.Boundary.HalfPlane;
import io.github.apsis.engine.math.Aabb;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The scenes in which engines are compared: a gas, a pile, a chain of light and heavy discs, cradles and bullets, at a room's
 * tick. Their numbers come from the congruential generator of Numerical Recipes, s ← 1664525 s + 1013904223 mod 2³², so that
 * any program can make the same.
 */
public final class DiscScenes {
    public static final double RADIUS = 2;
    public static final double DT = 1.0 / SceneRun.TICKS_PER_SECOND;
    public static final double CRADLE_SPEED = 60;
    public static final double BULLET_SPEED = 5000;
    public static final double BULLET_RESTITUTION = 0.8;

    private static final double GAS_SPEED = 60;
    private static final double GAS_DENSITY = 0.2; // share of the area
    private static final double PILE_SPACING = 4.4;
    private static final double TARGET_X = 100;

    private int state = 12345;

    private DiscScenes() {}

    private double random() {
        state = state * 1664525 + 1013904223;
        return (state & 0xffffffffL) / 4294967296.0;
    }

    /** Elastic discs at one speed in all directions, a fifth of the area. */
    public static DiscScene gas(int count) {
        var scenes = new DiscScenes();
        double side = Math.sqrt(count * Math.PI * RADIUS * RADIUS / GAS_DENSITY);
        return DiscScene.boxed("gas", scenes.apart(count, side), new Aabb(0, 0, side, side), 0, 1, DT);
    }

    /** Places at random, each a little off all before. */
    private List<Disc> apart(int count, double side) {
        double clear = 2 * RADIUS * 1.01;
        int cells = (int) (side / clear) + 1;
        int[][] first = new int[cells][cells]; // of the discs in a cell
        for (int[] row : first) {
            Arrays.fill(row, -1);
        }
        int[] next = new int[count];
        List<Disc> discs = new ArrayList<>();
        while (discs.size() < count) {
            double x = RADIUS + random() * (side - 2 * RADIUS);
            double y = RADIUS + random() * (side - 2 * RADIUS);
            int column = (int) (x / clear);
            int row = (int) (y / clear);
            if (isFree(x, y, clear, discs, first, next)) {
                double angle = 2 * Math.PI * random();
                next[discs.size()] = first[row][column];
                first[row][column] = discs.size();
                discs.add(new Disc(x, y, GAS_SPEED * Math.cos(angle), GAS_SPEED * Math.sin(angle), RADIUS, 1, false));
            }
        }
        return discs;
    }

    private static boolean isFree(double x, double y, double clear, List<Disc> discs, int[][] first, int[] next) {
        int column = (int) (x / clear);
        int row = (int) (y / clear);
        for (int r = Math.max(0, row - 1); r <= Math.min(first.length - 1, row + 1); r++) {
            for (int c = Math.max(0, column - 1); c <= Math.min(first.length - 1, column + 1); c++) {
                for (int i = first[r][c]; i >= 0; i = next[i]) {
                    double dx = discs.get(i).x() - x;
                    double dy = discs.get(i).y() - y;
                    if (dx * dx + dy * dy < clear * clear) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    /** Discs that fall from a loose square into a box as wide. */
    public static DiscScene pile(int count) {
        var scenes = new DiscScenes();
        int columns = (int) Math.ceil(Math.sqrt(count));
        double side = columns * PILE_SPACING;
        List<Disc> discs = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            double x = PILE_SPACING / 2 + PILE_SPACING * (k % columns) + 0.3 * (scenes.random() - 0.5);
            double y = 20 + PILE_SPACING * (k / columns) + 0.3 * (scenes.random() - 0.5);
            discs.add(new Disc(x, y, 0, 0, RADIUS, 1, false));
        }
        return DiscScene.boxed("pile", discs, new Aabb(0, 0, side, 3 * side), -100, 0.2, DT);
    }

    /** Ten touching discs in turn of mass 1 and 10⁶, pressed against a wall. */
    public static DiscScene chain() {
        List<Disc> discs = new ArrayList<>();
        for (int i = 0; i < 10; i++) {
            discs.add(new Disc(-RADIUS - 2 * RADIUS * i, 0, 0, 0, RADIUS, i % 2 == 0 ? 1 : 1e6, false));
        }
        return new DiscScene(
                "chain 1:1e6", discs, List.of(new HalfPlane(-1, 0, 0)), new Aabb(-40, -30, 0, 30), 20, 100, 0, 0, DT);
    }

    /** A row of equal discs that another hits, elastic. */
    public static DiscScene cradle(int count, double gap) {
        List<Disc> discs = new ArrayList<>();
        discs.add(new Disc(-3 * RADIUS, 0, CRADLE_SPEED, 0, RADIUS, 1, false));
        for (int i = 1; i < count; i++) {
            discs.add(new Disc((2 * RADIUS + gap) * (i - 1), 0, 0, 0, RADIUS, 1, false));
        }
        return free("cradle of " + count + (gap > 0 ? ", gaps " + gap : ", touching"), discs, 1);
    }

    /** What a bullet is shot at. */
    public enum Target {
        /** Half a length thick. */
        WALL,
        FIXED_DISC,
        /** As fast as the bullet, towards it. */
        BULLET
    }

    /** A bullet that moves 33 lengths in a tick, from so far along the first of them. */
    public static DiscScene bullet(Target target, double phase) {
        List<Disc> discs = new ArrayList<>();
        discs.add(new Disc(phase * BULLET_SPEED * DT, 0, BULLET_SPEED, 0, 1, 1, false));
        String name =
                "bullet at " + target.name().toLowerCase(java.util.Locale.ROOT).replace('_', ' ');
        if (target == Target.WALL) {
            return new DiscScene(
                    name,
                    discs,
                    List.of(new HalfPlane(-1, 0, -TARGET_X)),
                    new Aabb(0, -50, TARGET_X, 50),
                    0.5,
                    0,
                    0,
                    BULLET_RESTITUTION,
                    DT);
        }
        discs.add(
                target == Target.FIXED_DISC
                        ? new Disc(TARGET_X, 0, 0, 0, 5, 1, true)
                        : new Disc(TARGET_X, 0, -BULLET_SPEED, 0, 1, 1, false));
        return free(name, discs, BULLET_RESTITUTION);
    }

    private static DiscScene free(String name, List<Disc> discs, double restitution) {
        return new DiscScene(name, discs, List.of(), new Aabb(-1, -1, 1, 1), 1, 0, 0, restitution, DT);
    }
}
