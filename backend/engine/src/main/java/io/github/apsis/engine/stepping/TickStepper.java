package io.github.apsis.engine.stepping;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.engine.collision.ContactListener;
import io.github.apsis.engine.collision.ContactMode;
import io.github.apsis.engine.collision.ContactSolver;
import io.github.apsis.engine.force.Forces;
import io.github.apsis.engine.integration.AdaptiveTaylor;
import io.github.apsis.engine.integration.Chord;
import io.github.apsis.engine.integration.Integrator;
import io.github.apsis.engine.integration.PathIntegrator;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.spatial.Workspace;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;

/** How one tick advances the bodies: paths, contacts on them, then the edge of the world. Parts a world lacks are not there. */
public final class TickStepper implements Stepper {
    private final Integrator integrator;
    private final Forces forces;
    private final @Nullable PathIntegrator path;
    private final @Nullable ContactSolver contacts;
    private final @Nullable Period period;
    private final double dt;

    public TickStepper(
            Integrator integrator,
            Forces forces,
            OptionalDouble restitution,
            ContactMode mode,
            Boundary boundary,
            double dt,
            Team team,
            Workspace workspace) {
        this.integrator = integrator;
        this.forces = forces;
        this.contacts = restitution.isPresent() || Boundary.hasWalls(boundary)
                ? new ContactSolver(restitution, boundary, mode, team, workspace)
                : null;
        this.path = pathOf(integrator, contacts != null || boundary instanceof Boundary.Periodic);
        this.period = boundary instanceof Boundary.Periodic p ? new Period(p.box()) : null;
        this.dt = dt;
    }

    /** Null where nobody looks along the path and the integrator does not draw one. */
    private static @Nullable PathIntegrator pathOf(Integrator integrator, boolean needed) {
        if (integrator instanceof PathIntegrator path) {
            return path;
        }
        return needed ? new Chord(integrator) : null;
    }

    @Override
    public boolean needsNumbers() {
        return contacts != null || integrator instanceof AdaptiveTaylor;
    }

    @Override
    public void onBounce(ContactListener listener) {
        if (contacts != null) {
            contacts.onBounce(listener);
        }
    }

    @Override
    public void step(Bodies bodies, double time) {
        if (path == null) {
            integrator.advance(bodies, forces, dt);
            bodies.keepFinite();
        } else {
            stepAlong(path, bodies, time);
        }
    }

    private void stepAlong(PathIntegrator drawn, Bodies bodies, double time) {
        if (contacts != null) {
            contacts.begin(bodies, time, dt);
        }
        drawn.move(bodies, forces, dt);
        bodies.keepFinite();
        if (contacts != null) {
            contacts.resolve(bodies);
        }
        if (period != null) {
            wrap(bodies, period);
        }
        drawn.finish(bodies, forces, dt);
        if (contacts != null) {
            contacts.settle(bodies);
        }
    }

    @Override
    public double lostTime() {
        return integrator instanceof AdaptiveTaylor adaptive ? adaptive.lostTime() : 0;
    }

    @Override
    public long pointBounces() {
        return integrator instanceof AdaptiveTaylor adaptive ? adaptive.bounces() : 0;
    }

    private static void wrap(Bodies bodies, Period period) {
        for (int i = 0; i < bodies.count(); i++) {
            double x = period.insideX(bodies.x(i));
            double y = period.insideY(bodies.y(i));
            if (x != bodies.x(i) || y != bodies.y(i)) {
                bodies.moveToImage(i, x, y);
            }
        }
    }
}
