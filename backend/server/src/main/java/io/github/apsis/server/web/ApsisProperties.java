package io.github.apsis.server.web;

import io.github.apsis.scenes.Scene;
import io.github.apsis.scenes.SceneCatalogue;
import java.util.List;
import java.util.stream.Collectors;
import org.springframework.boot.context.properties.ConfigurationProperties;
import org.springframework.boot.context.properties.bind.DefaultValue;

/**
 * What an operator can set.
 *
 * @param scene name of the scene in the public room
 * @param seed of everything random in it
 * @param frameRate frames per second; divides the tick rate
 * @param allowedOrigins pages on other hosts that may connect; same origin only when empty
 */
@ConfigurationProperties("apsis")
record ApsisProperties(
        @DefaultValue("belt-and-swarm") String scene,
        @DefaultValue("1") long seed,
        @DefaultValue("30") int frameRate,
        @DefaultValue List<String> allowedOrigins,
        @DefaultValue Limits limits) {
    private static final int TICK_RATE = 150;

    ApsisProperties {
        if (SceneCatalogue.byName(scene).isEmpty()) {
            throw new IllegalArgumentException("apsis.scene must be one of "
                    + SceneCatalogue.all().stream().map(Scene::name).collect(Collectors.joining(", ")) + "; was "
                    + scene);
        }
        if (frameRate < 1 || TICK_RATE % frameRate != 0) {
            throw new IllegalArgumentException(
                    "apsis.frame-rate must divide 150, for example 150, 75, 50, 30, 25, 15 or 10; was " + frameRate);
        }
        if (allowedOrigins.stream().anyMatch(origin -> origin.contains("*"))) {
            throw new IllegalArgumentException("apsis.allowed-origins must name each origin, for example "
                    + "https://school.example; a * would let any page on the web steer this server");
        }
    }

    /**
     * What one client, and all together, may ask of the server.
     *
     * @param messageBytes of one message from a client
     * @param bodies in one room
     * @param commandsPerSecond and session, in the long run
     * @param commandBurst that a session may send at once
     * @param sessions at the same time
     * @param load the share of a processor that the rooms on it may be expected to need, above 0; above 1 clocks run slower
     *     than real time
     */
    record Limits(
            @DefaultValue("16384") int messageBytes,
            @DefaultValue("2000") int bodies,
            @DefaultValue("50") int commandsPerSecond,
            @DefaultValue("100") int commandBurst,
            @DefaultValue("500") int sessions,
            @DefaultValue("0.8") double load) {
        Limits {
            atLeast("message-bytes", 1024, messageBytes);
            atLeast("bodies", 1, bodies);
            atLeast("commands-per-second", 1, commandsPerSecond);
            atLeast("command-burst", 1, commandBurst);
            atLeast("sessions", 1, sessions);
            if (!(load > 0) || Double.isInfinite(load)) {
                throw new IllegalArgumentException("apsis.limits.load must be above 0 and finite, was " + load);
            }
        }

        private static void atLeast(String name, int least, int value) {
            if (value < least) {
                throw new IllegalArgumentException(
                        "apsis.limits." + name + " must be " + least + " or more, was " + value);
            }
        }
    }
}
