package io.github.apsis.engine.parallel;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/**
 * A caller and its threads, who share {@link Work} piece by piece: whoever is free takes the next, so a thread that the
 * machine holds up delays one piece and no more.
 *
 * <p>One caller at a time. The threads are daemons, begin with the first work that is shared and end with {@link #close}. In
 * between they look out for work for a while, since a tick shares several times in a row, and then sleep. Nothing is
 * allocated once they run: an executor allocates a task and a node of its queue for every piece.
 */
public final class Team implements AutoCloseable {
    /** The largest team. */
    public static final int MOST = 256;

    /**
     * Looks at the board before a thread goes to sleep, some 100 µs: a tick of 10 000 bodies does no more alone between two shares,
     * and a sleeper takes half as long to wake.
     */
    private static final int PATIENCE = 4000;

    private final Member[] members; // all but the caller
    private final AtomicLong board = new AtomicLong(); // round << 32 | pieces that nobody has taken yet
    private final AtomicInteger unfinished = new AtomicInteger();
    private @Nullable Work work; // of the present round; written before the board, read after a piece is taken from it
    private int pieces;
    private boolean started;
    private volatile boolean closed;
    private volatile @Nullable Thread waitingCaller;
    private volatile @Nullable Throwable failure;

    /** The caller and {@code size − 1} threads. */
    public Team(int size) {
        if (size < 1 || size > MOST) {
            throw new IllegalArgumentException("a team has 1 to " + MOST + " threads, was " + size);
        }
        members = new Member[size - 1];
        for (int k = 0; k < members.length; k++) {
            members[k] = new Member(k + 1);
        }
    }

    /** The caller alone. */
    public static Team ofOne() {
        return new Team(1);
    }

    /** Where a share of a count of items begins that has even shares; the last ends where one more would begin. */
    public static int beginning(int share, int shares, int count) {
        return (int) ((long) count * share / shares);
    }

    /** How many do the work, the caller among them. */
    public int size() {
        return members.length + 1;
    }

    /**
     * Does all pieces and returns when the last is done.
     *
     * @throws RuntimeException or error, whatever a piece has thrown; the others are done all the same
     */
    public void share(Work newWork, int newPieces) {
        if (newPieces <= 1 || members.length == 0 || closed) {
            for (int piece = 0; piece < newPieces; piece++) {
                newWork.doPiece(piece, 0);
            }
            return;
        }
        start();
        work = newWork;
        pieces = newPieces;
        unfinished.set(newPieces);
        long round = (board.get() >>> 32) + 1 & 0xffffffffL;
        board.set(round << 32 | newPieces);
        for (Member member : members) {
            member.wake();
        }
        takePieces(round, 0);
        awaitOthers();
        work = null; // a sleeping thread must not keep a world alive
        rethrow();
    }

    /** Ends the threads. The team then is its caller alone. */
    @Override
    public void close() {
        closed = true;
        for (Member member : members) {
            LockSupport.unpark(member.thread);
        }
    }

    private void start() {
        if (!started) {
            started = true;
            for (Member member : members) {
                member.thread.start();
            }
        }
    }

    private void takePieces(long round, int member) {
        while (true) {
            long seen = board.get();
            int left = (int) seen;
            if (seen >>> 32 != round || left == 0) {
                return;
            }
            if (board.compareAndSet(seen, seen - 1)) {
                // The round lasts until this piece is done, so what stands here is what belongs to it.
                doPiece(pieces - left, member);
            }
        }
    }

    private void doPiece(int piece, int member) {
        try {
            if (work != null) {
                work.doPiece(piece, member);
            }
        } catch (RuntimeException | Error e) {
            failure = e;
        }
        if (unfinished.decrementAndGet() == 0) {
            LockSupport.unpark(waitingCaller); // does nothing when nobody waits
        }
    }

    private void awaitOthers() {
        for (int look = 0; look < PATIENCE; look++) {
            if (unfinished.get() == 0) {
                return;
            }
            Thread.onSpinWait();
        }
        waitingCaller = Thread.currentThread();
        while (unfinished.get() != 0) {
            LockSupport.park(this);
        }
        waitingCaller = null;
    }

    private void rethrow() {
        Throwable thrown = failure;
        failure = null;
        if (thrown instanceof Error error) {
            throw error;
        }
        if (thrown instanceof RuntimeException exception) {
            throw exception;
        }
    }

    /** One thread beside the caller. */
    private final class Member implements Runnable {
        private final int number;
        private final Thread thread;
        private volatile boolean asleep;

        Member(int number) {
            this.number = number;
            this.thread = new Thread(this, "apsis-" + number);
            thread.setDaemon(true);
        }

        @Override
        public void run() {
            long done = 0;
            int looks = 0;
            while (!closed) {
                long round = board.get() >>> 32;
                if (round != done) {
                    takePieces(round, number);
                    done = round;
                    looks = 0;
                } else if (looks++ < PATIENCE) {
                    Thread.onSpinWait();
                } else {
                    sleep(done);
                }
            }
        }

        private void sleep(long done) {
            asleep = true;
            if (board.get() >>> 32 == done
                    && !closed) { // after the flag, or a round begun in between would be slept through
                LockSupport.park(Team.this);
            }
            asleep = false;
        }

        void wake() {
            if (asleep) {
                LockSupport.unpark(thread);
            }
        }
    }
}
