package io.github.apsis.benchmarks.report;

import java.util.Locale;
import java.util.regex.Pattern;

/** Numbers as cells of tables, with a point whatever the country. */
public final class Cells {
    private static final Pattern TRAILING_ZEROS = Pattern.compile("(\\.\\d*?)0+$");

    private Cells() {}

    /** For programs: {@code 1.2346e-13}; empty for NaN. */
    public static String exact(double value) {
        return Double.isNaN(value) ? "" : String.format(Locale.ROOT, "%.4e", value);
    }

    /** For people: {@code 1.2e-13}; a dash for NaN. */
    public static String brief(double value) {
        if (Double.isNaN(value)) {
            return "–";
        }
        return value == 0 ? "0" : String.format(Locale.ROOT, "%.1e", value);
    }

    /** For people: three digits without an exponent; a dash for NaN. */
    public static String figure(double value) {
        if (!Double.isFinite(value)) {
            return "–";
        }
        int whole = value < 1 ? 0 : (int) Math.log10(value);
        return String.format(Locale.ROOT, "%." + Math.max(0, 2 - whole) + "f", value);
    }

    /** For people, of a ratio: {@code 54}, {@code 1.8}, {@code 0.03}, {@code 2e4}. */
    public static String times(double ratio) {
        if (ratio >= 1000 || ratio < 0.01) {
            return String.format(Locale.ROOT, "%.0e", ratio).replace("e+0", "e").replace("e-0", "e-");
        }
        return String.format(Locale.ROOT, ratio >= 10 ? "%.0f" : ratio >= 0.1 ? "%.1f" : "%.2f", ratio);
    }

    /** {@code 628}, {@code 0.5}: no zeros behind the point. */
    public static String plain(double value) {
        String text = TRAILING_ZEROS
                .matcher(String.format(Locale.ROOT, "%.6f", value))
                .replaceFirst("$1");
        return text.endsWith(".") ? text.substring(0, text.length() - 1) : text;
    }
}
