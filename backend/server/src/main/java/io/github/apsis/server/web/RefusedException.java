package io.github.apsis.server.web;

import io.github.apsis.protocol.Problem;
import org.jspecify.annotations.Nullable;

/** A message from a client that makes no sense; the problem says why, to the client. */
final class RefusedException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient Problem problem;

    RefusedException(Problem.Code code, String message) {
        this(code, message, null);
    }

    RefusedException(Problem.Code code, String message, @Nullable String field) {
        super(message, null, false, false); // no stack trace: a client may cause fifty a second
        this.problem = new Problem(code, message, field);
    }

    Problem problem() {
        return problem;
    }
}
