package io.github.apsis.engine.spatial;

import org.jspecify.annotations.Nullable;

/**
 * Columns for what nobody needs longer than one part of a tick is at work: parts that follow each other share them, so gravity
 * and contacts together take no more memory than the larger of the two.
 *
 * <p>A part {@link #take takes} the workspace when it begins, asks for the columns it needs by their numbers, and finds anything in
 * them; what was there is lost to the part before, which can ask whether it {@link #isHeldBy still has} its columns. The threads
 * of one part may share them, two parts may not.
 */
public final class Workspace {
    private static final int COLUMNS = 5;
    private static final int SLACK = 16; // a column that has grown has room for one in so many more

    private final double[][] doubles = new double[COLUMNS][0];
    private final int[][] ints = new int[COLUMNS][0];
    private @Nullable Object holder;

    /** All columns belong to this part, until another takes them. */
    public void take(Object part) {
        holder = part;
    }

    /** Whether nobody else has taken the columns. */
    public boolean isHeldBy(Object part) {
        return holder == part;
    }

    /** A column of numbers, at least this long. */
    public double[] doubles(int column, int length) {
        int known = doubles[column].length;
        if (length > known) {
            doubles[column] = new double[Math.max(length, known + known / SLACK)];
        }
        return doubles[column];
    }

    /** A column of whole numbers, at least this long. */
    public int[] ints(int column, int length) {
        int known = ints[column].length;
        if (length > known) {
            ints[column] = new int[Math.max(length, known + known / SLACK)];
        }
        return ints[column];
    }
}
