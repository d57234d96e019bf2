package io.github.apsis.benchmarks.contacts;

/**
 * A bounce of two bodies, or of a body and a wall.
 *
 * @param time since the start
 * @param first index of a body; where there are two, the lower
 * @param second index of the other, or −1, −2, … for the first, the second wall
 * @param closingSpeed along the line of centres just before, positive; NaN where a case does not say
 */
record ContactEvent(double time, int first, int second, double closingSpeed) {
    static ContactEvent of(double time, int a, int b, double closingSpeed) {
        boolean turned = b >= 0 && (a < 0 || a > b);
        return new ContactEvent(time, turned ? b : a, turned ? a : b, closingSpeed);
    }

    boolean isBetween(ContactEvent other) {
        return first == other.first && second == other.second;
    }

    /** {@code 3 and 5}, {@code 3 and wall 1}. */
    String names() {
        return first + " and " + (second < 0 ? "wall " + (-1 - second) : String.valueOf(second));
    }
}
