package io.github.apsis.benchmarks.steering;

import com.badlogic.gdx.ai.steer.Steerable;
import com.badlogic.gdx.ai.utils.Location;
import com.badlogic.gdx.math.Vector2;

/** A ship, a rock or a goal as gdx-ai wants to see it. */
final class GdxBody implements Steerable<Vector2> {
    private final Vector2 position = new Vector2();
    private final Vector2 velocity = new Vector2();
    private final float radius;
    private float orientation;
    private boolean tagged;

    GdxBody(double radius) {
        this.radius = (float) radius;
    }

    void put(double x, double y, double vx, double vy) {
        position.set((float) x, (float) y);
        velocity.set((float) vx, (float) vy);
    }

    @Override
    public Vector2 getPosition() {
        return position;
    }

    @Override
    public Vector2 getLinearVelocity() {
        return velocity;
    }

    @Override
    public float getBoundingRadius() {
        return radius;
    }

    @Override
    public float getMaxLinearSpeed() {
        return (float) SteeringScene.TOP_SPEED;
    }

    @Override
    public float getMaxLinearAcceleration() {
        return (float) SteeringScene.TOP_ACCELERATION;
    }

    @Override
    public boolean isTagged() {
        return tagged;
    }

    @Override
    public void setTagged(boolean now) {
        tagged = now;
    }

    @Override
    public float getOrientation() {
        return orientation;
    }

    @Override
    public void setOrientation(float angle) {
        orientation = angle;
    }

    @Override
    public float vectorToAngle(Vector2 vector) {
        return (float) StrictMath.atan2(-vector.x, vector.y);
    }

    @Override
    public Vector2 angleToVector(Vector2 out, float angle) {
        return out.set((float) -StrictMath.sin(angle), (float) StrictMath.cos(angle));
    }

    @Override
    public Location<Vector2> newLocation() {
        return new GdxBody(0);
    }

    @Override
    public float getAngularVelocity() {
        return 0;
    }

    @Override
    public float getZeroLinearSpeedThreshold() {
        return 0.001f;
    }

    @Override
    public float getMaxAngularSpeed() {
        return 10;
    }

    @Override
    public float getMaxAngularAcceleration() {
        return 10;
    }

    // What the two behaviours never change.

    @Override
    public void setZeroLinearSpeedThreshold(float value) {}

    @Override
    public void setMaxLinearSpeed(float value) {}

    @Override
    public void setMaxLinearAcceleration(float value) {}

    @Override
    public void setMaxAngularSpeed(float value) {}

    @Override
    public void setMaxAngularAcceleration(float value) {}
}
