package io.github.apsis.scenes.shape;

import io.github.apsis.engine.math.Rng;
import java.math.BigDecimal;
import java.math.RoundingMode;
import org.locationtech.jts.algorithm.Area;
import org.locationtech.jts.algorithm.ConvexHull;
import org.locationtech.jts.algorithm.MinimumBoundingCircle;
import org.locationtech.jts.algorithm.Orientation;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.CoordinateArrays;
import org.locationtech.jts.geom.GeometryFactory;

/**
 * Random convex outlines: the hull of points strewn about an ellipse.
 *
 * <p>The outline is moved so that the centre of its minimum enclosing circle is the origin, and scaled so that this circle
 * has the wanted radius. Then every coordinate is cut towards 0 to a short decimal, because outlines travel as text: the
 * step is a power of ten of at most a thousandth of the radius. Cutting moves vertices inwards only, so the wanted circle
 * still encloses the outline, with at most 1.5 thousandths of the radius to spare.
 *
 * <p>The same generator gives the same bits on every machine: sines come from {@link StrictMath}, and the rest is
 * arithmetic that IEEE 754 fixes.
 */
public final class AsteroidOutline {
    private static final int FEWEST_VERTICES = 7;
    private static final int MOST_VERTICES = 12;
    private static final int SHORT_DIGITS = 3;
    private static final GeometryFactory GEOMETRY = new GeometryFactory();

    private AsteroidOutline() {}

    /** A new outline of 7 to 12 vertices whose enclosing circle has this radius, length. */
    public static Outline random(Rng rng, double radius) {
        if (!(radius > 0) || Double.isInfinite(radius)) {
            throw new IllegalArgumentException("radius must be positive and finite, was " + radius);
        }
        // Three of four throws are taken: the hull may swallow a point that lies too far inside, and
        // cutting may straighten a corner.
        while (true) {
            Coordinate[] ring = hull(cut(fit(hull(strewn(rng)), radius), radius));
            int vertices = ring.length - 1;
            if (vertices >= FEWEST_VERTICES && vertices <= MOST_VERTICES) {
                return counterClockwise(ring);
            }
        }
    }

    /** The area inside an outline, length². */
    public static double area(Outline outline) {
        return Area.ofRing(ring(outline));
    }

    /** The radius of the smallest circle about all vertices, wherever its centre lies; length. */
    public static double enclosingRadius(Outline outline) {
        return new MinimumBoundingCircle(GEOMETRY.createPolygon(ring(outline))).getRadius();
    }

    private static Coordinate[] strewn(Rng rng) {
        int count = FEWEST_VERTICES + 1 + rng.nextInt(MOST_VERTICES - FEWEST_VERTICES);
        double flatness = rng.between(0.72, 1);
        double turn = rng.between(0, 2 * Math.PI);
        Coordinate[] points = new Coordinate[count];
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * (i + rng.between(-0.3, 0.3)) / count;
            double reach = rng.between(0.9, 1);
            double along = reach * StrictMath.cos(angle);
            double across = reach * flatness * StrictMath.sin(angle);
            points[i] = new Coordinate(
                    along * StrictMath.cos(turn) - across * StrictMath.sin(turn),
                    along * StrictMath.sin(turn) + across * StrictMath.cos(turn));
        }
        return points;
    }

    /** The corners of the convex hull; the last repeats the first. */
    private static Coordinate[] hull(Coordinate[] points) {
        return new ConvexHull(points, GEOMETRY).getConvexHull().getCoordinates();
    }

    private static Coordinate[] fit(Coordinate[] ring, double radius) {
        var circle = new MinimumBoundingCircle(GEOMETRY.createPolygon(ring));
        Coordinate centre = circle.getCentre();
        double scale = radius / circle.getRadius();
        Coordinate[] fitted = new Coordinate[ring.length];
        for (int i = 0; i < ring.length; i++) {
            fitted[i] = new Coordinate((ring[i].x - centre.x) * scale, (ring[i].y - centre.y) * scale);
        }
        return fitted;
    }

    private static Coordinate[] cut(Coordinate[] ring, double radius) {
        BigDecimal size = BigDecimal.valueOf(radius);
        int leadingPower = size.precision() - size.scale() - 1;
        int decimals = SHORT_DIGITS - leadingPower;
        Coordinate[] shortened = new Coordinate[ring.length];
        for (int i = 0; i < ring.length; i++) {
            shortened[i] = new Coordinate(cut(ring[i].x, decimals), cut(ring[i].y, decimals));
        }
        return shortened;
    }

    private static double cut(double length, int decimals) {
        return BigDecimal.valueOf(length).setScale(decimals, RoundingMode.DOWN).doubleValue();
    }

    private static Outline counterClockwise(Coordinate[] ring) {
        if (!Orientation.isCCW(ring)) {
            CoordinateArrays.reverse(ring);
        }
        double[] xy = new double[2 * (ring.length - 1)];
        for (int i = 0; i < ring.length - 1; i++) {
            xy[2 * i] = ring[i].x;
            xy[2 * i + 1] = ring[i].y;
        }
        return new Outline(xy);
    }

    private static Coordinate[] ring(Outline outline) {
        int count = outline.count();
        Coordinate[] ring = new Coordinate[count + 1];
        for (int i = 0; i <= count; i++) {
            ring[i] = new Coordinate(outline.x(i % count), outline.y(i % count));
        }
        return ring;
    }
}
