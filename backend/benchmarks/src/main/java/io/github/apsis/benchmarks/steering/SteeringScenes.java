package io.github.apsis.benchmarks.steering;

import static io.github.apsis.benchmarks.steering.SteeringScene.CRUISE_SPEED;
import static io.github.apsis.benchmarks.steering.SteeringScene.GOAL_X;
import static io.github.apsis.benchmarks.steering.SteeringScene.GOAL_Y;
import static io.github.apsis.benchmarks.steering.SteeringScene.SHIP_RADIUS;
import static io.github.apsis.benchmarks.steering.SteeringScene.TICKS_PER_SECOND;
import static io.github.apsis.benchmarks.steering.SteeringScene.TOP_SPEED;
import static io.github.apsis.benchmarks.steering.SteeringScene.VX;
import static io.github.apsis.benchmarks.steering.SteeringScene.VY;
import static io.github.apsis.benchmarks.steering.SteeringScene.X;
import static io.github.apsis.benchmarks.steering.SteeringScene.Y;

import io.github.apsis.benchmarks.steering.SteeringScene.Motion;
import io.github.apsis.benchmarks.steering.SteeringScene.Obstacles;
import io.github.apsis.engine.math.Rng;
import java.util.List;

/** Builds the scenes; sums, products, quotients, roots and whole-number random bits alone, so any program gets the same ones. */
final class SteeringScenes {
    static final List<String> NAMES = List.of(
            "headon", "streams", "circle50", "circle200", "field", "field-1.6", "planet", "wander", "arrival", "belt");

    private static final double PLANET_RADIUS = 80;
    private static final double PLANET_MU = 960_000;

    private SteeringScenes() {}

    /**
     * Builds an instance; {@code field-1.6} is the field at that density, {@code wander-1000} the crowd with so many ships at the
     * same density.
     *
     * @throws IllegalArgumentException when there is no such scene
     */
    static SteeringScene of(String name, long seed) {
        int dash = name.indexOf('-');
        String kind = dash < 0 ? name : name.substring(0, dash);
        double scale = dash < 0 ? Double.NaN : scaleOf(name, name.substring(dash + 1));
        return switch (kind) {
            case "headon" -> headOn(name, seed);
            case "streams" -> streams(name, seed);
            case "circle50" -> circle(name, seed, 50, 400, 0.99211470131447788, 0.12533323356430426, 40);
            case "circle200" -> circle(name, seed, 200, 1000, 0.99950656036573160, 0.031410759078128292, 60);
            case "field" -> field(name, seed, Double.isNaN(scale) ? 1 : scale);
            case "planet" -> planet(name, seed);
            case "wander" -> wander(name, seed, Double.isNaN(scale) ? 200 : (int) scale);
            case "arrival" -> arrival(name, (int) seed);
            case "belt" -> belt(name, seed);
            default -> throw new IllegalArgumentException("there is no scene " + name + "; there are " + NAMES);
        };
    }

