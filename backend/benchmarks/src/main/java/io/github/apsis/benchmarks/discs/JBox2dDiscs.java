package io.github.apsis.benchmarks.discs;

import io.github.apsis.engine.collision.Boundary.HalfPlane;
import io.github.apsis.engine.math.Aabb;
import java.util.ArrayList;
import java.util.List;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;

/**
 * A scene in JBox2D, in single precision, 8 iterations for velocities and 3 for positions as its manual has them; friction,
 * damping and sleep off, continuous collision on. Below a closing speed of 1 it does not bounce, and in a step nothing moves by more
 * than 2 lengths: both are fixed in its code.
 */
final class JBox2dDiscs implements DiscEngine {
    private static final int VELOCITY_ITERATIONS = 8;
    private static final int POSITION_ITERATIONS = 3;

    private final World world;
    private final List<Body> bodies = new ArrayList<>();
    private final float dt;

    JBox2dDiscs(DiscScene scene) {
        dt = (float) scene.dt();
        world = new World(vector(scene.fieldX(), scene.fieldY()));
        world.setAllowSleep(false);
        world.setContinuousPhysics(true);
        for (DiscScene.Disc disc : scene.discs()) {
            var shape = new CircleShape();
            shape.m_radius = (float) disc.radius();
            double area = Math.PI * disc.radius() * disc.radius();
            bodies.add(body(disc, shape, disc.mass() / area, scene.restitution()));
        }
        for (HalfPlane wall : scene.walls()) {
            Aabb box = WallBox.of(wall, scene);
            var shape = new PolygonShape();
            shape.setAsBox((float) (box.width() / 2), (float) (box.height() / 2));
            double x = (box.minX() + box.maxX()) / 2;
            double y = (box.minY() + box.maxY()) / 2;
            body(new DiscScene.Disc(x, y, 0, 0, 0, 0, true), shape, 0, scene.restitution());
        }
    }

    private Body body(DiscScene.Disc place, Shape shape, double density, double restitution) {
        var def = new BodyDef();
        def.type = place.isFixed() ? BodyType.STATIC : BodyType.DYNAMIC;
        def.position = vector(place.x(), place.y());
        def.linearVelocity = vector(place.vx(), place.vy());
        def.allowSleep = false;
        Body body = world.createBody(def);
        var fixture = new FixtureDef();
        fixture.shape = shape;
        fixture.density = (float) density;
        fixture.friction = 0;
        fixture.restitution = (float) restitution;
        body.createFixture(fixture);
        return body;
    }

    private static Vec2 vector(double x, double y) {
        return new Vec2((float) x, (float) y);
    }

    @Override
    public void step() {
        world.step(dt, VELOCITY_ITERATIONS, POSITION_ITERATIONS);
    }

    @Override
    public double x(int i) {
        return bodies.get(i).getPosition().x;
    }

    @Override
    public double y(int i) {
        return bodies.get(i).getPosition().y;
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
