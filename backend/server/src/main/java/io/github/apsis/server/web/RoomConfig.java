package io.github.apsis.server.web;

import com.fasterxml.jackson.annotation.JsonInclude.Value;
import io.github.apsis.protocol.BodyState;
import io.github.apsis.protocol.RoomInfo;
import io.github.apsis.scenes.Scene;
import io.github.apsis.scenes.SceneCatalogue;
import io.github.apsis.server.room.Admission;
import io.github.apsis.server.room.FrameSink;
import io.github.apsis.server.room.OpenRoom;
import io.github.apsis.server.room.RoomSpec;
import io.github.apsis.server.room.Rooms;
import io.github.apsis.server.room.WarmUp;
import org.springframework.boot.context.event.ApplicationReadyEvent;
import org.springframework.boot.jackson.autoconfigure.JsonMapperBuilderCustomizer;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.event.EventListener;
import tools.jackson.databind.json.JsonMapper;

/** Opens the public room. Its clock starts when all else has: a server that is still starting takes the tick its time. */
@Configuration
class RoomConfig {
    @EventListener
    void startClocks(ApplicationReadyEvent ready) {
        ready.getApplicationContext().getBean(Rooms.class).all().forEach(OpenRoom::start);
    }

    @Bean
    Rooms rooms(ApsisProperties properties, Scene scene, FrameSink sink) {
        Rooms rooms = new Rooms(properties.limits().load());
        double load = WarmUp.run(scene, properties.seed());
        if (rooms.open(publicRoom(properties, scene), load, sink) instanceof Admission.Refused refused) {
            throw new IllegalStateException(refused.reason());
        }
        return rooms;
    }

    @Bean
    Scene scene(ApsisProperties properties) {
        return SceneCatalogue.byName(properties.scene()).orElseThrow();
    }

    @Bean
    StompFrameSink frameSink(ClientSessions sessions, JsonMapper json) {
        return new StompFrameSink(sessions, json);
    }

    /** Where the treaty says that a field is absent, it is absent; everywhere else null is said. */
    @Bean
    JsonMapperBuilderCustomizer treaty() {
        return json -> json.withConfigOverride(BodyState.class, body -> body.setInclude(Value.ALL_NON_NULL))
                .withConfigOverride(RoomInfo.Edge.class, edge -> edge.setInclude(Value.ALL_NON_NULL));
    }

    private static RoomSpec publicRoom(ApsisProperties properties, Scene scene) {
        return new RoomSpec(
                CommandDesk.PUBLIC_ROOM,
                scene,
                properties.seed(),
                properties.frameRate(),
                properties.limits().bodies());
    }
}
