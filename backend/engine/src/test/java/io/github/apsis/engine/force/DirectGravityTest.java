package io.github.apsis.engine.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.CompensatedSum;
import io.github.apsis.engine.math.Rng;
import org.junit.jupiter.api.Test;

class DirectGravityTest {
    private static final double G = 6.674e-11; // m³/(kg·s²)

    @Test
    void earth_pulls_the_moon_at_2_7_millimetres_per_second_squared() {
        var bodies = new Bodies();
        bodies.add(BodyDef.planet(0, 0, 5.972e24, 6.371e6));
        int moon = bodies.add(BodyDef.planet(3.844e8, 0, 7.342e22, 1.737e6));

        new DirectGravity(G, 0).apply(bodies);

        assertThat(bodies.ax(moon)).isCloseTo(-2.697e-3, within(1e-6)); // −G·M/r²
        assertThat(bodies.ay(moon)).isZero();
    }

    @Test
    void action_equals_reaction_to_rounding() {
        Bodies bodies = cloud(100);

        new DirectGravity(1, 0).apply(bodies);

        double fx = 0;
        double scale = 0;
        for (int i = 0; i < bodies.count(); i++) {
            fx += bodies.mass(i) * bodies.ax(i);
            scale += bodies.mass(i) * Math.abs(bodies.ax(i));
        }
        assertThat(Math.abs(fx) / scale).isLessThan(1e-15); // a few roundings of random sign
    }

    @Test
    void softening_takes_the_pull_off_at_short_distance() {
        var bodies = new Bodies();
        int a = bodies.add(BodyDef.planet(0, 0, 1, 0));
        bodies.add(BodyDef.planet(3, 0, 1, 0));

        new DirectGravity(1, 4).apply(bodies);

        assertThat(bodies.ax(a)).isCloseTo(3.0 / 125, within(1e-17)); // d / (3² + 4²)^(3/2)
    }

    @Test
    void coincident_bodies_do_not_pull_each_other_anywhere() {
        var bodies = new Bodies();
        int a = bodies.add(BodyDef.planet(1, 1, 5, 0));
        bodies.add(BodyDef.planet(1, 1, 7, 0));

        new DirectGravity(1, 0).apply(bodies);

        assertThat(bodies.ax(a)).isZero();
        assertThat(bodies.ay(a)).isZero();
    }

    /**
     * A pull is wrong by 2 or 3 roundings, and a partial sum of k of them by the root of k of its own size: parts of 128 lose 9
     * roundings of all that pulls at the worst of these bodies, where parts of 512 lost 26.
     */
    @Test
    void the_pulls_of_thousands_add_up_to_ten_roundings_of_their_sizes() {
        var disc = new Bodies();
        var rng = new Rng(12345);
        for (int i = 0; i < 3000; i++) {
            double r = 1000 * Math.sqrt(rng.nextDouble());
            double angle = rng.between(0, 2 * Math.PI);
            disc.add(BodyDef.planet(r * StrictMath.cos(angle), r * StrictMath.sin(angle), 1, 0));
        }

        new DirectGravity(1, 1).apply(disc);

        double worst = 0;
        double worstOfSum = 0;
        for (int i = 0; i < disc.count(); i++) {
            var ax = new CompensatedSum();
            var ay = new CompensatedSum();
            double sizes = 0;
            for (int j = 0; j < disc.count(); j++) {
                double dx = disc.x(j) - disc.x(i);
                double dy = disc.y(j) - disc.y(i);
                double d2 = dx * dx + dy * dy + 1;
                double pull = 1 / (d2 * Math.sqrt(d2));
                ax.add(pull * dx);
                ay.add(pull * dy);
                sizes += pull * Math.sqrt(dx * dx + dy * dy);
            }
            double off = Math.hypot(disc.ax(i) - ax.value(), disc.ay(i) - ay.value());
            worst = Math.max(worst, off / sizes);
            worstOfSum = Math.max(worstOfSum, off / Math.hypot(ax.value(), ay.value()));
        }
        assertThat(worst).isLessThan(10 * Math.ulp(0.5));
        assertThat(worstOfSum).as("of a body whose pulls all but cancel").isLessThan(1e-13);
    }

    @Test
    void is_the_gradient_of_its_potential() {
        var law = new DirectGravity(3, 0.1);
        Bodies bodies = cloud(20);
        double h = 1e-5;
        law.apply(bodies);
        double x = bodies.x(7);
        double force = bodies.mass(7) * bodies.ax(7);

        bodies.moveTo(7, x + h, bodies.y(7));
        double ahead = law.potential(bodies).orElseThrow();
        bodies.moveTo(7, x - h, bodies.y(7));
        double behind = law.potential(bodies).orElseThrow();

        // Central difference: h² of truncation and 1e-16/h of rounding, both about 1e-9 of the potential's size here.
        assertThat((behind - ahead) / (2 * h)).isCloseTo(force, within(1e-6 * Math.abs(force)));
    }

    @Test
    void nearest_images_pull_across_the_seam() {
        var bodies = new Bodies();
        int a = bodies.add(BodyDef.planet(4, 0, 1, 0));
        bodies.add(BodyDef.planet(-4, 0, 1, 0));

        new NearestImageGravity(1, 0, Aabb.centred(5, 5)).apply(bodies);

        assertThat(bodies.ax(a)).isEqualTo(0.25); // towards the image at x = 6, two away
    }

    private static Bodies cloud(int count) {
        var rng = new Rng(3);
        var bodies = new Bodies();
        for (int i = 0; i < count; i++) {
            bodies.add(BodyDef.planet(rng.between(-1, 1), rng.between(-1, 1), rng.between(0.1, 2), 0));
        }
        return bodies;
    }
}
