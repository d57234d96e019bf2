package io.github.apsis.benchmarks;

import io.github.apsis.engine.WorldSpec;
import java.util.Locale;

/** The two ways in which a world can find its contacts. */
public enum ContactMode {
    /** Tick by tick: for crowds and piles. */
    TICK {
        @Override
        public WorldSpec.Builder on(WorldSpec.Builder spec, double restitution) {
            return spec.contacts(restitution);
        }
    },
    /** From true contact to true contact: for few bodies and numbers to rely on. */
    EXACT {
        @Override
        public WorldSpec.Builder on(WorldSpec.Builder spec, double restitution) {
            return spec.exactContacts(restitution);
        }
    };

    /** Gives a world contacts of this kind and restitution. */
    public abstract WorldSpec.Builder on(WorldSpec.Builder spec, double restitution);

    /** As tables name it. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
