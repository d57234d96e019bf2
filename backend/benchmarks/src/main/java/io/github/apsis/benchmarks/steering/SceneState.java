package io.github.apsis.benchmarks.steering;

import static io.github.apsis.benchmarks.steering.SteeringScene.DT;
import static io.github.apsis.benchmarks.steering.SteeringScene.SHIP_RADIUS;
import static io.github.apsis.benchmarks.steering.SteeringScene.TOP_ACCELERATION;
import static io.github.apsis.benchmarks.steering.SteeringScene.TOP_SPEED;

import io.github.apsis.benchmarks.steering.SteeringScene.Motion;
import io.github.apsis.engine.math.Rng;

/**
 * A scene on its way, under the dynamics that all scenes share: semi-implicit Euler, gravity of planets alone, no response to
 * collisions. A ship's thrust never lifts it above its top speed; gravity may.
 */
final class SceneState {
    private static final double DOCK_DISTANCE = 10;
    private static final double DOCK_SPEED = 30;
    private static final double TURN_MEMORY = 0.5; // of wanderers, time
    private static final double RESTLESSNESS = 3; // time^(−3/2)
    private static final double WALL_SHYNESS = 60; // length

    final SteeringScene scene;
    final int ships;
    final int bodies;
    final double[] x;
    final double[] y;
    final double[] vx;
    final double[] vy;
    final double[] goalX;
    final double[] goalY;
    final double[] headingX;
    final double[] headingY;
    final boolean[] live;
    /** What the ships' engines do in this tick, length / time²: written by who steers. */
    final double[] ux;

    final double[] uy;
    final double[] bodyX;
    final double[] bodyY;
    final double[] bodyVx;
    final double[] bodyVy;

    int tick;
    int liveCount;
    double pullX; // of gravity, at the place last asked for
    double pullY;
    private final double[] turnRate;
    private final boolean hasGravity;

    SceneState(SteeringScene scene) {
        this.scene = scene;
        ships = scene.shipCount();
        bodies = scene.bodies().count();
        x = scene.ships()[SteeringScene.X].clone();
        y = scene.ships()[SteeringScene.Y].clone();
        vx = scene.ships()[SteeringScene.VX].clone();
        vy = scene.ships()[SteeringScene.VY].clone();
        goalX = scene.ships()[SteeringScene.GOAL_X];
        goalY = scene.ships()[SteeringScene.GOAL_Y];
        bodyX = scene.bodies().x().clone();
        bodyY = scene.bodies().y().clone();
        bodyVx = scene.bodies().vx().clone();
        bodyVy = scene.bodies().vy().clone();
        headingX = new double[ships];
        headingY = new double[ships];
        turnRate = new double[ships];
        ux = new double[ships];
        uy = new double[ships];
        live = new boolean[ships];
        liveCount = ships;
        boolean pulled = false;
        for (double mu : scene.bodies().mu()) {
            pulled |= mu > 0;
        }
        hasGravity = pulled;
        for (int i = 0; i < ships; i++) {
            live[i] = true;
            double speed = Math.sqrt(vx[i] * vx[i] + vy[i] * vy[i]);
            headingX[i] = speed > 0 ? vx[i] / speed : 1;
            headingY[i] = speed > 0 ? vy[i] / speed : 0;
        }
    }

    /** Turns the headings of wanderers by one tick: the same for whoever steers. */
    void turnHeadings() {
        for (int i = 0; i < ships && scene.wander(); i++) {
            var rng = new Rng(scene.seed() ^ (0x9E37L * (i + 1)) ^ ((long) tick << 24));
            double xi = 2 * rng.nextDouble() - 1;
            turnRate[i] += -turnRate[i] * DT / TURN_MEMORY + RESTLESSNESS * Math.sqrt(DT) * xi;
            double h = turnRate[i] * DT / 2;
            double q = 1 + h * h;
            double cos = (1 - h * h) / q;
            double sin = 2 * h / q;
            double hx = awayFromWall(x[i], cos * headingX[i] - sin * headingY[i]);
            double hy = awayFromWall(y[i], sin * headingX[i] + cos * headingY[i]);
            double length = Math.sqrt(hx * hx + hy * hy);
            headingX[i] = hx / length;
            headingY[i] = hy / length;
        }
    }

