package io.github.apsis.benchmarks.steering;

import static io.github.apsis.benchmarks.steering.SteeringScene.CRUISE_SPEED;
import static io.github.apsis.benchmarks.steering.SteeringScene.DT;
import static io.github.apsis.benchmarks.steering.SteeringScene.SHIP_RADIUS;
import static io.github.apsis.benchmarks.steering.SteeringScene.TOP_ACCELERATION;
import static io.github.apsis.benchmarks.steering.SteeringScene.TOP_SPEED;

import io.github.apsis.benchmarks.steering.SteeringScene.Motion;
import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.spatial.Workspace;
import io.github.apsis.engine.steering.Preference;
import io.github.apsis.engine.steering.Steering;
import io.github.apsis.engine.steering.SteeringSpec;

/** The steering of the engine, on a copy of the scene in the engine's own columns. */
final class EnginePilot implements Pilot {
    private final Bodies bodies = new Bodies();
    private final BodyId[] ids;
    private final Steering steering;

    EnginePilot(SceneState state, SteeringSpec spec) {
        ids = new BodyId[state.ships + state.bodies];
        for (int i = 0; i < state.ships; i++) {
            BodyDef ship =
                    BodyDef.ship(state.x[i], state.y[i], 1, SHIP_RADIUS, new ShipLimits(TOP_SPEED, TOP_ACCELERATION));
            ids[i] = bodies.id(bodies.add(ship.moving(state.vx[i], state.vy[i])));
            if (!state.scene.wander()) {
                bodies.setTarget(i, state.goalX[i], state.goalY[i]);
            }
        }
        for (int k = 0; k < state.bodies; k++) {
            double radius = state.scene.bodies().radius()[k];
            BodyDef body = BodyDef.asteroid(
                    state.bodyX[k], state.bodyY[k], state.scene.bodies().mu()[k], radius);
            boolean still = state.scene.bodies().motion()[k] == Motion.STATIC;
            ids[state.ships + k] = bodies.id(bodies.add(still ? body.fixed() : body));
        }
        Preference heading = (of, i, tick, dt, velocity) -> {
            int ship = (int) of.idValue(i) - 1; // ships were added first
            velocity.set(CRUISE_SPEED * state.headingX[ship], CRUISE_SPEED * state.headingY[ship]);
        };
        double box = state.scene.box();
        steering = new Steering(
                spec,
                1,
                heading,
                box > 0 ? Aabb.centred(box, box) : null,
                null,
                Team.ofOne(),
                new Workspace()); // G is 1: the mass of a planet is its mu
    }

    @Override
    public void look(SceneState state) {
        for (int i = 0; i < state.ships; i++) {
            int slot = bodies.slotOf(ids[i]);
            if (slot >= 0 && !state.live[i]) {
                bodies.remove(slot);
            }
        }
        bodies.clearAccelerations();
        int slot = 0;
        for (int i = 0; i < state.ships; i++) {
            if (state.live[i]) {
                bodies.place(slot, state.x[i], 0, state.y[i], 0);
                bodies.setVelocity(slot, state.vx[i], 0, state.vy[i], 0);
                state.pullAt(state.x[i], state.y[i]);
                bodies.accelerate(slot, state.pullX, state.pullY);
                slot++;
            }
        }
        for (int k = 0; k < state.bodies; k++, slot++) {
            bodies.place(slot, state.bodyX[k], 0, state.bodyY[k], 0);
            bodies.setVelocity(slot, state.bodyVx[k], 0, state.bodyVy[k], 0);
            double w = state.scene.bodies().omega()[k];
            bodies.accelerate(slot, -w * w * state.bodyX[k], -w * w * state.bodyY[k]);
        }
    }

    @Override
    public void steer(SceneState state) {
        steering.decide(bodies, state.tick, DT);
        int slot = 0;
        for (int i = 0; i < state.ships; i++) {
            if (state.live[i]) {
                state.ux[i] = bodies.thrustX(slot); // of a mass of 1
                state.uy[i] = bodies.thrustY(slot);
                slot++;
            }
        }
    }
}
