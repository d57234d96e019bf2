package io.github.apsis.server.web;

import lombok.RequiredArgsConstructor;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.core.task.SyncTaskExecutor;
import org.springframework.messaging.simp.config.ChannelRegistration;
import org.springframework.messaging.simp.config.MessageBrokerRegistry;
import org.springframework.scheduling.TaskScheduler;
import org.springframework.scheduling.concurrent.ThreadPoolTaskScheduler;
import org.springframework.web.socket.config.annotation.EnableWebSocketMessageBroker;
import org.springframework.web.socket.config.annotation.StompEndpointRegistry;
import org.springframework.web.socket.config.annotation.WebSocketMessageBrokerConfigurer;
import org.springframework.web.socket.config.annotation.WebSocketTransportRegistration;
import org.springframework.web.socket.sockjs.frame.JacksonJsonSockJsMessageCodec;
import org.springframework.web.socket.sockjs.frame.SockJsMessageCodec;
import org.springframework.web.socket.sockjs.transport.handler.WebSocketTransportHandler;
import org.springframework.web.socket.sockjs.transport.handler.XhrPollingTransportHandler;
import org.springframework.web.socket.sockjs.transport.handler.XhrReceivingTransportHandler;
import org.springframework.web.socket.sockjs.transport.handler.XhrStreamingTransportHandler;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.databind.json.JsonMapper;

/**
 * STOMP as the treaty wants it.
 *
 * <p>The channels have no threads of their own. A message from a client is dealt with on the thread that read it:
 * nothing on its way blocks, the commands of one session stay in order, and whoever sends too fast is held back by TCP.
 * A message to a client is put into its {@link ClientSession} on the spot. With Spring's pools ten clients that stop
 * reading freeze the stream for everybody, because blocking sends use up the threads.
 */
@Configuration
@EnableWebSocketMessageBroker
@RequiredArgsConstructor
class StompConfig implements WebSocketMessageBrokerConfigurer {
    private static final long HEARTBEAT_MILLIS = 10_000;
    private static final int TIME_TO_FIRST_MESSAGE_MILLIS = 10_000;

    /** A second or two of frames before xhr-streaming begins a new response. */
    private static final int STREAMING_BYTES = 4 << 20;

    /** Far beyond any command, so that whoever sends too much is still told so; far below the memory. */
    private static final int POSTED_BYTES = 4 << 20;

    private final ApsisProperties properties;
    private final StompFirewall firewall;
    private final StompErrors errors;
    private final ClientSessions sessions;
    private final SessionLimit sessionLimit;

    @Override
    public void registerStompEndpoints(StompEndpointRegistry registry) {
        String[] origins = properties.allowedOrigins().toArray(String[]::new);
        Handshakes handshakes = new Handshakes(properties.limits().messageBytes());
        registry.setErrorHandler(errors);
        registry.addEndpoint(Destinations.ENDPOINT)
                .setHandshakeHandler(handshakes)
                .addInterceptors(sessionLimit)
                .setAllowedOrigins(origins);
        // Not the transports that need an iframe: they are for browsers of 2011, and the page forbids frames.
        registry.addEndpoint(Destinations.ENDPOINT)
                .addInterceptors(sessionLimit)
                .setAllowedOrigins(origins)
                .withSockJS()
                .setTransportHandlers(
                        new WebSocketTransportHandler(handshakes),
                        new XhrStreamingTransportHandler(),
                        new XhrPollingTransportHandler(),
                        new XhrReceivingTransportHandler())
                .setMessageCodec(sockJsCodec())
                .setStreamBytesLimit(STREAMING_BYTES)
                .setSessionCookieNeeded(false);
    }

    /** A body that is posted is read before anybody can look at its size: this is where it ends. */
    private static SockJsMessageCodec sockJsCodec() {
        StreamReadConstraints limits = StreamReadConstraints.builder()
                .maxStringLength(POSTED_BYTES)
                .maxDocumentLength(POSTED_BYTES)
                .build();
        return new JacksonJsonSockJsMessageCodec(JsonMapper.builder(
                        JsonFactory.builder().streamReadConstraints(limits).build())
                .build());
    }

    @Override
    public void configureMessageBroker(MessageBrokerRegistry registry) {
        registry.setApplicationDestinationPrefixes("/app");
        registry.setUserDestinationPrefix("/user");
        registry.enableSimpleBroker("/topic", "/queue")
                .setTaskScheduler(heartbeats())
                .setHeartbeatValue(new long[] {HEARTBEAT_MILLIS, HEARTBEAT_MILLIS});
    }

    @Override
    public void configureClientInboundChannel(ChannelRegistration inbound) {
        inbound.executor(new SyncTaskExecutor()).interceptors(firewall);
    }

    @Override
    public void configureClientOutboundChannel(ChannelRegistration outbound) {
        outbound.executor(new SyncTaskExecutor());
    }

    @Override
    public void configureWebSocketTransport(WebSocketTransportRegistration transport) {
        int messageBytes = properties.limits().messageBytes();
        transport.setMessageSizeLimit(messageBytes);
        transport.setTimeToFirstMessage(TIME_TO_FIRST_MESSAGE_MILLIS);
        transport.addDecoratorFactory(stomp -> new SessionGate(stomp, sessions, errors, messageBytes));
    }

    @Bean
    TaskScheduler heartbeats() {
        ThreadPoolTaskScheduler scheduler = new ThreadPoolTaskScheduler();
        scheduler.setThreadNamePrefix("heartbeat-");
        scheduler.setDaemon(true);
        return scheduler;
    }
}