    private double awayFromWall(double position, double component) {
        double near = scene.box() - WALL_SHYNESS;
        boolean outward =
                scene.box() > 0 && ((position > near && component > 0) || (position < -near && component < 0));
        return outward ? -component : component;
    }

    /** Sets the pull of all planets at a place; inside one it stays what it is at the surface. */
    void pullAt(double px, double py) {
        pullX = 0;
        pullY = 0;
        for (int k = 0; k < bodies && hasGravity; k++) {
            double mu = scene.bodies().mu()[k];
            if (mu > 0) {
                double dx = bodyX[k] - px;
                double dy = bodyY[k] - py;
                double d2 = dx * dx + dy * dy;
                double d = Math.sqrt(d2);
                double r = scene.bodies().radius()[k];
                if (d > 1e-9) {
                    double g = mu / Math.max(d2, r * r) / d;
                    pullX += g * dx;
                    pullY += g * dy;
                }
            }
        }
    }

    /** Moves everything by one tick. */
    void move() {
        for (int i = 0; i < ships; i++) {
            if (live[i]) {
                moveShip(i);
            }
        }
        for (int k = 0; k < bodies; k++) {
            moveBody(k);
        }
        tick++;
    }

    /** Cuts the thrust of a ship to what its engine can do. */
    void limitThrust(int i) {
        double u = Math.sqrt(ux[i] * ux[i] + uy[i] * uy[i]);
        if (u > TOP_ACCELERATION) {
            ux[i] *= TOP_ACCELERATION / u;
            uy[i] *= TOP_ACCELERATION / u;
        }
    }

    private void moveShip(int i) {
        pullAt(x[i], y[i]);
        double fx = vx[i] + pullX * DT;
        double fy = vy[i] + pullY * DT;
        double limit = Math.max(TOP_SPEED, Math.sqrt(fx * fx + fy * fy));
        double wx = fx + ux[i] * DT;
        double wy = fy + uy[i] * DT;
        double speed = Math.sqrt(wx * wx + wy * wy);
        if (speed > limit) {
            wx *= limit / speed;
            wy *= limit / speed;
        }
        x[i] += wx * DT;
        y[i] += wy * DT;
        vx[i] = wx;
        vy[i] = wy;
        if (scene.box() > 0) {
            double wall = scene.box() - SHIP_RADIUS;
            if (Math.abs(x[i]) > wall) {
                x[i] = (x[i] > 0 ? 2 : -2) * wall - x[i];
                vx[i] = -vx[i];
            }
            if (Math.abs(y[i]) > wall) {
                y[i] = (y[i] > 0 ? 2 : -2) * wall - y[i];
                vy[i] = -vy[i];
            }
        }
    }

    private void moveBody(int k) {
        Motion motion = scene.bodies().motion()[k];
        if (motion == Motion.LINEAR) {
            bodyX[k] = wrapped(bodyX[k] + bodyVx[k] * DT, scene.wrapX());
            bodyY[k] = wrapped(bodyY[k] + bodyVy[k] * DT, scene.wrapY());
        } else if (motion == Motion.ORBIT) {
            double w = scene.bodies().omega()[k];
            double h = w * DT / 2;
            double q = 1 + h * h;
            double cos = (1 - h * h) / q;
            double sin = 2 * h / q;
            double turned = cos * bodyX[k] - sin * bodyY[k];
            bodyY[k] = sin * bodyX[k] + cos * bodyY[k];
            bodyX[k] = turned;
            bodyVx[k] = -w * bodyY[k];
            bodyVy[k] = w * bodyX[k];
        }
    }

    private static double wrapped(double position, double half) {
        if (half > 0 && position > half) {
            return position - 2 * half;
        }
        return half > 0 && position < -half ? position + 2 * half : position;
    }

    /** Takes a ship out. */
    void remove(int i) {
        live[i] = false;
        liveCount--;
    }

    /** Whether a ship is slow enough and close enough to its goal to have arrived. */
    boolean hasDocked(int i) {
        return distanceToGoal(i) < DOCK_DISTANCE && speed(i) <= DOCK_SPEED;
    }

    double distanceToGoal(int i) {
        double dx = goalX[i] - x[i];
        double dy = goalY[i] - y[i];
        return Math.sqrt(dx * dx + dy * dy);
    }

    double speed(int i) {
        return Math.sqrt(vx[i] * vx[i] + vy[i] * vy[i]);
    }
}
