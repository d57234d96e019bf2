package io.github.apsis.server.web;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.protocol.BodyState;
import io.github.apsis.protocol.Problem;
import io.github.apsis.protocol.Reply;
import jakarta.websocket.ContainerProvider;
import jakarta.websocket.WebSocketContainer;
import java.lang.reflect.Type;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.springframework.messaging.converter.SimpleMessageConverter;
import org.springframework.messaging.simp.stomp.StompFrameHandler;
import org.springframework.messaging.simp.stomp.StompHeaders;
import org.springframework.messaging.simp.stomp.StompSession;
import org.springframework.messaging.simp.stomp.StompSessionHandlerAdapter;
import org.springframework.web.socket.client.WebSocketClient;
import org.springframework.web.socket.client.standard.StandardWebSocketClient;
import org.springframework.web.socket.messaging.WebSocketStompClient;
import org.springframework.web.socket.sockjs.client.RestTemplateXhrTransport;
import org.springframework.web.socket.sockjs.client.SockJsClient;
import org.springframework.web.socket.sockjs.client.WebSocketTransport;
import tools.jackson.databind.json.JsonMapper;

/** A client like the page: subscribed to everything, over any transport. */
final class TestClient implements AutoCloseable {
    static final int PATIENCE_SECONDS = 15;

    private static final int LARGE = 8 << 20;

    private final JsonMapper json = JsonMapper.builder().build();
    private final BlockingQueue<Problem> problems = new LinkedBlockingQueue<>();
    private final BlockingQueue<Reply> replies = new LinkedBlockingQueue<>();
    private final BlockingQueue<Heard> frames = new LinkedBlockingQueue<>();
    private final BlockingQueue<Heard> diagnostics = new LinkedBlockingQueue<>();
    private final StompSession session;

    /** One message as it came. */
    record Heard(StompHeaders headers, String body) {
        long tick() {
            return Long.parseLong(String.valueOf(headers.getFirst("tick")));
        }
    }

    enum Transport {
        NATIVE,
        SOCKJS_WEBSOCKET,
        SOCKJS_XHR
    }

    private TestClient(Transport transport, int port) throws Exception {
        WebSocketStompClient stomp = new WebSocketStompClient(socketClient(transport));
        stomp.setInboundMessageSizeLimit(LARGE);
        stomp.setMessageConverter(new SimpleMessageConverter());
        String scheme = transport == Transport.NATIVE ? "ws" : "http";
        session = stomp.connectAsync(
                        scheme + "://localhost:" + port + Destinations.ENDPOINT, new StompSessionHandlerAdapter() {})
                .get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        hear("/user/queue/errors", heard -> problems.add(json.readValue(heard.body, Problem.class)));
        hear("/user/queue/replies", heard -> replies.add(json.readValue(heard.body, Reply.class)));
        hear("/topic/diagnostics", diagnostics::add);
        hear("/topic/bodies", frames::add);
    }

    /** Connected, subscribed, and one frame has come. */
    static TestClient connect(Transport transport, int port) throws Exception {
        TestClient client = new TestClient(transport, port);
        client.frame();
        return client;
    }

    static TestClient connect(int port) throws Exception {
        return connect(Transport.NATIVE, port);
    }

    private static WebSocketClient socketClient(Transport transport) {
        WebSocketContainer container = ContainerProvider.getWebSocketContainer();
        container.setDefaultMaxTextMessageBufferSize(LARGE);
        StandardWebSocketClient plain = new StandardWebSocketClient(container);
        return switch (transport) {
            case NATIVE -> plain;
            case SOCKJS_WEBSOCKET -> new SockJsClient(List.of(new WebSocketTransport(plain)));
            case SOCKJS_XHR -> new SockJsClient(List.of(new RestTemplateXhrTransport()));
        };
    }

    /** Hands each message to the listener, in order. */
    void hear(String destination, java.util.function.Consumer<Heard> listener) {
        session.subscribe(destination, new StompFrameHandler() {
            @Override
            public Type getPayloadType(StompHeaders headers) {
                return byte[].class;
            }

            @Override
            public void handleFrame(StompHeaders headers, @Nullable Object payload) {
                listener.accept(new Heard(headers, new String((byte[]) payload, StandardCharsets.UTF_8)));
            }
        });
    }

    void send(String destination) {
        send(destination, "");
    }

    void send(String destination, String body) {
        session.send(destination, body.getBytes(StandardCharsets.UTF_8));
    }

    Problem problem() throws InterruptedException {
        return next(problems);
    }

    Reply reply() throws InterruptedException {
        return next(replies);
    }

    Heard diagnostics() throws InterruptedException {
        diagnostics.clear();
        return next(diagnostics);
    }

    /** The next frame that comes. */
    Heard frame() throws InterruptedException {
        frames.clear();
        return next(frames);
    }

    List<BodyState> bodies() throws InterruptedException {
        return List.of(json.readValue(frame().body, BodyState[].class));
    }

    Optional<BodyState> body(long id) throws InterruptedException {
        return bodies().stream().filter(body -> body.id() == id).findFirst();
    }

    /** Waits until a frame shows the body like this; each look is at a new frame. */
    BodyState await(long id, Predicate<BodyState> wanted) throws InterruptedException {
        return awaitBodies(bodies -> bodies.stream().anyMatch(body -> body.id() == id && wanted.test(body))).stream()
                .filter(body -> body.id() == id)
                .findFirst()
                .orElseThrow();
    }

    List<BodyState> awaitBodies(Predicate<List<BodyState>> wanted) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(2 * PATIENCE_SECONDS);
        List<BodyState> bodies = bodies();
        while (!wanted.test(bodies)) {
            assertThat(System.nanoTime())
                    .as("waited in vain; the last frame was " + bodies)
                    .isLessThan(end);
            bodies = bodies();
        }
        return bodies;
    }

    List<Problem> problemsSoFar() {
        List<Problem> all = new ArrayList<>();
        problems.drainTo(all);
        return all;
    }

    List<Reply> repliesSoFar() {
        List<Reply> all = new ArrayList<>();
        replies.drainTo(all);
        return all;
    }

    private static <T> T next(BlockingQueue<T> queue) throws InterruptedException {
        T next = queue.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
        assertThat(next).as("nothing came within " + PATIENCE_SECONDS + " s").isNotNull();
        return next;
    }

    @Override
    public void close() {
        if (session.isConnected()) {
            session.disconnect();
        }
    }
}
