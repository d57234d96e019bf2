package io.github.apsis.benchmarks.reference;

import io.github.apsis.benchmarks.report.Cells;
import java.util.Locale;

/** Steps as people write them: {@code 1/150}, or a plain number. */
public final class Fraction {
    private static final int LARGEST = 100_000;

    private Fraction() {}

    /** @throws IllegalArgumentException when the text is neither a number nor a quotient of two */
    public static double parse(String text) {
        int bar = text.indexOf('/');
        try {
            return bar < 0
                    ? Double.parseDouble(text)
                    : Double.parseDouble(text.substring(0, bar)) / Double.parseDouble(text.substring(bar + 1));
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("not a number: " + text, e);
        }
    }

    /** {@code 1/150}, {@code 1/37.5}, {@code 365.25}, {@code 1e-18}: as short as it tells steps apart. */
    public static String format(double value) {
        if (value < 1.0 / LARGEST || value > LARGEST) {
            return String.format(Locale.ROOT, "%.0e", value);
        }
        return value >= 1 ? Cells.plain(value) : "1/" + Cells.plain(Math.round(1e3 / value) * 1e-3);
    }
}
