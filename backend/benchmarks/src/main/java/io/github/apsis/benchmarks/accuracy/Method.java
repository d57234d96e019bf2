package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.engine.WorldSpec.Integration;
import java.util.Arrays;
import java.util.Locale;

/** The methods of the engine, by the names that reports and command lines use. */
public enum Method {
    SEMI_IMPLICIT_EULER(Integration.SEMI_IMPLICIT_EULER, 64),
    LEAPFROG(Integration.VELOCITY_VERLET, 64),
    YOSHIDA4(Integration.YOSHIDA4, 64),
    PEFRL(Integration.PEFRL, 64),
    SYMPLECTIC8(Integration.SYMPLECTIC8, 16),
    ADAPTIVE(Integration.ADAPTIVE, 1);

    private final Integration integration;
    private final int stepsPerPeriod;

    Method(Integration integration, int stepsPerPeriod) {
        this.integration = integration;
        this.stepsPerPeriod = stepsPerPeriod;
    }

    /** {@code semi-implicit-euler}. */
    public String label() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** @throws IllegalArgumentException when there is no such method */
    public static Method of(String label) {
        return Arrays.stream(values())
                .filter(method -> method.label().equals(label))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("There is no method " + label + "; there are "
                        + String.join(
                                ", ", Arrays.stream(values()).map(Method::label).toList())));
    }

    Integration integration() {
        return integration;
    }

    /** The fewest steps on a characteristic period that are worth measuring. */
    int stepsPerPeriod() {
        return stepsPerPeriod;
    }
}
