package io.github.apsis.server.web;

import jakarta.websocket.Session;
import org.springframework.web.socket.CloseStatus;
import org.springframework.web.socket.TextMessage;
import org.springframework.web.socket.WebSocketHandler;
import org.springframework.web.socket.WebSocketMessage;
import org.springframework.web.socket.WebSocketSession;
import org.springframework.web.socket.handler.WebSocketHandlerDecorator;

/**
 * Stands between the sockets and STOMP, native and SockJS alike: wraps each socket in a {@link ClientSession}, and
 * turns away whoever sends a message beyond the size limit. A frame cut into many messages meets the same limit in
 * Spring's decoder.
 */
final class SessionGate extends WebSocketHandlerDecorator {
    /** Tomcat's name for how long a write may block before the session is closed; 20 s unless told. */
    private static final String SEND_TIMEOUT = "org.apache.tomcat.websocket.BLOCKING_SEND_TIMEOUT";

    private static final long SEND_TIMEOUT_MILLIS = 10_000;

    private final ClientSessions sessions;
    private final StompErrors errors;
    private final int limit; // bytes

    SessionGate(WebSocketHandler stomp, ClientSessions sessions, StompErrors errors, int limit) {
        super(stomp);
        this.sessions = sessions;
        this.errors = errors;
        this.limit = limit;
    }

    @Override
    public void afterConnectionEstablished(WebSocketSession socket) throws Exception {
        ClientSession session = sessions.open(socket);
        Session container = session.nativeSession(Session.class);
        if (container != null) {
            container.getUserProperties().put(SEND_TIMEOUT, SEND_TIMEOUT_MILLIS);
        }
        super.afterConnectionEstablished(session);
    }

    @Override
    public void handleMessage(WebSocketSession socket, WebSocketMessage<?> message) throws Exception {
        ClientSession session = sessions.byId(socket.getId());
        if (session == null || session.isClosing()) {
            return; // turned away already
        }
        if (message.getPayloadLength() > limit) {
            turnAway(session);
        } else {
            super.handleMessage(socket, message);
        }
    }

    @Override
    public void afterConnectionClosed(WebSocketSession socket, CloseStatus status) throws Exception {
        sessions.forget(socket.getId());
        super.afterConnectionClosed(socket, status);
    }

    private void turnAway(ClientSession session) {
        session.sendMessage(new TextMessage(errors.tooLarge()));
        session.close(CloseStatus.TOO_BIG_TO_PROCESS);
    }
}
