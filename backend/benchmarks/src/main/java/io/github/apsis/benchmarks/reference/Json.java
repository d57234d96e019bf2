package io.github.apsis.benchmarks.reference;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import tools.jackson.core.JacksonException;
import tools.jackson.core.json.JsonReadFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Reads JSON whose numbers may be strings, so that they can hold {@code NaN} or more digits than a double. */
public final class Json {
    private static final JsonMapper MAPPER = JsonMapper.builder()
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .build();

    private Json() {}

    /** @throws IllegalArgumentException when the file is not JSON */
    public static JsonNode read(Path file) throws IOException {
        try {
            return MAPPER.readTree(Files.readString(file));
        } catch (JacksonException e) {
            throw new IllegalArgumentException("it is not JSON: " + e.getOriginalMessage(), e);
        }
    }

    /** @throws IllegalArgumentException when the field is not there */
    public static JsonNode field(JsonNode object, String name) {
        JsonNode value = object.get(name);
        if (value == null || value.isNull()) {
            throw new IllegalArgumentException("it has no " + name);
        }
        return value;
    }

    public static double number(JsonNode object, String name) {
        return valueOf(field(object, name), "its " + name);
    }

    /** The number of a field, or this one where the field is not there. */
    public static double number(JsonNode object, String name, double otherwise) {
        return object.hasNonNull(name) ? number(object, name) : otherwise;
    }

    /** A number, or a string that says one: {@code 0.5}, {@code "0.5"}, {@code "1/150"}, {@code "NaN"}. */
    public static double valueOf(JsonNode value, String what) {
        if (value.isNumber()) {
            return value.asDouble();
        }
        if (value.isString()) {
            return Fraction.parse(value.asString());
        }
        throw new IllegalArgumentException(what + " is not a number: " + value);
    }

    /** The numbers of a list. */
    public static double[] numbers(JsonNode list, String what) {
        if (!list.isArray()) {
            throw new IllegalArgumentException(what + " is not in a list: " + list);
        }
        double[] numbers = new double[list.size()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = valueOf(list.get(i), what);
        }
        return numbers;
    }

    public static String text(JsonNode object, String name) {
        return field(object, name).asString("");
    }
}
