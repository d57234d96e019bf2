package io.github.apsis.benchmarks.steering;

import static io.github.apsis.benchmarks.steering.SteeringScene.PERCEPTION;
import static io.github.apsis.benchmarks.steering.SteeringScene.SHIP_RADIUS;
import static io.github.apsis.benchmarks.steering.SteeringScene.SLOWING_RADIUS;
import static io.github.apsis.benchmarks.steering.SteeringScene.TOP_SPEED;

import com.badlogic.gdx.ai.DefaultTimepiece;
import com.badlogic.gdx.ai.GdxAI;
import com.badlogic.gdx.ai.steer.SteeringAcceleration;
import com.badlogic.gdx.ai.steer.SteeringBehavior;
import com.badlogic.gdx.ai.steer.behaviors.Arrive;
import com.badlogic.gdx.ai.steer.behaviors.BlendedSteering;
import com.badlogic.gdx.ai.steer.behaviors.CollisionAvoidance;
import com.badlogic.gdx.ai.steer.behaviors.PrioritySteering;
import com.badlogic.gdx.ai.steer.proximities.RadiusProximity;
import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.utils.Array;
import java.util.ArrayList;
import java.util.List;

/** gdx-ai as it comes: its collision avoidance and its arrival, one before the other or both in equal parts. */
final class GdxPilot implements Pilot {
    private static final float AWAY = 1e7f; // where ships go that have arrived

    /** How the two behaviours share the engine. */
    enum Sharing {
        PRIORITY,
        BLENDED
    }

    private final List<GdxBody> bodies = new ArrayList<>();
    private final List<GdxBody> goals = new ArrayList<>();
    private final List<SteeringBehavior<Vector2>> behaviors = new ArrayList<>();
    private final SteeringAcceleration<Vector2> wish = new SteeringAcceleration<>(new Vector2());
    private final DefaultTimepiece clock = new DefaultTimepiece();

    GdxPilot(SceneState state, Sharing sharing) {
        Array<GdxBody> agents = new Array<>();
        for (int j = 0; j < state.ships + state.bodies; j++) {
            bodies.add(new GdxBody(
                    j < state.ships ? SHIP_RADIUS : state.scene.bodies().radius()[j - state.ships]));
            agents.add(bodies.get(j));
        }
        for (int i = 0; i < state.ships; i++) {
            GdxBody ship = bodies.get(i);
            var goal = new GdxBody(0);
            goals.add(goal);
            var avoid = new CollisionAvoidance<>(ship, new RadiusProximity<>(ship, agents, (float) PERCEPTION));
            var arrive = new Arrive<>(ship, goal)
                    .setTimeToTarget(0.1f)
                    .setArrivalTolerance(0.001f)
                    .setDecelerationRadius((float) SLOWING_RADIUS);
            behaviors.add(
                    sharing == Sharing.PRIORITY
                            ? new PrioritySteering<>(ship, 0.0001f).add(avoid).add(arrive)
                            : new BlendedSteering<>(ship).add(avoid, 1).add(arrive, 1));
        }
    }

    @Override
    public void look(SceneState state) {
        GdxAI.setTimepiece(clock);
        clock.update((float) SteeringScene.DT);
        for (int i = 0; i < state.ships; i++) {
            GdxBody ship = bodies.get(i);
            if (state.live[i]) {
                ship.put(state.x[i], state.y[i], state.vx[i], state.vy[i]);
            } else {
                ship.put(AWAY + 1e4 * i, AWAY, 0, 0);
            }
            if (state.scene.wander()) { // a goal as far ahead as the speed of the wanderer belongs to
                double ahead = SteeringScene.CRUISE_SPEED / TOP_SPEED * SLOWING_RADIUS;
                goals.get(i).put(state.x[i] + ahead * state.headingX[i], state.y[i] + ahead * state.headingY[i], 0, 0);
            } else {
                goals.get(i).put(state.goalX[i], state.goalY[i], 0, 0);
            }
        }
        for (int k = 0; k < state.bodies; k++) {
            bodies.get(state.ships + k).put(state.bodyX[k], state.bodyY[k], state.bodyVx[k], state.bodyVy[k]);
        }
    }

    @Override
    public void steer(SceneState state) {
        for (int i = 0; i < state.ships; i++) {
            if (state.live[i]) {
                behaviors.get(i).calculateSteering(wish);
                state.ux[i] = wish.linear.x;
                state.uy[i] = wish.linear.y;
            }
        }
    }
}
