package io.github.apsis.server.web;

import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.protocol.Problem;
import io.github.apsis.protocol.Problem.Code;
import io.github.apsis.server.room.Edges;
import io.github.apsis.server.room.Outcome.Reason;
import io.github.apsis.server.room.Request;
import io.github.apsis.server.room.RoomSpec;
import java.math.BigDecimal;

/** Says for people why a room has refused: what happened, then what to do. */
final class Problems {
    private Problems() {}

    static Problem of(Reason reason, Request request, RoomSpec room) {
        return switch (reason) {
            case NO_SUCH_BODY ->
                new Problem(
                        Code.NO_SUCH_BODY,
                        "There is no body " + bodyOf(request) + ". It may have been removed; choose another.",
                        "id");
            case NO_SHIP_SELECTED ->
                new Problem(Code.NO_SHIP_SELECTED, "You have selected no ship. Select one, then send it off.");
            case OUTSIDE_WORLD -> outsideWorld(request, room);
            case WORLD_FULL ->
                new Problem(
                        Code.WORLD_FULL,
                        "This room holds " + room.maxBodies() + " bodies and no more. Remove one to add another.");
            case NO_ROOM ->
                new Problem(Code.NO_ROOM, "There is no room for another body here. Remove one and try again.");
            case ROOM_BUSY -> new Problem(Code.ROOM_BUSY, "The room is busy. Try again in a moment.");
        };
    }

    private static String bodyOf(Request request) {
        BodyId body = null;
        if (request instanceof Request.Select select) {
            body = select.body();
        } else if (request instanceof Request.Deselect deselect) {
            body = deselect.body();
        } else if (request instanceof Request.Remove remove) {
            body = remove.body();
        }
        return body == null ? "" : String.valueOf(body.value());
    }

    private static Problem outsideWorld(Request request, RoomSpec room) {
        Aabb box = Edges.box(room.scene().spec(room.seed()).boundary()).orElse(null);
        if (box == null || !(request instanceof Request.MoveSelectedShips move)) {
            return new Problem(Code.OUTSIDE_WORLD, "That place lies outside the world.");
        }
        String field = move.x() < box.minX() || move.x() > box.maxX() ? "x" : "y";
        String sentence = "The target (" + plain(move.x()) + ", " + plain(move.y())
                + ") lies outside the world. Choose a point inside x " + plain(box.minX()) + " to " + plain(box.maxX())
                + ", y " + plain(box.minY()) + " to " + plain(box.maxY()) + ".";
        return new Problem(Code.OUTSIDE_WORLD, sentence, field);
    }

    /** 5000 rather than 5000.0 or 5E+3; 1E+300 rather than three hundred digits. */
    private static String plain(double value) {
        BigDecimal number = BigDecimal.valueOf(value).stripTrailingZeros();
        return Math.abs(value) < 1e9 ? number.toPlainString() : number.toString();
    }
}
