package io.github.apsis.engine.parallel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TeamTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 8})
    void every_piece_is_done_once_in_every_round(int size) {
        try (var team = new Team(size)) {
            var times = new AtomicIntegerArray(1000);

            for (int round = 0; round < 1000; round++) { // rounds of 0 to 999 pieces, too short for all to take part
                team.share((piece, member) -> times.incrementAndGet(piece), round);
            }

            for (int piece = 0; piece < 1000; piece++) {
                assertThat(times.get(piece)).isEqualTo(999 - piece);
            }
        }
    }

    @Test
    void no_two_members_use_the_same_scratch_memory() {
        try (var team = new Team(4)) {
            var busy = new AtomicIntegerArray(4);
            var clashes = new AtomicIntegerArray(1);

            team.share(
                    (piece, member) -> {
                        if (busy.incrementAndGet(member) != 1) {
                            clashes.incrementAndGet(0);
                        }
                        LockSupport.parkNanos(20_000); // lets the others in
                        busy.decrementAndGet(member);
                    },
                    500);

            assertThat(clashes.get(0)).isZero();
        }
    }

    @Test
    void threads_that_have_gone_to_sleep_wake_for_the_next_round() {
        try (var team = new Team(3)) {
            var done = new AtomicIntegerArray(1);

            for (int round = 0; round < 20; round++) {
                team.share((piece, member) -> done.incrementAndGet(0), 30);
                LockSupport.parkNanos(2_000_000); // far longer than a thread looks out for work
            }

            assertThat(done.get(0)).isEqualTo(600);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5})
    void what_a_piece_throws_reaches_the_caller_and_the_team_goes_on(int size) {
        try (var team = new Team(size)) {
            assertThatThrownBy(() -> team.share(TeamTest::failAtSeven, 20))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage("seven");

            var done = new AtomicIntegerArray(1);
            team.share((piece, member) -> done.incrementAndGet(0), 20);
            assertThat(done.get(0)).isEqualTo(20);
        }
    }

    private static void failAtSeven(int piece, int member) {
        if (piece == 7) {
            throw new IllegalStateException("seven");
        }
    }

    @Test
    void a_closed_team_is_its_caller_alone_and_has_no_threads() throws InterruptedException {
        Set<Thread> threads = ConcurrentHashMap.newKeySet();
        var team = new Team(4);
        team.share(
                (piece, member) -> {
                    threads.add(Thread.currentThread());
                    LockSupport.parkNanos(100_000); // lets the others in
                },
                100);
        threads.remove(Thread.currentThread());
        assertThat(threads).isNotEmpty();

        team.close();

        var members = new AtomicIntegerArray(4);
        team.share((piece, member) -> members.incrementAndGet(member), 100);
        assertThat(members.get(0)).isEqualTo(100);
        for (Thread thread : threads) {
            thread.join(10_000);
            assertThat(thread.isAlive()).isFalse();
        }
    }

    @Test
    void one_piece_is_done_by_the_caller() {
        try (var team = new Team(200)) {
            team.share(
                    (piece, member) ->
                            assertThat(Thread.currentThread().getName()).doesNotStartWith("apsis-"),
                    1);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, -1, 257})
    void a_team_has_at_least_its_caller(int size) {
        assertThatThrownBy(() -> new Team(size))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("a team has 1 to 256 threads, was " + size);
    }
}
