package io.github.apsis.benchmarks.speed;

import io.github.apsis.protocol.Frame;
import io.github.apsis.protocol.json.FrameEncoder;
import java.util.List;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A frame of the public room as the server writes it. */
final class FrameScene implements SpeedScene {
    private static final int FRAMES = 4;

    @Override
    public String name() {
        return "frames";
    }

    @Override
    public String description() {
        return "A frame of the public room written as the server writes it, by the server's own encoder. Its text is what is"
                + " allocated. `read-back`: the largest difference of a coordinate when the text is read again.";
    }

    @Override
    public void run(Bench bench) {
        int[] brief = {10, 100, 250, 1000, 2000};
        for (int n : bench.choose(new int[] {10, 50}, brief, brief)) {
            List<Frame> frames = RoomFrames.of(n, FRAMES);
            bench.measure(name(), "apsis", n, bench.choose(50, 500, 2000), () -> new Encoding(frames));
        }
    }

    private static final class Encoding implements Course {
        private final List<Frame> frames;
        private final FrameEncoder encoder = new FrameEncoder();
        private int next;
        private String text = "";

        Encoding(List<Frame> frames) {
            this.frames = frames;
        }

        @Override
        public void step() {
            text = encoder.encode(frames.get(next));
            next = (next + 1) % frames.size();
        }

        @Override
        public List<Finding> findings() {
            Frame sent = frames.get((next + frames.size() - 1) % frames.size());
            JsonNode read = JsonMapper.shared().readTree(text);
            double worst = 0;
            for (int i = 0; i < sent.bodies().size(); i++) {
                JsonNode place = read.path(i).path("position");
                worst = Math.max(
                        worst,
                        Math.abs(place.path("x").asDouble()
                                - sent.bodies().get(i).position().x()));
                worst = Math.max(
                        worst,
                        Math.abs(place.path("y").asDouble()
                                - sent.bodies().get(i).position().y()));
            }
            return List.of(new Finding("read-back", worst));
        }
    }
}
