package io.github.apsis.engine.stepping;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.engine.collision.ContactSolver;
import io.github.apsis.engine.force.Forces;
import io.github.apsis.engine.integration.Chord;
import io.github.apsis.engine.integration.Integrator;
import io.github.apsis.engine.integration.PathIntegrator;
import io.github.apsis.engine.math.Period;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;

/** How one tick advances the bodies: paths, contacts on them, then the edge of the world. Parts a world lacks are not there. */
public final class TickStepper {
    private final Integrator integrator;
    private final Forces forces;
    private final @Nullable PathIntegrator path;
    private final @Nullable ContactSolver contacts;
    private final @Nullable Period period;
    private final double dt;

    public TickStepper(Integrator integrator, Forces forces, OptionalDouble restitution, Boundary boundary, double dt) {
        this.integrator = integrator;
        this.forces = forces;
        if (restitution.isPresent() || boundary instanceof Boundary.Walls) {
            contacts = new ContactSolver(restitution, boundary);
            path = integrator instanceof PathIntegrator p ? p : new Chord(integrator);
        } else {
            contacts = null;
            path = null;
        }
        this.period = boundary instanceof Boundary.Periodic p ? new Period(p.box()) : null;
        this.dt = dt;
    }

    public void step(Bodies bodies) {
        if (contacts != null && path != null) {
            stepWithContacts(bodies, contacts, path);
            return;
        }
        integrator.advance(bodies, forces, dt);
        if (period != null) {
            wrap(bodies, period);
        }
    }

    private void stepWithContacts(Bodies bodies, ContactSolver solver, PathIntegrator paths) {
        solver.begin(bodies, dt);
        paths.move(bodies, forces, dt);
        solver.resolve(bodies);
        if (period != null) {
            wrap(bodies, period);
        }
        paths.finish(bodies, forces, dt);
        solver.settle(bodies);
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
