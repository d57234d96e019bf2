package io.github.apsis.server.web;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import org.springframework.web.socket.BinaryMessage;
import org.springframework.web.socket.TextMessage;
import org.springframework.web.socket.WebSocketHandler;
import org.springframework.web.socket.WebSocketMessage;
import org.springframework.web.socket.WebSocketSession;
import org.springframework.web.socket.handler.WebSocketHandlerDecorator;
import org.springframework.web.socket.sockjs.transport.handler.SockJsWebSocketHandler;

/**
 * Puts the parts of one connection's messages together. Left to Tomcat, a message beyond its buffer ends the connection
 * without a word; here it is cut off just beyond the limit and handed on, so that {@link SessionGate} can say why, and
 * no client can make the server hold more than the limit.
 */
final class WholeMessages extends WebSocketHandlerDecorator {
    /** In SockJS's JSON a text of quotes and line feeds takes twice its length. */
    private static final int SOCKJS_FACTOR = 2;

    private final int limit; // bytes
    private final boolean sockJs;
    private final StringBuilder text = new StringBuilder();
    private final ByteArrayOutputStream binary = new ByteArrayOutputStream();
    private boolean discarding;

    WholeMessages(WebSocketHandler handler, int messageBytes) {
        super(handler);
        this.sockJs = WebSocketHandlerDecorator.unwrap(handler) instanceof SockJsWebSocketHandler;
        this.limit = sockJs ? SOCKJS_FACTOR * messageBytes + 64 : messageBytes;
    }

    @Override
    public boolean supportsPartialMessages() {
        return true;
    }

    @Override
    public void handleMessage(WebSocketSession session, WebSocketMessage<?> part) throws Exception {
        if (part instanceof TextMessage message) {
            handleText(session, message);
        } else if (part instanceof BinaryMessage message) {
            handleBinary(session, message);
        } else {
            super.handleMessage(session, part);
        }
    }

    private void handleText(WebSocketSession session, TextMessage part) throws Exception {
        if (!discarding) {
            text.append(part.getPayload());
        }
        if (text.length() > limit) {
            text.setLength(0);
            discarding = true;
            super.handleMessage(session, tooLarge());
        }
        if (part.isLast()) {
            boolean whole = !discarding;
            String message = text.toString();
            text.setLength(0);
            discarding = false;
            if (whole) {
                super.handleMessage(session, new TextMessage(message));
            }
        }
    }

    private void handleBinary(WebSocketSession session, BinaryMessage part) throws Exception {
        ByteBuffer payload = part.getPayload();
        if (!discarding) {
            byte[] bytes = new byte[payload.remaining()];
            payload.get(bytes);
            binary.writeBytes(bytes);
        }
        if (binary.size() > limit) {
            binary.reset();
            discarding = true;
            super.handleMessage(session, tooLarge());
        }
        if (part.isLast()) {
            boolean whole = !discarding;
            byte[] message = binary.toByteArray();
            binary.reset();
            discarding = false;
            if (whole) {
                super.handleMessage(session, new BinaryMessage(message));
            }
        }
    }

    /** The smallest message that the gate finds too large; SockJS wants it in its JSON. */
    private TextMessage tooLarge() {
        String beyond = "x".repeat(limit + 1);
        return new TextMessage(sockJs ? "[\"" + beyond + "\"]" : beyond);
    }
}
