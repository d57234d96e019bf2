package io.github.apsis.engine;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WorldMemoryTest {
    private static final int MANY = 10_000;
    private static final int TICKS = 100; // all scratch memory has been asked for by then
    private static final int BYTES_PER_BODY = 200;

    @Test
    void a_body_of_a_gas_takes_no_more_than_200_bytes() {
        double half = 0.5 * Math.sqrt(MANY * Math.PI * 4 / 0.2); // discs cover a fifth
        World gas = new World(WorldSpec.builder()
                .contacts(1)
                .walls(Aabb.centred(half, half), 1)
                .build());
        fill(gas, MANY, half - 4, 2, 60);

        assertThat(bytesPerBody(gas)).isLessThan(BYTES_PER_BODY);
    }

    @Test
    void a_body_that_attracts_by_a_tree_takes_no_more_than_200_bytes() {
        World cluster =
                new World(WorldSpec.builder().gravity(1).softening(1).tree(0.7).build());
        fill(cluster, MANY, 1000, 1, 1);

        assertThat(bytesPerBody(cluster)).isLessThan(BYTES_PER_BODY);
    }

    @Test
    void a_body_that_attracts_every_other_directly_and_collides_takes_no_more_than_200_bytes() {
        World cloud = new World(
                WorldSpec.builder().gravity(1).softening(1).contacts(0.5).build());
        fill(cloud, MANY, 1000, 1, 1);

        assertThat(bytesPerBody(cloud)).isLessThan(BYTES_PER_BODY);
    }

    /** Discs cover a twelfth; for 13 108 the grid has the most cells for each. */
    @ParameterizedTest
    @ValueSource(ints = {10_000, 13_108, 30_000, 100_000})
    void a_body_that_attracts_by_a_tree_and_collides_takes_no_more_than_200_bytes(int bodies) {
        World cloud = new World(WorldSpec.builder()
                .gravity(1)
                .softening(1)
                .tree(0.7)
                .contacts(1)
                .build());
        fill(cloud, bodies, 3 * Math.sqrt(bodies), 1, 60);
        int[] bounces = new int[1];
        cloud.onBounce((time, first, second, closingSpeed, impulse) -> bounces[0]++);

        assertThat(bytesPerBody(cloud)).isLessThan(BYTES_PER_BODY);
        assertThat(bounces[0]).as("it has contacts").isGreaterThan(bodies / 10);
    }

    /** Ships have columns of their own, and search among columns of all bodies. */
    @ParameterizedTest
    @ValueSource(ints = {10_000, 13_108, 30_000, 100_000})
    void where_one_in_twenty_is_a_ship_a_body_takes_no_more_than_200_bytes(int bodies) {
        World swarm = new World(WorldSpec.builder()
                .gravity(1)
                .softening(1)
                .tree(0.7)
                .contacts(1)
                .build());
        fill(swarm, bodies, 3 * Math.sqrt(bodies), 1, 20, 60);

        assertThat(bytesPerBody(swarm)).isLessThan(BYTES_PER_BODY);
    }

    @Test
    void a_heap_that_lies_gives_back_the_kilobytes_that_solving_it_took() {
        World heap = Heaps.inBox();
        long most = 0;
        for (int tick = 100; tick <= 2800; tick += 100) {
            run(heap, tick);
            most = Math.max(most, bytes(heap));
        }

        assertThat(bytes(heap)).isLessThan(most / 4);
    }

    private static void fill(World world, int bodies, double half, double radius, double speed) {
        fill(world, bodies, half, radius, bodies + 1, speed);
    }

    /** Rows of bodies, of which every so-manieth is a ship. */
    private static void fill(World world, int bodies, double half, double radius, int ships, double speed) {
        var rng = new Rng(7);
        int columns = (int) Math.ceil(Math.sqrt(bodies));
        for (int i = 0; i < bodies; i++) {
            double x = half * (2 * (i % columns + 0.5) / columns - 1);
            double y = half * (2 * (i / columns + 0.5) / columns - 1);
            BodyDef body = (i + 1) % ships == 0
                    ? BodyDef.ship(x, y, 1, radius, new ShipLimits(60, 100))
                    : BodyDef.planet(x, y, 1, radius);
            world.add(body.moving(rng.between(-speed, speed), rng.between(-speed, speed)));
        }
    }

    private static double bytesPerBody(World world) {
        for (int tick = 0; tick < TICKS; tick++) {
            world.step();
        }
        return (double) bytes(world) / world.count();
    }

    /** Of all arrays that can be reached; the objects that hold them are some dozens. */
    private static long bytes(World world) {
        Set<Object> seen = Collections.newSetFromMap(new IdentityHashMap<>());
        Deque<Object> open = new ArrayDeque<>();
        open.add(world);
        long bytes = 0;
        while (!open.isEmpty()) {
            Object next = open.pop();
            if (!seen.add(next)) {
                continue;
            }
            if (next.getClass().isArray()) {
                bytes += (long) Array.getLength(next) * bytesOf(next.getClass().getComponentType());
            }
            if (next instanceof Object[] elements) {
                for (Object element : elements) {
                    push(element, open);
                }
            } else if (next.getClass().getName().startsWith("io.github.apsis")) {
                pushFields(next, open);
            }
        }
        return bytes;
    }

    private static void pushFields(Object of, Deque<Object> open) {
        for (Class<?> type = of.getClass(); type != null && type != Object.class; type = type.getSuperclass()) {
            for (Field field : type.getDeclaredFields()) {
                if (!Modifier.isStatic(field.getModifiers())
                        && !field.getType().isPrimitive()
                        && type.getName().startsWith("io.github.apsis")) {
                    field.setAccessible(true);
                    push(valueOf(field, of), open);
                }
            }
        }
    }

    private static @Nullable Object valueOf(Field field, Object of) {
        try {
            return field.get(of);
        } catch (IllegalAccessException e) {
            throw new AssertionError(e);
        }
    }

    private static void push(@Nullable Object object, Deque<Object> open) {
        if (object != null) {
            open.push(object);
        }
    }

    private static long bytesOf(Class<?> element) {
        if (element == double.class || element == long.class) {
            return 8;
        }
        if (element == byte.class || element == boolean.class) {
            return 1;
        }
        return 4; // ints, and references as the JVM keeps them below 32 GB
    }
}
