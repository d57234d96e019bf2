package io.github.apsis.engine.steering;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Rng;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.spatial.Workspace;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Who is most urgent, found by cells, against asking everybody. */
class NearestTest {
    private static final double TOP_SPEED = 100;
    private static final double ACCELERATION = 200;
    private static final double RANGE = 200;
    private static final double HORIZON = 2;
    private static final double GRAVITY = 0.05;
    private static final double STAR = 4e6; // a ship could hardly leave it from within 37
    private static final int SHIPS = 40;

    private final Team team = new Team(2);

    @AfterEach
    void endTheTeam() {
        team.close();
    }

    @ParameterizedTest
    @CsvSource({
        "250, 400, 0", // coarse cells
        "3000, 400, 0", // fine ones, in a crowd
        "3000, 2000, 0", // where there are fewer than 24 within reach
        "3000, 1000, 20", // large bodies beside the fine cells
        "3000, 2000, 300", // too many of them
        "5000, 1000, 20" // sorted by a team
    })
    void cells_find_whom_asking_everybody_finds(int count, double halfWidth, int large) {
        Bodies bodies = strewn(count, halfWidth, large);
        var neighbours = new Neighbours(team, new Workspace());
        neighbours.sort(bodies, RANGE + 8);
        var nearest = new Nearest(GRAVITY, null);
        for (int ship = 0; ship < SHIPS; ship++) {
            nearest.find(neighbours, bodies, ship, TOP_SPEED, ACCELERATION, RANGE, HORIZON);
            List<Integer> found = new ArrayList<>();
            for (int m = 0; m < nearest.count(); m++) {
                found.add(nearest.slot(m));
            }
            assertThat(found).as("ship %d", ship).isEqualTo(mostUrgent(bodies, ship));
        }
    }

    private static Bodies strewn(int count, double halfWidth, int large) {
        var rng = new Rng(count + large);
        var bodies = new Bodies();
        for (int i = 0; i < count; i++) {
            double x = rng.between(-halfWidth, halfWidth);
            double y = rng.between(-halfWidth, halfWidth);
            double vx = rng.between(-40, 40);
            double vy = rng.between(-40, 40);
            if (i < SHIPS) {
                bodies.add(BodyDef.ship(x, y, 1, 8, new ShipLimits(TOP_SPEED, ACCELERATION))
                        .moving(vx, vy));
            } else {
                double radius = i < SHIPS + large ? rng.between(30, 60) : rng.between(1, 10);
                bodies.add(BodyDef.asteroid(x, y, 1, radius).moving(vx, vy));
            }
        }
        bodies.add(BodyDef.planet(0, 0, STAR, 20));
        return bodies;
    }

    private static List<Integer> mostUrgent(Bodies bodies, int ship) {
        List<Integer> all = new ArrayList<>();
        for (int j = 0; j < bodies.count(); j++) {
            if (j != ship
                    && isInReach(bodies, ship, j)
                    && urgency(bodies, ship, j) <= (bodies.isShip(j) ? 0.6 : 1.6) * HORIZON) {
                all.add(j);
            }
        }
        all.sort(Comparator.comparingDouble(j -> urgency(bodies, ship, j)));
        return all.subList(0, Math.min(24, all.size()));
    }

    private static boolean isInReach(Bodies bodies, int ship, int j) {
        double gap = distance(bodies, ship, j) - bodies.radius(ship) - bodies.radius(j);
        return gap <= (closing(bodies, ship, j) > 0 ? RANGE + bodies.radius(ship) : 1.6 * HORIZON * TOP_SPEED / 3);
    }

    /** gap / (closing speed + v_max / 3), where the gap ends at the rim or where gravity takes 0.8 of the engine. */
    private static double urgency(Bodies bodies, int ship, int j) {
        double size = Math.max(bodies.radius(j), Math.sqrt(GRAVITY * bodies.mass(j) / (0.8 * ACCELERATION)));
        double gap = distance(bodies, ship, j) - bodies.radius(ship) - size;
        return gap / (Math.max(0, closing(bodies, ship, j)) + TOP_SPEED / 3);
    }

    private static double distance(Bodies bodies, int ship, int j) {
        return Math.hypot(bodies.x(j) - bodies.x(ship), bodies.y(j) - bodies.y(ship));
    }

    private static double closing(Bodies bodies, int ship, int j) {
        double dx = bodies.x(j) - bodies.x(ship);
        double dy = bodies.y(j) - bodies.y(ship);
        double dvx = bodies.vx(j) - bodies.vx(ship);
        double dvy = bodies.vy(j) - bodies.vy(ship);
        return -(dvx * dx + dvy * dy) / Math.hypot(dx, dy);
    }
}
