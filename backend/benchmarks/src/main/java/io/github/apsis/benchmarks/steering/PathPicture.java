package io.github.apsis.benchmarks.steering;

import java.util.Locale;

/** The paths of all ships of a scene as SVG: one colour for each and a dot where it ends. */
final class PathPicture {
    private static final int SIZE_PX = 640;
    private static final int EDGE_PX = 20;
    private static final int TICKS_PER_POINT = 20;

    private final SceneState state;
    private final Pilot pilot;
    private final StringBuilder[] paths;
    private double reach; // of all places, from the origin, length

    PathPicture(SteeringScene scene, Contender contender) {
        state = new SceneState(scene);
        pilot = contender.pilot(state);
        paths = new StringBuilder[state.ships];
        for (int i = 0; i < state.ships; i++) {
            paths[i] = new StringBuilder();
            reach = Math.max(reach, Math.max(Math.abs(state.x[i]), Math.abs(state.y[i])));
            reach = Math.max(reach, Math.max(Math.abs(state.goalX[i]), Math.abs(state.goalY[i])));
        }
    }

    /** Runs the scene and draws it. */
    String svg() {
        while (state.tick < state.scene.ticks() && state.liveCount > 0) {
            if (state.tick % TICKS_PER_POINT == 0) {
                markAll();
            }
            step();
        }
        var svg = new StringBuilder(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\">\n".formatted(SIZE_PX, SIZE_PX));
        svg.append("<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n");
        for (int i = 0; i < state.ships; i++) {
            String color = "hsl(%d 65%% 42%%)".formatted(360 * i / state.ships);
            svg.append("<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"1.2\" points=\"%s\"/>\n"
                    .formatted(color, paths[i].toString().strip()));
            svg.append("<circle cx=\"%s\" cy=\"%s\" r=\"3\" fill=\"%s\"/>\n"
                    .formatted(px(state.x[i]), px(-state.y[i]), color));
        }
        return svg.append("</svg>\n").toString();
    }

    private void step() {
        state.turnHeadings();
        pilot.look(state);
        pilot.steer(state);
        for (int i = 0; i < state.ships; i++) {
            if (state.live[i]) {
                state.limitThrust(i);
            }
        }
        state.move();
        for (int i = 0; i < state.ships && state.scene.dock(); i++) {
            if (state.live[i] && state.hasDocked(i)) {
                mark(i);
                state.remove(i);
            }
        }
    }

    private void markAll() {
        for (int i = 0; i < state.ships; i++) {
            if (state.live[i]) {
                mark(i);
            }
        }
    }

    private void mark(int i) {
        paths[i].append(px(state.x[i])).append(',').append(px(-state.y[i])).append(' ');
    }

    private String px(double place) {
        return String.format(Locale.ROOT, "%.1f", SIZE_PX / 2.0 + place / (1.1 * reach) * (SIZE_PX / 2.0 - EDGE_PX));
    }
}
