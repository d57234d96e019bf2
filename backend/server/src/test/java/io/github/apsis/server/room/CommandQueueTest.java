package io.github.apsis.server.room;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class CommandQueueTest {
    private final List<Integer> drained = new ArrayList<>();

    @Test
    void keeps_the_order_of_arrival() {
        CommandQueue<Integer> queue = new CommandQueue<>(10);
        IntStream.range(0, 5).forEach(queue::offer);

        queue.drain(3, drained::add);
        queue.drain(3, drained::add);

        assertThat(drained).containsExactly(0, 1, 2, 3, 4);
    }

    @Test
    void refuses_when_it_is_full_but_not_what_must_not_be_lost() {
        CommandQueue<Integer> queue = new CommandQueue<>(2);

        assertThat(queue.offer(1)).isTrue();
        assertThat(queue.offer(2)).isTrue();
        assertThat(queue.offer(3)).isFalse();
        queue.force(4);
        queue.drain(10, drained::add);

        assertThat(drained).containsExactly(1, 2, 4);
        assertThat(queue.offer(5)).isTrue();
    }

    @Test
    void many_threads_never_get_in_more_than_fit() throws InterruptedException {
        CommandQueue<Integer> queue = new CommandQueue<>(1000);
        AtomicInteger accepted = new AtomicInteger();
        CountDownLatch go = new CountDownLatch(1);
        List<Thread> threads = IntStream.range(0, 8)
                .mapToObj(n -> new Thread(() -> {
                    await(go);
                    IntStream.range(0, 500).filter(i -> queue.offer(i)).forEach(i -> accepted.incrementAndGet());
                }))
                .toList();

        threads.forEach(Thread::start);
        go.countDown();
        for (Thread thread : threads) {
            thread.join();
        }

        queue.drain(Integer.MAX_VALUE, drained::add);
        assertThat(drained)
                .hasSize(accepted.get())
                .hasSizeLessThanOrEqualTo(1000)
                .hasSizeGreaterThan(990);
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
