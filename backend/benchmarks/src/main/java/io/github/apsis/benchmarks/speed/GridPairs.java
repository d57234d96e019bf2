package io.github.apsis.benchmarks.speed;

import java.util.Arrays;

/**
 * By a uniform grid whose cells are as wide as the widest circle, filled by a counting sort: for circles of one size hardly
 * anything is cheaper, so it is the yardstick. Each cell looks at itself, its right neighbour and the three above.
 */
final class GridPairs implements PairFinder {
    private int[] start = new int[0]; // where the circles of a cell begin in the sorted columns; one more than cells
    private int[] cell = new int[0];
    private int[] item = new int[0];
    private double[] x = new double[0];
    private double[] y = new double[0];
    private double[] r = new double[0];
    private int columns;
    private int rows;

    @Override
    public void find(Circles circles, Pairs pairs) {
        sort(circles);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                int here = row * columns + column;
                int end = start[here + 1];
                int rightEnd = column + 1 < columns ? start[here + 2] : end;
                for (int i = start[here]; i < end; i++) {
                    scan(i, i + 1, rightEnd, pairs);
                    if (row + 1 < rows) {
                        int above = here + columns;
                        int from = column > 0 ? above - 1 : above;
                        int to = column + 1 < columns ? above + 1 : above;
                        scan(i, start[from], start[to + 1], pairs);
                    }
                }
            }
        }
    }

    private void scan(int i, int from, int to, Pairs pairs) {
        double xi = x[i];
        double yi = y[i];
        double ri = r[i];
        for (int j = from; j < to; j++) {
            double dx = x[j] - xi;
            double dy = y[j] - yi;
            double reach = ri + r[j];
            if (dx * dx + dy * dy < reach * reach) {
                pairs.add(item[i], item[j]);
            }
        }
    }

    private void sort(Circles circles) {
        int count = circles.count();
        double widest = 0;
        for (double radius : circles.r()) {
            widest = Math.max(widest, radius);
        }
        double perLength = 1 / (2 * widest);
        columns = (int) (circles.side() * perLength) + 1;
        rows = columns;
        int cells = columns * rows;
        makeRoom(count, cells + 1);
        Arrays.fill(start, 0, cells + 1, 0);
        for (int i = 0; i < count; i++) {
            cell[i] = (int) (circles.y()[i] * perLength) * columns + (int) (circles.x()[i] * perLength);
            start[cell[i] + 1]++;
        }
        for (int k = 1; k <= cells; k++) {
            start[k] += start[k - 1];
        }
        for (int i = count - 1; i >= 0; i--) { // each cell fills up from its end, so start ends where it belongs
            int place = --start[cell[i] + 1];
            item[place] = i;
            x[place] = circles.x()[i];
            y[place] = circles.y()[i];
            r[place] = circles.r()[i];
        }
        System.arraycopy(start, 1, start, 0, cells); // each has moved to the beginning of the cell before it
        start[cells] = count;
    }

    private void makeRoom(int count, int starts) {
        if (start.length < starts) {
            start = new int[2 * starts];
        }
        if (item.length != count) {
            cell = new int[count];
            item = new int[count];
            x = new double[count];
            y = new double[count];
            r = new double[count];
        }
    }
}
