package io.github.apsis.benchmarks.steering;

import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * Collisions against time as SVG, a panel for each scene and a mark for each method: the best is at the bottom, as far left as can be. Both axes
 * are logarithmic, with a line of its own for no collision at all. A hollow mark says how many
 * of the ships arrived; where none does there is no mark. What is beyond an axis is at its end.
 */
final class RatioPlot {
    private static final int PANEL_PX = 260;
    private static final int LEFT_PX = 62;
    private static final int TOP_PX = 34;
    private static final int BOTTOM_PX = 34;
    private static final int INSET_PX = 26;
    private static final int COLUMNS = 4;
    private static final double[] RATIOS = {1, 1.5, 2, 3};
    private static final double LEAST_RATIO = 0.9;
    private static final double MOST_RATIO = 3.7;
    private static final int LEAST_POWER = -3; // of ten, collisions per minute: where there are fewer than any here
    private static final int MOST_POWER = 3;

    /** Colours of Okabe and Ito (2008), in the order of the methods. */
    private static final String[] COLORS = {
        "#0072B2", "#56B4E9", "#777777", "#BBBBBB", "#D55E00", "#E69F00", "#009E73", "#222222"
    };

    private final List<SteeringRow> rows;
    private final StringBuilder svg = new StringBuilder();

    RatioPlot(List<SteeringRow> rows) {
        this.rows = rows.stream().filter(row -> row.tally().docks).toList();
    }

    boolean isEmpty() {
        return rows.isEmpty();
    }

    String svg() {
        Set<String> scenes = new LinkedHashSet<>();
        Set<Contender> methods = new LinkedHashSet<>();
        rows.forEach(row -> scenes.add(row.scene()));
        rows.forEach(row -> methods.add(row.method()));
        int lines = (scenes.size() + COLUMNS - 1) / COLUMNS;
        int width = LEFT_PX + COLUMNS * PANEL_PX;
        int height = TOP_PX + lines * PANEL_PX + BOTTOM_PX;
        add(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" font-family=\"sans-serif\">",
                width, height);
        add("<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>");
        legend(methods);
        int n = 0;
        for (String scene : scenes) {
            panel(scene, LEFT_PX + n % COLUMNS * PANEL_PX, TOP_PX + n / COLUMNS * PANEL_PX);
            n++;
        }
        text(width / 2.0, height - 14, "middle", 13, "time to dock / straight distance at top speed");
        add(
                "<text transform=\"translate(16 %d) rotate(-90)\" text-anchor=\"middle\" font-size=\"13\">%s</text>",
                height / 2, "collisions per ship-minute");
        return svg.append("</svg>\n").toString();
    }

    private void legend(Set<Contender> methods) {
        double step = COLUMNS * PANEL_PX / (double) methods.size();
        double x = LEFT_PX + 8;
        for (Contender method : methods) {
            add("<circle cx=\"%.0f\" cy=\"16\" r=\"%.1f\" fill=\"%s\"/>", x, radius(method), color(method));
            text(x + radius(method) + 4, 20, "start", 12, method.label());
            x += step;
        }
    }

    private void panel(String scene, int left, int top) {
        for (double ratio : RATIOS) {
            double x = left + x(ratio);
            rule(x, top + INSET_PX, x, top + PANEL_PX - INSET_PX);
            text(x, top + PANEL_PX - 8, "middle", 11, number(ratio));
        }
        for (int power = LEAST_POWER; power <= MOST_POWER; power++) {
            double y = top + y(power);
            rule(left, y, left + PANEL_PX - INSET_PX, y);
            if (left == LEFT_PX) {
                text(left - 6, y + 4, "end", 11, power == LEAST_POWER ? "none" : number(Math.pow(10, power)));
            }
        }
        text(left + (PANEL_PX - INSET_PX) / 2.0, top + 18, "middle", 13, scene);
        rows.stream()
                .filter(row -> row.scene().equals(scene))
                .sorted(Comparator.comparing(SteeringRow::method).reversed())
                .forEach(row -> mark(row, left, top));
    }

    private void mark(SteeringRow row, int left, int top) {
        SteeringTally tally = row.tally();
        if (tally.arrived == 0) {
            return;
        }
        double x = left + x(tally.timeRatio());
        double power = tally.events == 0 ? LEAST_POWER : Math.log10(tally.collisionsPerMinute());
        double y = top + y(power);
        boolean all = tally.arrived == tally.ships;
        add(
                "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\" stroke=\"%s\" stroke-width=\"2\"/>",
                x, y, radius(row.method()), all ? color(row.method()) : "white", color(row.method()));
        if (!all) {
            text(x, y - radius(row.method()) - 4, "middle", 11, (int) tally.arrivedPercent() + " %");
        }
    }

    private static double x(double ratio) {
        double shown = Math.max(LEAST_RATIO, Math.min(MOST_RATIO, ratio));
        return (PANEL_PX - INSET_PX) * Math.log(shown / LEAST_RATIO) / Math.log(MOST_RATIO / LEAST_RATIO);
    }

    private static double y(double power) {
        double share = (Math.min(power, MOST_POWER) - LEAST_POWER) / (MOST_POWER - LEAST_POWER);
        return PANEL_PX - INSET_PX - share * (PANEL_PX - 2 * INSET_PX);
    }

    private static String color(Contender method) {
        return COLORS[method.ordinal() % COLORS.length];
    }

    /** The larger, the farther below: of marks on one place each shows as a ring. */
    private static double radius(Contender method) {
        return 3.5 + 0.8 * method.ordinal();
    }

    private static String number(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }

    private void rule(double x1, double y1, double x2, double y2) {
        add("<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"#E4E4E4\"/>", x1, y1, x2, y2);
    }

    private void text(double x, double y, String anchor, int size, String words) {
        add(
                "<text x=\"%.0f\" y=\"%.0f\" text-anchor=\"%s\" font-size=\"%d\" fill=\"#222222\">%s</text>",
                x, y, anchor, size, words);
    }

    private void add(String format, Object... values) {
        svg.append(String.format(Locale.ROOT, format, values)).append('\n');
    }
}
