package io.github.apsis.server.web;

import io.github.apsis.protocol.Problem;
import io.micrometer.core.instrument.Counter;
import io.micrometer.core.instrument.MeterRegistry;
import java.util.EnumMap;
import java.util.Map;
import org.springframework.stereotype.Component;

/** Counts what was refused, by code. */
@Component
class Refusals {
    private final Map<Problem.Code, Counter> counters = new EnumMap<>(Problem.Code.class);

    Refusals(MeterRegistry metrics) {
        for (Problem.Code code : Problem.Code.values()) {
            counters.put(
                    code,
                    Counter.builder("apsis.commands.refused")
                            .description("messages of clients that were refused")
                            .tag("code", code.name())
                            .register(metrics));
        }
    }

    void count(Problem.Code code) {
        Counter counter = counters.get(code);
        if (counter != null) {
            counter.increment();
        }
    }
}
