package io.github.apsis.server.room;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.body.BodyId;
import io.github.apsis.server.room.ShipEvent.What;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class EventLogTest {
    private static final long LONG_AFTER = 10_000; // ticks

    private final EventLog log = new EventLog();

    @Test
    void nothing_has_happened_yet() {
        assertThat(log.news(1)).isEmpty();
    }

    @Test
    void a_room_may_begin_with_a_bang() {
        happens(1);
        happens(1);

        assertThat(news().events()).hasSize(2);
    }

    @Test
    void what_has_been_told_is_told_again_only_with_something_new() {
        happens(LONG_AFTER);
        assertThat(log.news(LONG_AFTER)).isPresent();
        assertThat(log.news(LONG_AFTER + 1)).isEmpty();

        happens(LONG_AFTER + 300);

        assertThat(news().events()).extracting(ShipEvent::number).containsExactly(1L, 2L);
    }

    @Test
    void a_heap_of_ships_is_listed_ten_at_once_and_the_rest_counted() {
        for (int i = 0; i < 500; i++) {
            happens(LONG_AFTER);
        }

        ShipEvents news = news();
        assertThat(news.events()).hasSize(EventLog.BURST);
        assertThat(news.unlisted()).isEqualTo(500 - EventLog.BURST);
    }

    @Test
    void a_heap_that_goes_on_is_listed_five_times_a_second() {
        long last = LONG_AFTER + 60L * TickLoop.TICKS_PER_SECOND;
        for (long tick = LONG_AFTER; tick < last; tick++) {
            happens(tick);
            happens(tick);
        }

        ShipEvents news = news();
        long listed = news.events().get(news.events().size() - 1).number();
        assertThat(listed).isBetween(60L * EventLog.PER_SECOND, 60L * EventLog.PER_SECOND + EventLog.BURST);
        assertThat(listed + news.unlisted()).isEqualTo(2 * 60 * TickLoop.TICKS_PER_SECOND);
    }

    @Test
    void no_message_holds_more_than_the_newest_twenty() {
        for (int i = 0; i < 30; i++) {
            happens(LONG_AFTER + 300L * i);
        }

        assertThat(news().events())
                .hasSize(EventLog.LISTED)
                .extracting(ShipEvent::number)
                .startsWith(11L)
                .endsWith(30L);
    }

    @Test
    void numbers_have_no_gaps_when_events_were_not_listed() {
        for (int i = 0; i < 50; i++) {
            happens(LONG_AFTER);
        }
        happens(2 * LONG_AFTER);

        assertThat(news().events()).extracting(ShipEvent::number).endsWith(10L, 11L);
    }

    private void happens(long tick) {
        log.add(tick, tick / 150.0, What.COLLIDED, new BodyId(1), Optional.empty());
    }

    private ShipEvents news() {
        return log.news(0).orElseThrow();
    }
}
