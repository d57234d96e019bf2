package io.github.apsis.server.web;

import io.github.apsis.protocol.ClientMessage;
import io.github.apsis.protocol.Problem.Code;
import org.jspecify.annotations.Nullable;
import org.springframework.stereotype.Component;
import tools.jackson.core.JacksonException;
import tools.jackson.core.json.JsonReadFeature;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Reads the JSON of a command and checks its shape: whatever comes out is a finite number, a positive id, a true or
 * false. Field by field rather than bound to a record, so that a client learns which field is wrong. Unknown fields are
 * ignored.
 *
 * @see RefusedException what it throws for everything else
 */
@Component
final class CommandReader {
    // NaN and Infinity are not JSON; taken in here, they are refused below with the name of their field.
    private final JsonMapper json = JsonMapper.builder()
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();

    ClientMessage.Select select(byte @Nullable [] body) {
        JsonNode command = object(body);
        return new ClientMessage.Select(id(command), truth(command, "selected"));
    }

    ClientMessage.Delete delete(byte @Nullable [] body) {
        return new ClientMessage.Delete(id(object(body)));
    }

    ClientMessage.Move move(byte @Nullable [] body) {
        JsonNode command = object(body);
        return new ClientMessage.Move(finite(command, "x"), finite(command, "y"));
    }

    private JsonNode object(byte @Nullable [] body) {
        JsonNode node = parse(body == null ? new byte[0] : body);
        if (!node.isObject()) {
            throw new RefusedException(Code.MALFORMED_JSON, "The message must be a JSON object, such as {\"id\":17}.");
        }
        return node;
    }

    private JsonNode parse(byte[] body) {
        try {
            return json.readTree(body);
        } catch (JacksonException e) {
            throw new RefusedException(
                    Code.MALFORMED_JSON, "The message is not JSON. Check quotes, commas and braces.");
        }
    }

    private static long id(JsonNode command) {
        JsonNode node = field(command, "id");
        if (!node.isIntegralNumber() || !node.canConvertToLong() || node.longValue() <= 0) {
            throw invalid("id", "a positive integer", node);
        }
        return node.longValue();
    }

    private static boolean truth(JsonNode command, String name) {
        JsonNode node = field(command, name);
        if (!node.isBoolean()) {
            throw invalid(name, "true or false", node);
        }
        return node.booleanValue();
    }

    private static double finite(JsonNode command, String name) {
        JsonNode node = field(command, name);
        if (!node.isNumber() || !Double.isFinite(node.asDouble(Double.NaN))) {
            throw invalid(name, "a finite number", node);
        }
        return node.doubleValue();
    }

    private static JsonNode field(JsonNode command, String name) {
        JsonNode node = command.get(name);
        if (node == null) {
            throw new RefusedException(Code.MISSING_FIELD, "The field \"" + name + "\" is missing.", name);
        }
        return node;
    }

    private static RefusedException invalid(String field, String allowed, JsonNode was) {
        String text = was.isNumber() ? was.asString() : was.toString(); // as JSON, Infinity would get quotes
        String shown = text.length() > 40 ? text.substring(0, 40) + "…" : text;
        return new RefusedException(
                Code.INVALID_VALUE, "\"" + field + "\" must be " + allowed + ", was " + shown + ".", field);
    }
}
