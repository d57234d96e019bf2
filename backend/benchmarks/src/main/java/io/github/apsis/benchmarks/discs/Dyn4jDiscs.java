package io.github.apsis.benchmarks.discs;

import io.github.apsis.engine.collision.Boundary.HalfPlane;
import io.github.apsis.engine.math.Aabb;
import java.util.ArrayList;
import java.util.List;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.ContinuousDetectionMode;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.MassType;
import org.dyn4j.world.World;

/**
 * A scene in dyn4j, in double precision, 6 iterations for velocities and 2 for positions as it comes; friction, damping and sleep
 * off, restitution at any speed.
 */
final class Dyn4jDiscs implements DiscEngine {
    private static final double NO_LIMIT = 1e6;

    private final World<Body> world = new World<>();
    private final List<Body> bodies = new ArrayList<>();
    private final double dt;

    /** What is left of its own settings. */
    enum Speeds {
        /** No more than 2 lengths in a step. */
        CLAMPED,
        ANY
    }

    Dyn4jDiscs(DiscScene scene, ContinuousDetectionMode detection, Speeds speeds) {
        dt = scene.dt();
        world.setGravity(scene.fieldX(), scene.fieldY());
        world.getSettings().setAtRestDetectionEnabled(false);
        world.getSettings().setContinuousDetectionMode(detection);
        world.getSettings().setStepFrequency(dt);
        if (speeds == Speeds.ANY) {
            world.getSettings().setMaximumTranslation(NO_LIMIT);
        }
        for (DiscScene.Disc disc : scene.discs()) {
            bodies.add(disc(disc, scene.restitution()));
        }
        for (HalfPlane wall : scene.walls()) {
            Aabb box = WallBox.of(wall, scene);
            Body body = body(Geometry.createRectangle(box.width(), box.height()), 1, scene.restitution());
            body.setMass(MassType.INFINITE);
            body.translate((box.minX() + box.maxX()) / 2, (box.minY() + box.maxY()) / 2);
        }
    }

    private Body disc(DiscScene.Disc disc, double restitution) {
        double area = Math.PI * disc.radius() * disc.radius();
        Body body = body(Geometry.createCircle(disc.radius()), disc.mass() / area, restitution);
        body.setMass(disc.isFixed() ? MassType.INFINITE : MassType.NORMAL);
        body.translate(disc.x(), disc.y());
        body.setLinearVelocity(disc.vx(), disc.vy());
        body.setLinearDamping(0);
        body.setAngularDamping(0);
        return body;
    }

    private Body body(Convex shape, double density, double restitution) {
        var body = new Body();
        BodyFixture fixture = body.addFixture(shape, density, 0, restitution);
        fixture.setRestitutionVelocity(0);
        body.setAtRestDetectionEnabled(false);
        world.addBody(body);
        return body;
    }

    @Override
    public void step() {
        world.step(1, dt);
    }

    @Override
    public double x(int i) {
        return bodies.get(i).getWorldCenter().x;
    }

    @Override
    public double y(int i) {
        return bodies.get(i).getWorldCenter().y;
    }

    @Override
    public double vx(int i) {
        return bodies.get(i).getLinearVelocity().x;
    }

    @Override
    public double vy(int i) {
        return bodies.get(i).getLinearVelocity().y;
    }
}
