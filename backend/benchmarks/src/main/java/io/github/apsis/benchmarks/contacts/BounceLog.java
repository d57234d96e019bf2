package io.github.apsis.benchmarks.contacts;

import io.github.apsis.engine.World;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.collision.ContactListener;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Every bounce of a world, with bodies by the order in which they were added. */
final class BounceLog implements ContactListener {
    private final Map<Long, Integer> indices = new HashMap<>();
    private final List<ContactEvent> bounces = new ArrayList<>();

    /** Adds bodies to a world, and listens to it from now on. */
    static BounceLog of(World world, List<BodyDef> bodies) {
        var log = new BounceLog();
        for (BodyDef body : bodies) {
            log.indices.put(world.add(body).value(), log.indices.size());
        }
        world.onBounce(log);
        return log;
    }

    @Override
    public void bounced(double time, long first, long second, double closingSpeed, double impulse) {
        bounces.add(ContactEvent.of(time, index(first), index(second), closingSpeed));
    }

    private int index(long id) {
        return id < 0 ? (int) id : indices.getOrDefault(id, Integer.MAX_VALUE);
    }

    List<ContactEvent> bounces() {
        return bounces;
    }
}
