package io.github.apsis.benchmarks.cli;

/** The machine under the measurements. */
final class Jdk {
    private Jdk() {}

    /** For example {@code JDK 17.0.12+7 (Eclipse Adoptium), Linux amd64}. */
    static String name() {
        return "JDK " + Runtime.version() + " (" + System.getProperty("java.vendor") + "), "
                + System.getProperty("os.name") + " " + System.getProperty("os.arch");
    }
}
