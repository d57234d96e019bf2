package io.github.apsis.server.web;

import io.github.apsis.protocol.Problem;
import io.github.apsis.server.room.ClientId;
import io.github.apsis.server.room.OpenRoom;
import io.github.apsis.server.room.Outcome;
import io.github.apsis.server.room.Request;
import io.github.apsis.server.room.Rooms;
import jakarta.annotation.PreDestroy;
import java.util.Objects;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.springframework.context.event.EventListener;
import org.springframework.messaging.simp.SimpMessageHeaderAccessor;
import org.springframework.scheduling.concurrent.CustomizableThreadFactory;
import org.springframework.stereotype.Component;
import org.springframework.web.socket.messaging.SessionDisconnectEvent;

/** Takes requests to their room, and its answers back to the client who asked. May be used from any thread. */
@Component
class CommandDesk {
    /** The one room of today. */
    static final String PUBLIC_ROOM = "public";

    private static final int MOST_WAITING_ANSWERS = 10_000;

    private final Rooms rooms;
    private final Answers answers;

    /** One thread, so answers keep their order; not the room's, which has a world to move. */
    private final ExecutorService messenger;

    CommandDesk(Rooms rooms, Answers answers) {
        this.rooms = rooms;
        this.answers = answers;
        CustomizableThreadFactory threads = new CustomizableThreadFactory("answer-");
        threads.setDaemon(true);
        this.messenger = new ThreadPoolExecutor(
                1,
                1,
                0,
                TimeUnit.SECONDS,
                new LinkedBlockingQueue<>(MOST_WAITING_ANSWERS),
                threads,
                new ThreadPoolExecutor.DiscardPolicy());
    }

    OpenRoom room() {
        return rooms.byId(PUBLIC_ROOM).orElseThrow();
    }

    void take(SimpMessageHeaderAccessor from, Request request) {
        String session = Objects.requireNonNull(from.getSessionId());
        String destination = Objects.requireNonNull(from.getDestination());
        String command = destination.substring(destination.lastIndexOf('/') + 1);
        room().submit(
                        new ClientId(session),
                        request,
                        outcome -> messenger.execute(() -> answer(session, command, request, outcome)));
    }

    void refuse(SimpMessageHeaderAccessor from, Problem problem) {
        answers.refuse(Objects.requireNonNull(from.getSessionId()), problem);
    }

    private void answer(String session, String command, Request request, Outcome outcome) {
        if (outcome instanceof Outcome.Done done) {
            answers.reply(session, ProtocolMapper.toReply(command, done));
        } else {
            Outcome.Reason reason = ((Outcome.Refused) outcome).reason();
            answers.refuse(session, Problems.of(reason, request, room().spec()));
        }
    }

    @EventListener
    void left(SessionDisconnectEvent event) {
        rooms.leave(new ClientId(event.getSessionId()));
    }

    @PreDestroy
    void stop() {
        messenger.shutdown();
    }
}
