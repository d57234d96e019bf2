package io.github.apsis.benchmarks.speed;

import java.util.ArrayList;
import java.util.List;

/** A course whose steps differ, so that what all of them took together says more than one of them. */
final class ClockedCourse implements Course {
    private static final double SECONDS = 1e-9;

    private final Course course;
    private long nanos;

    ClockedCourse(Course course) {
        this.course = course;
    }

    @Override
    public void step() {
        long before = System.nanoTime();
        course.step();
        nanos += System.nanoTime() - before;
    }

    @Override
    public void look() {
        course.look();
    }

    @Override
    public List<Finding> findings() {
        List<Finding> findings = new ArrayList<>(course.findings());
        findings.add(new Finding("seconds", SECONDS * nanos));
        return findings;
    }

    @Override
    public void end() {
        course.end();
    }
}
