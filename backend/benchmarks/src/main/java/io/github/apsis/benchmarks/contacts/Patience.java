package io.github.apsis.benchmarks.contacts;

import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** Runs what may not end, on a thread of its own, and gives it up after a while. */
final class Patience {
    private Patience() {}

    /**
     * The result.
     *
     * @throws IllegalStateException when there is none by then, or when the work has failed; the message says which
     */
    static <T> T of(Callable<T> work, long seconds) {
        FutureTask<T> task = new FutureTask<>(work);
        var thread = new Thread(null, task, "contacts", 1L << 26);
        thread.setDaemon(true);
        thread.start();
        try {
            return task.get(seconds, TimeUnit.SECONDS);
        } catch (TimeoutException e) {
            task.cancel(true);
            throw new IllegalStateException("it had not ended after " + seconds + " s", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted", e);
        } catch (ExecutionException e) {
            Throwable cause = e.getCause();
            throw new IllegalStateException(
                    cause instanceof IllegalArgumentException || cause instanceof IllegalStateException
                            ? cause.getMessage()
                            : String.valueOf(cause),
                    cause);
        }
    }
}
