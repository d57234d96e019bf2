package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.benchmarks.accuracy.RobustCase.RawBody;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.WorldSpec.Integration;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import java.util.ArrayList;
import java.util.List;

/** The worlds that a hard input is tried in: its own bodies, or those that it describes in words. */
final class RobustScene {
    /** A case that says in words what its bodies are: discs on top of one another. */
    static final String CROWD = "deep-overlap";

    private static final double EDGE = 1e3; // length, of the box around a scene with a floor

    /** What the pile falls in. */
    static final Aabb BOX = new Aabb(-3, 0, 3, 30);

    private final RobustCase input;
    private final ContactMode contacts;

    RobustScene(RobustCase input, ContactMode contacts) {
        this.input = input;
        this.contacts = contacts;
    }

    /** Length of a tick: the input's own, or a room's. */
    double dt() {
        Double own = input.dt();
        return own == null ? Ladder.ROOM : own;
    }

    World world(Integration method) {
        WorldSpec.Builder spec = WorldSpec.builder().integration(method).dt(dt());
        List<RawBody> bodies = input.bodies().isEmpty() ? invented(spec) : input.bodies();
        if (input.g() != 0) {
            spec.gravity(input.g());
        }
        double[] field = input.uniformG();
        if (field != null) {
            spec.law(new UniformField(field[0], field[1]));
            spec.walls(new Aabb(-EDGE, 0, EDGE, EDGE), 0); // a floor, and the rest too far away to matter
        }
        if (input.g() == 0 || bodies.stream().anyMatch(body -> body.r() > 0)) {
            contacts.on(spec, 0);
        }
        World world = new World(spec.build());
        for (RawBody body : bodies) {
            world.add(BodyDef.planet(body.x(), body.y(), body.m(), body.r()).moving(body.vx(), body.vy()));
        }
        return world;
    }

    /** For cases that describe their bodies in words: a crowd of discs, or the eccentric pair of the orbits. */
    private List<RawBody> invented(WorldSpec.Builder spec) {
        if (input.id().equals(CROWD)) {
            return crowd(50, 2);
        }
        spec.gravity(1);
        return List.of(
                new RawBody(0.5, 0, -0.25, 0, 0, -Math.sqrt(3) / 2), new RawBody(0.5, 0, 0.25, 0, 0, Math.sqrt(3) / 2));
    }

    /** Discs of radius 1 in a circle, evenly spread along a spiral. */
    private static List<RawBody> crowd(int count, double within) {
        List<RawBody> crowd = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            double distance = (within - 1) * Math.sqrt((k + 0.5) / count);
            double angle = k * 2.399963; // the golden angle
            crowd.add(new RawBody(1, 1, distance * StrictMath.cos(angle), distance * StrictMath.sin(angle), 0, 0));
        }
        return crowd;
    }

    /** Ten discs that fall on one another. */
    World pileInABox() {
        World world = new World(WorldSpec.builder()
                .law(new UniformField(0, -10))
                .walls(BOX, 0.5)
                .contacts(0.5)
                .dt(dt())
                .build());
        for (int k = 0; k < 10; k++) {
            world.add(BodyDef.planet(k % 2 == 0 ? -1.2 : 1.2, 1.5 + 2.1 * k, 1, 1));
        }
        return world;
    }
}