    private static double scaleOf(String name, String text) {
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("there is no scene " + name + "; there are " + NAMES, e);
        }
    }

    private static SteeringScene headOn(String name, long seed) {
        double[] offsets = {0, 2, 4, 8, 12};
        double[][] ships = columns(2);
        ships[X][0] = -400;
        ships[GOAL_X][0] = 400;
        ships[X][1] = 400;
        ships[GOAL_X][1] = -400;
        ships[Y][1] = offsets[(int) Math.floorMod(seed, 5L)];
        ships[GOAL_Y][1] = ships[Y][1];
        return seekers(name, seed, 20, ships, Obstacles.of(0));
    }

    private static SteeringScene streams(String name, long seed) {
        var rng = new Rng(seed + 2_000_003L);
        double[][] ships = columns(120);
        int i = 0;
        for (int stream = 0; stream < 2; stream++) {
            for (int column = 0; column < 10; column++) {
                for (int row = 0; row < 6; row++) {
                    double a = -700 - 40 * column + rng.between(-5, 5);
                    double b = -100 + 40 * row + rng.between(-5, 5);
                    double goal = a + 1760;
                    ships[X][i] = stream == 0 ? a : -b;
                    ships[Y][i] = stream == 0 ? b : a;
                    ships[GOAL_X][i] = stream == 0 ? goal : -b;
                    ships[GOAL_Y][i] = stream == 0 ? b : goal;
                    i++;
                }
            }
        }
        return seekers(name, seed, 40, ships, Obstacles.of(0));
    }

    private static SteeringScene circle(
            String name, long seed, int count, double radius, double cos, double sin, int seconds) {
        var rng = new Rng(seed + 3_000_009L);
        double[][] ships = columns(count);
        double px = radius;
        double py = 0;
        for (int i = 0; i < count; i++) {
            ships[X][i] = px + rng.between(-1, 1);
            ships[Y][i] = py + rng.between(-1, 1);
            ships[GOAL_X][i] = -px;
            ships[GOAL_Y][i] = -py;
            double turned = cos * px - sin * py;
            py = sin * px + cos * py;
            px = turned;
        }
        return seekers(name, seed, seconds, ships, Obstacles.of(0));
    }

    private static SteeringScene field(String name, long seed, double density) {
        var rng = new Rng(seed + 4_000_037L);
        double[][] ships = columns(10);
        for (int i = 0; i < 10; i++) {
            ships[X][i] = -1100;
            ships[GOAL_X][i] = 1100;
            ships[Y][i] = -450 + 100 * i;
            ships[GOAL_Y][i] = ships[Y][i];
        }
        Obstacles rocks = Obstacles.of((int) Math.round(250 * density));
        for (int k = 0; k < rocks.count(); k++) {
            rocks.radius()[k] = rng.between(10, 40);
            do {
                rocks.x()[k] = rng.between(-1400, 1400);
                rocks.y()[k] = rng.between(-1000, 1000);
            } while (isNearShip(ships, rocks.x()[k], rocks.y()[k], rocks.radius()[k] + SHIP_RADIUS + 60));
            Direction way = Direction.random(rng);
            double speed = 60 * rng.nextDouble();
            rocks.vx()[k] = way.x() * speed;
            rocks.vy()[k] = way.y() * speed;
        }
        return new SteeringScene(name, seed, 60 * TICKS_PER_SECOND, 1400, 1000, 0, false, true, ships, rocks);
    }

    private static boolean isNearShip(double[][] ships, double x, double y, double distance) {
        for (int i = 0; i < ships[X].length; i++) {
            double dx = x - ships[X][i];
            double dy = y - ships[Y][i];
            if (dx * dx + dy * dy < distance * distance) {
                return true;
            }
        }
        return false;
    }

    private static SteeringScene planet(String name, long seed) {
        var rng = new Rng(seed + 5_000_011L);
        double[][] ships = columns(11);
        for (int i = 0; i < 11; i++) {
            ships[X][i] = -700;
            ships[GOAL_X][i] = 700;
            ships[Y][i] = -200 + 40 * i + rng.between(-5, 5);
            ships[GOAL_Y][i] = ships[Y][i];
            ships[VX][i] = TOP_SPEED;
        }
        Obstacles bodies = Obstacles.of(1);
        putPlanet(bodies, 0, 0);
        return seekers(name, seed, 40, ships, bodies);
    }

    private static SteeringScene wander(String name, long seed, int count) {
        var rng = new Rng(seed + 6_000_011L);
        double box = count == 200 ? 600 : 600 * Math.sqrt(count / 200.0);
        double[][] ships = columns(count);
        for (int i = 0; i < count; i++) {
            do {
                ships[X][i] = rng.between(-box + 20, box - 20);
                ships[Y][i] = rng.between(-box + 20, box - 20);
            } while (isNearEarlier(ships, i));
            Direction heading = Direction.random(rng);
            ships[VX][i] = heading.x() * CRUISE_SPEED;
            ships[VY][i] = heading.y() * CRUISE_SPEED;
        }
        return new SteeringScene(name, seed, 120 * TICKS_PER_SECOND, 0, 0, box, true, false, ships, Obstacles.of(0));
    }

    private static boolean isNearEarlier(double[][] ships, int i) {
        for (int j = 0; j < i; j++) {
            double dx = ships[X][i] - ships[X][j];
            double dy = ships[Y][i] - ships[Y][j];
            if (dx * dx + dy * dy < 1600) {
                return true;
            }
        }
        return false;
    }

    private static SteeringScene arrival(String name, int instance) {
        if (instance < 0 || instance > 23) {
            throw new IllegalArgumentException("arrival has instances 0 to 23, was " + instance);
        }
        int q = instance % 12;
        double[] distances = {50, 100, 300, 1000};
        double[][] ships = columns(1);
        ships[GOAL_X][0] = distances[q / 3];
        ships[VY][0] = q % 3 == 1 ? TOP_SPEED : 0;
        ships[VX][0] = q % 3 == 2 ? -TOP_SPEED : 0;
        Obstacles bodies = Obstacles.of(instance >= 12 ? 1 : 0);
        if (instance >= 12) {
            putPlanet(bodies, ships[GOAL_X][0], -200);
        }
        return new SteeringScene(name, instance, 30 * TICKS_PER_SECOND, 0, 0, 0, false, false, ships, bodies);
    }

    private static SteeringScene belt(String name, long seed) {
        var rng = new Rng(seed + 8_000_009L);
        Obstacles bodies = Obstacles.of(121);
        putPlanet(bodies, 0, 0);
        for (int k = 1; k < bodies.count(); k++) {
            bodies.radius()[k] = rng.between(8, 20);
            double orbit = rng.between(300, 600);
            Direction place = Direction.random(rng);
            bodies.motion()[k] = Motion.ORBIT;
            bodies.x()[k] = orbit * place.x();
            bodies.y()[k] = orbit * place.y();
            bodies.omega()[k] = Math.sqrt(PLANET_MU / (orbit * orbit * orbit));
            bodies.vx()[k] = -bodies.omega()[k] * bodies.y()[k];
            bodies.vy()[k] = bodies.omega()[k] * bodies.x()[k];
        }
        double[][] ships = columns(12);
        double px = 1;
        double py = 0;
        for (int i = 0; i < 12; i++) {
            ships[X][i] = 800 * px;
            ships[Y][i] = 800 * py;
            ships[GOAL_X][i] = 180 * (-0.5 * px - 0.86602540378443865 * py);
            ships[GOAL_Y][i] = 180 * (0.86602540378443865 * px + -0.5 * py);
            double turned = 0.86602540378443865 * px - 0.5 * py;
            py = 0.5 * px + 0.86602540378443865 * py;
            px = turned;
        }
        return seekers(name, seed, 60, ships, bodies);
    }

    private static void putPlanet(Obstacles bodies, double x, double y) {
        bodies.motion()[0] = Motion.STATIC;
        bodies.x()[0] = x;
        bodies.y()[0] = y;
        bodies.radius()[0] = PLANET_RADIUS;
        bodies.mu()[0] = PLANET_MU;
    }

    private static SteeringScene seekers(String name, long seed, int seconds, double[][] ships, Obstacles bodies) {
        return new SteeringScene(name, seed, seconds * TICKS_PER_SECOND, 0, 0, 0, false, true, ships, bodies);
    }

    private static double[][] columns(int ships) {
        return new double[SteeringScene.SHIP_COLUMNS][ships];
    }

    /** A unit vector, by rejection: without sine and cosine. */
    private record Direction(double x, double y) {
        static Direction random(Rng rng) {
            double dx;
            double dy;
            double q;
            do {
                dx = 2 * rng.nextDouble() - 1;
                dy = 2 * rng.nextDouble() - 1;
                q = dx * dx + dy * dy;
            } while (q > 1 || q < 1e-4);
            return new Direction(dx / Math.sqrt(q), dy / Math.sqrt(q));
        }
    }
}
