package io.github.apsis.engine.math;

/** The arithmetic of a world that repeats itself: where a point is inside one period, and the nearest image of a distance. */
public final class Period {
    private final Aabb box;
    private final double width;
    private final double height;

    public Period(Aabb box) {
        this.box = box;
        this.width = box.width();
        this.height = box.height();
    }

    public double width() {
        return width;
    }

    public double height() {
        return height;
    }

    /** The same distance to the nearest image, −width/2 … width/2. */
    public double nearestX(double dx) {
        return dx - width * Math.rint(dx / width);
    }

    public double nearestY(double dy) {
        return dy - height * Math.rint(dy / height);
    }

    /** The same point inside the box. */
    public double insideX(double x) {
        return inside(x, box.minX(), box.maxX(), width);
    }

    public double insideY(double y) {
        return inside(y, box.minY(), box.maxY(), height);
    }

    private static double inside(double value, double min, double max, double period) {
        if (value >= min && value < max) {
            return value; // untouched to the bit, and by far the usual case
        }
        double wrapped = value - period * Math.floor((value - min) / period);
        return wrapped < max ? Math.max(wrapped, min) : min; // rounding may land on the far side
    }
}
