package io.github.apsis.benchmarks.steering;

import static io.github.apsis.benchmarks.steering.SteeringScene.DT;
import static io.github.apsis.benchmarks.steering.SteeringScene.SHIP_RADIUS;
import static io.github.apsis.benchmarks.steering.SteeringScene.TOP_ACCELERATION;
import static io.github.apsis.benchmarks.steering.SteeringScene.TOP_SPEED;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.BitSet;

/** What happened in one run of a scene, or in several together. */
final class SteeringTally {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final double LOOK = 30; // between rims, length
    private static final double MOVING = 5; // below this speed a direction says nothing

    int instances;
    int ships;
    int hitShips;
    int events;
    int arrived;
    double shipSeconds;
    double minClearance = Double.POSITIVE_INFINITY;
    double ratioSum;
    double jerkSum;
    double turnSum;
    double speedSum;
    long shipTicks;
    long nanos;
    long costShipTicks;
    boolean docks; // whether there is a place to arrive at
    boolean isArrival; // of one ship that comes to rest
    double[] closest = new double[0]; // of each ship, length
    double settle = Double.NaN; // of an arrival: when it is last off, time
    double overshoot = Double.NaN; // length
    double finalError = Double.NaN; // length

    static SteeringTally of(SteeringScene scene, Contender contender) {
        var tally = new SteeringTally();
        tally.run(new SceneState(scene), contender);
        return tally;
    }

    void add(SteeringTally other) {
        instances += other.instances;
        docks |= other.docks;
        ships += other.ships;
        hitShips += other.hitShips;
        events += other.events;
        arrived += other.arrived;
        shipSeconds += other.shipSeconds;
        minClearance = Math.min(minClearance, other.minClearance);
        ratioSum += other.ratioSum;
        jerkSum += other.jerkSum;
        turnSum += other.turnSum;
        speedSum += other.speedSum;
        shipTicks += other.shipTicks;
        nanos += other.nanos;
        costShipTicks += other.costShipTicks;
    }

    private void run(SceneState state, Contender contender) {
        SteeringScene scene = state.scene;
        Pilot pilot = contender.pilot(state);
        instances = 1;
        ships = state.ships;
        closest = new double[ships];
        java.util.Arrays.fill(closest, Double.POSITIVE_INFINITY);
        var touching = new BitSet(state.ships * (state.ships + state.bodies));
        boolean[] hit = new boolean[state.ships];
        double[] lastUx = new double[state.ships];
        double[] lastUy = new double[state.ships];
        double[] lastVx = new double[state.ships];
        double[] lastVy = new double[state.ships];
        docks = scene.dock();
        isArrival = state.ships == 1 && !scene.dock() && !scene.wander();
        int lastOff = 0;
        double past = 0;
        for (int t = 0; t < scene.ticks() && state.liveCount > 0; t++) {
            state.turnHeadings();
            pilot.look(state);
            long before = THREADS.getCurrentThreadCpuTime();
            pilot.steer(state);
            nanos += THREADS.getCurrentThreadCpuTime() - before;
            costShipTicks += state.liveCount;
            for (int i = 0; i < state.ships; i++) {
                if (state.live[i]) {
                    state.limitThrust(i);
                    if (t > 0) {
                        jerkSum += length(state.ux[i] - lastUx[i], state.uy[i] - lastUy[i]);
                    }
                    lastUx[i] = state.ux[i];
                    lastUy[i] = state.uy[i];
                    lastVx[i] = state.vx[i];
                    lastVy[i] = state.vy[i];
                }
            }
            state.move();
            for (int i = 0; i < state.ships; i++) {
                if (state.live[i]) {
                    shipTicks++;
                    shipSeconds += DT;
                    double speed = state.speed(i);
                    speedSum += speed;
                    if (speed > MOVING && length(lastVx[i], lastVy[i]) > MOVING) {
                        turnSum += Math.abs(StrictMath.atan2(
                                lastVx[i] * state.vy[i] - lastVy[i] * state.vx[i],
                                lastVx[i] * state.vx[i] + lastVy[i] * state.vy[i]));
                    }
                    meet(state, i, touching, hit);
                }
            }
            for (int i = 0; i < state.ships && scene.dock(); i++) {
                if (state.live[i] && state.hasDocked(i)) {
                    state.remove(i);
                    arrived++;
                    double straight = length(
                            state.goalX[i] - scene.ships()[SteeringScene.X][i],
                            state.goalY[i] - scene.ships()[SteeringScene.Y][i]);
                    ratioSum += state.tick * DT / (straight / TOP_SPEED);
                }
            }
            if (isArrival) {
                finalError = state.distanceToGoal(0);
                past = Math.max(past, state.x[0] - state.goalX[0]);
                if (finalError > 1 || state.speed(0) > 1) {
                    lastOff = t + 1;
                }
            }
        }
        if (isArrival) {
            settle = lastOff >= scene.ticks() ? Double.POSITIVE_INFINITY : lastOff * DT;
            overshoot = past;
        }
        for (double gap : closest) {
            minClearance = Math.min(minClearance, gap);
        }
        for (boolean was : hit) {
            hitShips += was ? 1 : 0;
        }
    }

    /** Looks at the pairs of a ship with those behind it. */
    private void meet(SceneState state, int i, BitSet touching, boolean[] hit) {
        int all = state.ships + state.bodies;
        for (int j = i + 1; j < all; j++) {
            boolean ship = j < state.ships;
            if (ship && !state.live[j]) {
                continue;
            }
            int k = j - state.ships;
            double dx = (ship ? state.x[j] : state.bodyX[k]) - state.x[i];
            double dy = (ship ? state.y[j] : state.bodyY[k]) - state.y[i];
            double touch =
                    SHIP_RADIUS + (ship ? SHIP_RADIUS : state.scene.bodies().radius()[k]);
            double d2 = dx * dx + dy * dy;
            double look = touch + LOOK;
            if (d2 >= look * look) {
                continue; // whoever touches comes through what is looked at: no pair parts unseen
            }
            double gap = Math.sqrt(d2) - touch;
            closest[i] = Math.min(closest[i], gap);
            if (ship) {
                closest[j] = Math.min(closest[j], gap);
            }
            if (gap < 0 && !touching.get(i * all + j)) {
                events++;
                hit[i] = true;
                if (ship) {
                    hit[j] = true;
                }
            }
            touching.set(i * all + j, gap < 0);
        }
    }

    private static double length(double x, double y) {
        return Math.sqrt(x * x + y * y);
    }

    double collisionsPerMinute() {
        return events / (shipSeconds / 60);
    }

    double hitPercent() {
        return 100.0 * hitShips / ships;
    }

    double arrivedPercent() {
        return 100.0 * arrived / ships;
    }

    double timeRatio() {
        return arrived == 0 ? Double.NaN : ratioSum / arrived;
    }

    double jerk() {
        return jerkSum / shipTicks / (TOP_ACCELERATION * DT);
    }

    double turnDegrees() {
        return turnSum / shipSeconds * 180 / Math.PI;
    }

    double meanSpeed() {
        return speedSum / shipTicks;
    }

    double costMillis() {
        return nanos * 1e-6 / costShipTicks * 1000;
    }
}
