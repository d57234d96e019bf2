package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.engine.WorldSpec;
import java.util.List;
import java.util.function.UnaryOperator;

/** S3: the forces in a disc of equal masses, by one of the sums that the engine has. */
final class GravityScene implements SpeedScene {
    private static final double RADIUS = 1000;
    private static final double SOFTENING = 1;

    private final String name;
    private final String description;
    private final double softening;
    private final List<Sum> sums;
    private final Sizes sizes;

    /** A way to sum gravity, as the engine column names it. */
    private record Sum(String label, UnaryOperator<WorldSpec.Builder> method) {}

    private record Sizes(int[] glimpse, int[] brief, int[] full) {}

    private GravityScene(String name, String description, double softening, List<Sum> sums, Sizes sizes) {
        this.name = name;
        this.description = description;
        this.softening = softening;
        this.sums = sums;
        this.sizes = sizes;
    }

    static GravityScene direct() {
        return new GravityScene(
                "s3-direct",
                "Gravity of every pair in a disc of equal masses, radius 1000, softening 1: one evaluation. `force-rms`,"
                        + " `force-median`, `force-worst`: against a compensated direct sum.",
                SOFTENING,
                List.of(new Sum("apsis", spec -> spec)),
                new Sizes(new int[] {10, 100}, new int[] {10, 100, 1000, 3000, 10_000}, new int[] {
                    10, 100, 300, 1000, 3000, 10_000, 30_000
                }));
    }

    static GravityScene tree() {
        return new GravityScene(
                "s3-tree",
                "The same by the tree with an opening angle of 0.5; the errors on a sample of bodies from 20 000 on.",
                SOFTENING,
                List.of(new Sum("apsis", spec -> spec.tree(0.5))),
                new Sizes(new int[] {100, 300}, new int[] {100, 1000, 10_000, 100_000}, new int[] {
                    10, 100, 1000, 10_000, 100_000, 1_000_000
                }));
    }

    /** From cheap to exact, at one size. */
    static GravityScene ladder() {
        return new GravityScene(
                "disc-10k",
                "The same disc of 10 000 masses without softening, by trees of several opening angles and by allowed errors.",
                0,
                List.of(
                        tree(1),
                        tree(0.7),
                        tree(0.5),
                        tree(0.35),
                        tree(0.25),
                        allowing(3e-3),
                        allowing(1e-3),
                        allowing(1e-4)),
                new Sizes(new int[] {200}, new int[] {10_000}, new int[] {10_000}));
    }

    private static Sum tree(double theta) {
        return new Sum("apsis-tree-" + Cells.plain(theta), spec -> spec.tree(theta));
    }

    private static Sum allowing(double error) {
        return new Sum("apsis-error-" + Cells.times(error), spec -> spec.forceError(error));
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public String description() {
        return description;
    }

    @Override
    public boolean usesThreads() {
        return true;
    }

    @Override
    public void run(Bench bench) {
        for (int n : bench.choose(sizes.glimpse, sizes.brief, sizes.full)) {
            MassDisc disc = new MassDisc(n, RADIUS, softening);
            for (Sum sum : sums) {
                WorldSpec spec = bench.spec(sum.method().apply(disc.laws()));
                bench.measure(
                        name, sum.label(), n, bench.choose(20, 500, 4000), () -> new ForceCourse(disc.world(spec)));
            }
        }
    }
}
