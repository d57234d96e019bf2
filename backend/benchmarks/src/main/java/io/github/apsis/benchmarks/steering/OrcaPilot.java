package io.github.apsis.benchmarks.steering;

import static io.github.apsis.benchmarks.steering.SteeringScene.CRUISE_SPEED;
import static io.github.apsis.benchmarks.steering.SteeringScene.DT;
import static io.github.apsis.benchmarks.steering.SteeringScene.PERCEPTION;
import static io.github.apsis.benchmarks.steering.SteeringScene.SHIP_RADIUS;
import static io.github.apsis.benchmarks.steering.SteeringScene.SLOWING_RADIUS;
import static io.github.apsis.benchmarks.steering.SteeringScene.TOP_SPEED;

/**
 * {@link Orca} on ships that cannot change their velocity at once: they follow the one it chooses as fast as their engines can (with a time
 * constant of 0.15 instead, 71 of 100 ships are hit in the small circle), and against gravity. Every ship looks at all others; a rock
 * does nothing, so all of the evasion is the ship's.
 */
final class OrcaPilot implements Pilot {
    private static final double HORIZON = 2; // time
    private static final double PARTING = 0.05; // time, for two that touch
    private static final double MARGIN = 2; // length

    private final Orca orca;

    OrcaPilot(SceneState state) {
        orca = new Orca(TOP_SPEED, state.ships + state.bodies);
    }

    @Override
    public void look(SceneState state) {}

    @Override
    public void steer(SceneState state) {
        for (int i = 0; i < state.ships; i++) {
            if (state.live[i]) {
                steer(state, i);
            }
        }
    }

    private void steer(SceneState state, int i) {
        orca.clear();
        for (int j = 0; j < state.ships; j++) {
            if (j != i && state.live[j]) {
                keepClear(state, i, state.x[j], state.y[j], state.vx[j], state.vy[j], SHIP_RADIUS, 0.5);
            }
        }
        double[] radius = state.scene.bodies().radius();
        for (int k = 0; k < state.bodies; k++) {
            keepClear(state, i, state.bodyX[k], state.bodyY[k], state.bodyVx[k], state.bodyVy[k], radius[k], 1);
        }
        if (state.scene.wander()) {
            orca.choose(CRUISE_SPEED * state.headingX[i], CRUISE_SPEED * state.headingY[i]);
        } else {
            double perDistance = TOP_SPEED / Math.max(SLOWING_RADIUS, state.distanceToGoal(i));
            orca.choose(perDistance * (state.goalX[i] - state.x[i]), perDistance * (state.goalY[i] - state.y[i]));
        }
        state.pullAt(state.x[i], state.y[i]);
        state.ux[i] = (orca.x() - state.vx[i]) / DT - state.pullX;
        state.uy[i] = (orca.y() - state.vy[i]) / DT - state.pullY;
    }

    private void keepClear(
            SceneState state, int i, double x, double y, double vx, double vy, double radius, double share) {
        double px = x - state.x[i];
        double py = y - state.y[i];
        double touch = SHIP_RADIUS + radius;
        double within = touch + PERCEPTION;
        if (px * px + py * py < within * within) {
            double r = touch + MARGIN;
            double time = px * px + py * py > r * r ? HORIZON : PARTING;
            double dvx = state.vx[i] - vx;
            double dvy = state.vy[i] - vy;
            orca.keepClear(px, py, r, state.vx[i], state.vy[i], dvx, dvy, share, time);
        }
    }
}
