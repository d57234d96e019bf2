package io.github.apsis.protocol.json;

import io.github.apsis.protocol.BodyState;
import io.github.apsis.protocol.Frame;
import io.github.apsis.protocol.Point;
import java.io.StringWriter;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.StreamWriteFeature;
import tools.jackson.core.json.JsonFactory;

/**
 * Writes the bodies of a frame as a JSON array, field by field. An asteroid's vertices are most of its numbers and
 * never change, so their text is kept. Pure ASCII, so its length in characters is its length in bytes. Belongs to one
 * thread.
 */
public final class FrameEncoder {
    // Doubles in their shortest form that reads back to the same bits, on JDK 17 too.
    private static final JsonFactory JSON = JsonFactory.builder()
            .enable(StreamWriteFeature.USE_FAST_DOUBLE_WRITER)
            .build();

    private final Map<Long, Shape> shapes = new HashMap<>();
    private final StringWriter text = new StringWriter(1 << 16);

    /** The text of these very vertices. */
    private record Shape(List<Point> vertices, String json) {}

    /** The array, without line breaks. */
    public String encode(Frame frame) {
        text.getBuffer().setLength(0);
        try (JsonGenerator json = JSON.createGenerator(ObjectWriteContext.empty(), text)) {
            json.writeStartArray();
            for (BodyState body : frame.bodies()) {
                write(json, body);
            }
            json.writeEndArray();
        }
        forgetTheGone(frame);
        return text.toString();
    }

    private void write(JsonGenerator json, BodyState body) {
        json.writeStartObject();
        json.writeNumberProperty("id", body.id());
        json.writeStringProperty("kind", body.kind().toString());
        writePoint(json, "position", body.position());
        writePoint(json, "velocity", body.velocity());
        writePoint(json, "acceleration", body.acceleration());
        json.writeNumberProperty("mass", body.mass());
        json.writeNumberProperty("radius", body.radius());
        json.writeBooleanProperty("selected", body.selected());
        if (body.angle() != null) {
            json.writeNumberProperty("angle", body.angle());
        }
        if (body.vertices() != null) {
            json.writeName("vertices");
            json.writeRawValue(vertices(body.id(), body.vertices()));
        }
        if (body.thrust() != null) {
            json.writeNumberProperty("thrust", body.thrust());
        }
        if (body.target() != null) {
            writePoint(json, "target", body.target());
        }
        json.writeEndObject();
    }

    private static void writePoint(JsonGenerator json, String name, Point point) {
        json.writeName(name);
        writePoint(json, point);
    }

    private static void writePoint(JsonGenerator json, Point point) {
        json.writeStartObject();
        json.writeNumberProperty("x", point.x());
        json.writeNumberProperty("y", point.y());
        json.writeEndObject();
    }

    private String vertices(long id, List<Point> vertices) {
        Shape shape = shapes.get(id);
        if (shape == null || shape.vertices != vertices) { // another list: a new world has given the id again
            shape = new Shape(vertices, text(vertices));
            shapes.put(id, shape);
        }
        return shape.json;
    }

    private static String text(List<Point> vertices) {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = JSON.createGenerator(ObjectWriteContext.empty(), text)) {
            json.writeStartArray();
            vertices.forEach(vertex -> writePoint(json, vertex));
            json.writeEndArray();
        }
        return text.toString();
    }

    private void forgetTheGone(Frame frame) {
        if (shapes.size() > 2 * frame.bodies().size() + 16) {
            shapes.clear(); // what is still there is written again with the next frame
        }
    }
}
