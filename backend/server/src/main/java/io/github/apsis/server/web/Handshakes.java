package io.github.apsis.server.web;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletRequestWrapper;
import java.util.Collections;
import java.util.Enumeration;
import java.util.Map;
import org.springframework.http.server.ServerHttpRequest;
import org.springframework.http.server.ServerHttpResponse;
import org.springframework.http.server.ServletServerHttpRequest;
import org.springframework.web.socket.WebSocketHandler;
import org.springframework.web.socket.WebSocketHttpHeaders;
import org.springframework.web.socket.server.HandshakeHandler;
import org.springframework.web.socket.server.support.DefaultHandshakeHandler;

/**
 * How a WebSocket begins, native or inside SockJS: without compression, and with {@link WholeMessages} around its
 * handler.
 *
 * <p>permessage-deflate, which browsers always offer and Tomcat always takes, costs 5 to 50 times the CPU of a frame,
 * for each client and each frame (measured: 33 to 203 µs at 1000 bodies).
 */
final class Handshakes implements HandshakeHandler {
    private final HandshakeHandler spring = new DefaultHandshakeHandler();
    private final int messageBytes;

    Handshakes(int messageBytes) {
        this.messageBytes = messageBytes;
    }

    @Override
    public boolean doHandshake(
            ServerHttpRequest request,
            ServerHttpResponse response,
            WebSocketHandler handler,
            Map<String, Object> attributes) {
        HttpServletRequest servletRequest = ((ServletServerHttpRequest) request).getServletRequest();
        ServerHttpRequest plain = new ServletServerHttpRequest(new WithoutExtensions(servletRequest));
        return spring.doHandshake(plain, response, new WholeMessages(handler, messageBytes), attributes);
    }

    /**
     * Spring can choose no extension, but Tomcat reads that as no preference and agrees on deflate: so it sees no
     * offer.
     */
    private static final class WithoutExtensions extends HttpServletRequestWrapper {
        WithoutExtensions(HttpServletRequest request) {
            super(request);
        }

        @Override
        public Enumeration<String> getHeaders(String name) {
            return WebSocketHttpHeaders.SEC_WEBSOCKET_EXTENSIONS.equalsIgnoreCase(name)
                    ? Collections.emptyEnumeration()
                    : super.getHeaders(name);
        }
    }
}
