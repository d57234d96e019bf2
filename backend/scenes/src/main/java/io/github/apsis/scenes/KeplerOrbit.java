package io.github.apsis.scenes;

/**
 * An ellipse in the plane, and where on it a body is. Angles in degrees, as tables of elements print them.
 *
 * <pre>
 *   M = L − ϖ,   E − e sin E = M                                 Kepler's equation
 *   x = a (cos E − e),   y = a √(1 − e²) sin E                   perihelion on the x axis, then turned by ϖ
 *   n = √(μ / a³),   vx = −a n sin E / (1 − e cos E),   vy = a n √(1 − e²) cos E / (1 − e cos E)
 * </pre>
 *
 * <p>Murray and Dermott (1999), Solar System Dynamics, section 2.4. Sines come from {@link StrictMath}: the same bits on
 * every machine.
 *
 * @param a semi-major axis, length
 * @param e eccentricity, 0 to below 1
 * @param meanLongitudeDegrees L
 * @param perihelionDegrees ϖ, the longitude of the perihelion
 */
record KeplerOrbit(double a, double e, double meanLongitudeDegrees, double perihelionDegrees) {
    /** Position and velocity relative to the central body. */
    record State(double x, double y, double vx, double vy) {}

    /**
     * Where the body is and how it moves.
     *
     * @param mu G · (m1 + m2), length³ / time²
     */
    State state(double mu) {
        double anomaly = eccentricAnomaly();
        double sin = StrictMath.sin(anomaly);
        double cos = StrictMath.cos(anomaly);
        double flattening = Math.sqrt(1 - e * e);
        double rate = Math.sqrt(mu / a) / (1 - e * cos); // a · n / (1 − e cos E)
        return turned(a * (cos - e), a * flattening * sin, -rate * sin, rate * flattening * cos);
    }

    /** Newton's method from E = M + e sin M; four rounds reach the last bit for every planet. */
    double eccentricAnomaly() {
        double meanAnomaly =
                StrictMath.IEEEremainder(StrictMath.toRadians(meanLongitudeDegrees - perihelionDegrees), 2 * Math.PI);
        double anomaly = meanAnomaly + e * StrictMath.sin(meanAnomaly);
        for (int round = 0; round < 10; round++) {
            double miss = anomaly - e * StrictMath.sin(anomaly) - meanAnomaly;
            anomaly -= miss / (1 - e * StrictMath.cos(anomaly));
        }
        return anomaly;
    }

    private State turned(double x, double y, double vx, double vy) {
        double angle = StrictMath.toRadians(perihelionDegrees);
        double sin = StrictMath.sin(angle);
        double cos = StrictMath.cos(angle);
        return new State(x * cos - y * sin, x * sin + y * cos, vx * cos - vy * sin, vx * sin + vy * cos);
    }
}
