package io.github.apsis.server.web;

import io.github.apsis.protocol.Problem;
import io.github.apsis.protocol.Reply;
import org.springframework.context.annotation.Lazy;
import org.springframework.messaging.MessageHeaders;
import org.springframework.messaging.simp.SimpMessageHeaderAccessor;
import org.springframework.messaging.simp.SimpMessageType;
import org.springframework.messaging.simp.SimpMessagingTemplate;
import org.springframework.stereotype.Component;

/** Tells one client what became of its commands. Sends at once and never blocks: what is sent waits in its session. */
@Component
class Answers {
    private final SimpMessagingTemplate stomp;
    private final Refusals refusals;

    // Lazy: the inbound channel answers through the broker, which is built after it.
    Answers(@Lazy SimpMessagingTemplate stomp, Refusals refusals) {
        this.stomp = stomp;
        this.refusals = refusals;
    }

    void reply(String session, Reply reply) {
        send(session, Destinations.REPLIES, reply);
    }

    void refuse(String session, Problem problem) {
        refusals.count(problem.code());
        send(session, Destinations.ERRORS, problem);
    }

    /** Counted, but not told. */
    void refuseSilently(Problem.Code code) {
        refusals.count(code);
    }

    private void send(String session, String queue, Object answer) {
        stomp.convertAndSendToUser(session, queue, answer, headers(session));
    }

    private static MessageHeaders headers(String session) {
        SimpMessageHeaderAccessor headers = SimpMessageHeaderAccessor.create(SimpMessageType.MESSAGE);
        headers.setSessionId(session);
        headers.setLeaveMutable(true);
        return headers.getMessageHeaders();
    }
}
