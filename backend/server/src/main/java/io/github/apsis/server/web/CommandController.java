package io.github.apsis.server.web;

import io.github.apsis.protocol.ClientMessage.Add;
import io.github.apsis.protocol.Kind;
import io.github.apsis.protocol.RoomInfo;
import lombok.RequiredArgsConstructor;
import org.jspecify.annotations.Nullable;
import org.springframework.messaging.handler.annotation.MessageExceptionHandler;
import org.springframework.messaging.handler.annotation.MessageMapping;
import org.springframework.messaging.handler.annotation.Payload;
import org.springframework.messaging.simp.SimpMessageHeaderAccessor;
import org.springframework.messaging.simp.annotation.SubscribeMapping;
import org.springframework.stereotype.Controller;

/** The commands of the treaty: read, map, hand over. */
@Controller
@RequiredArgsConstructor
class CommandController {
    private final CommandReader reader;
    private final CommandDesk desk;

    @MessageMapping("/random-planet")
    void randomPlanet(SimpMessageHeaderAccessor from) {
        desk.take(from, ProtocolMapper.toRequest(new Add(Kind.PLANET)));
    }

    @MessageMapping("/random-asteroid")
    void randomAsteroid(SimpMessageHeaderAccessor from) {
        desk.take(from, ProtocolMapper.toRequest(new Add(Kind.ASTEROID)));
    }

    @MessageMapping("/random-spaceship")
    void randomSpaceship(SimpMessageHeaderAccessor from) {
        desk.take(from, ProtocolMapper.toRequest(new Add(Kind.SHIP)));
    }

    @MessageMapping("/random-body")
    void randomBody(SimpMessageHeaderAccessor from) {
        desk.take(from, ProtocolMapper.toRequest(new Add(null)));
    }

    @MessageMapping("/select-body")
    void selectBody(@Payload(required = false) byte @Nullable [] json, SimpMessageHeaderAccessor from) {
        desk.take(from, ProtocolMapper.toRequest(reader.select(json)));
    }

    @MessageMapping("/delete-body")
    void deleteBody(@Payload(required = false) byte @Nullable [] json, SimpMessageHeaderAccessor from) {
        desk.take(from, ProtocolMapper.toRequest(reader.delete(json)));
    }

    @MessageMapping("/move-selected-spaceships")
    void moveSelectedSpaceships(@Payload(required = false) byte @Nullable [] json, SimpMessageHeaderAccessor from) {
        desk.take(from, ProtocolMapper.toRequest(reader.move(json)));
    }

    @SubscribeMapping("/room")
    RoomInfo room() {
        return ProtocolMapper.toRoomInfo(desk.room().spec());
    }

    @MessageExceptionHandler
    void refuse(RefusedException refused, SimpMessageHeaderAccessor from) {
        desk.refuse(from, refused.problem());
    }
}
