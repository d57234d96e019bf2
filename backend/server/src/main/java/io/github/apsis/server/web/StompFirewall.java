package io.github.apsis.server.web;

import io.github.apsis.protocol.Problem;
import io.github.apsis.protocol.Problem.Code;
import lombok.RequiredArgsConstructor;
import org.jspecify.annotations.Nullable;
import org.springframework.messaging.Message;
import org.springframework.messaging.MessageChannel;
import org.springframework.messaging.simp.stomp.StompCommand;
import org.springframework.messaging.simp.stomp.StompHeaderAccessor;
import org.springframework.messaging.support.ChannelInterceptor;
import org.springframework.messaging.support.MessageHeaderAccessor;
import org.springframework.stereotype.Component;

/**
 * Lets in what the treaty lists, and nothing else: Spring's broker alone would let any client forge frames on
 * {@code /topic/bodies} or listen to everybody by {@code /topic/**}. Also where commands are rationed, and where
 * subscriptions to streams leave Spring's path: their messages go by {@link Slot}, not by the broker. That CONNECT
 * comes first is seen to by Spring.
 *
 * <p>Runs on the thread that reads from the client.
 */
@Component
@RequiredArgsConstructor
class StompFirewall implements ChannelInterceptor {
    private final ClientSessions sessions;
    private final Answers answers;

    @Override
    public @Nullable Message<?> preSend(Message<?> message, MessageChannel channel) {
        StompHeaderAccessor stomp = MessageHeaderAccessor.getAccessor(message, StompHeaderAccessor.class);
        StompCommand command = stomp == null ? null : stomp.getCommand();
        if (stomp == null || command == null || command == StompCommand.DISCONNECT) {
            return message; // a heart-beat; or a farewell, which Spring also writes itself when a socket is gone
        }
        ClientSession session = sessions.byId(stomp.getSessionId());
        return session != null && admits(command, session, stomp) ? message : null;
    }

    private boolean admits(StompCommand command, ClientSession session, StompHeaderAccessor stomp) {
        return switch (command) {
            case CONNECT, STOMP -> true;
            case SEND -> admitsSend(session, stomp);
            case SUBSCRIBE -> admitsSubscribe(session, stomp);
            case UNSUBSCRIBE -> {
                session.unsubscribe(String.valueOf(stomp.getSubscriptionId()));
                yield true;
            }
            default -> false; // ACK, NACK and transactions: nothing here needs them
        };
    }

    private boolean admitsSend(ClientSession session, StompHeaderAccessor stomp) {
        if (!isWithinRate(session)) {
            return false;
        }
        String destination = stomp.getDestination();
        if (destination == null || !Destinations.COMMANDS.contains(destination)) {
            refuse(session, "SEND", destination);
            return false;
        }
        return true;
    }

    private boolean admitsSubscribe(ClientSession session, StompHeaderAccessor stomp) {
        if (!isWithinRate(session)) {
            return false;
        }
        String destination = stomp.getDestination();
        if (destination != null && Destinations.STREAMS.contains(destination)) {
            if (!session.subscribe(String.valueOf(stomp.getSubscriptionId()), destination)) {
                answers.refuse(
                        session.getId(),
                        new Problem(Code.TOO_MANY_COMMANDS, "Too many subscriptions. End one before the next."));
            }
            return false;
        }
        if (destination == null || !Destinations.ANSWERS.contains(destination)) {
            refuse(session, "SUBSCRIBE", destination);
            return false;
        }
        return true;
    }

    private boolean isWithinRate(ClientSession session) {
        if (session.mayCommand()) {
            return true;
        }
        if (session.mayBeTold()) {
            answers.refuse(
                    session.getId(),
                    new Problem(
                            Code.TOO_MANY_COMMANDS, "Too many commands in a short time. Wait a moment, then go on."));
        } else {
            answers.refuseSilently(Code.TOO_MANY_COMMANDS);
        }
        return false;
    }

    private void refuse(ClientSession session, String command, @Nullable String destination) {
        String shown =
                destination == null || destination.length() <= 80 ? destination : destination.substring(0, 80) + "…";
        String sentence =
                "There is no " + command + " to " + shown + " here. docs/protocol/PROTOCOL.md lists what there is.";
        answers.refuse(session.getId(), new Problem(Code.UNKNOWN_DESTINATION, sentence));
    }
}
