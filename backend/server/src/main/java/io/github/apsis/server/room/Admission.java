package io.github.apsis.server.room;

/** What became of the wish to open a room. */
public sealed interface Admission {
    /** It is open; its clock stands still until it is started. */
    record Admitted(OpenRoom room) implements Admission {}

    /**
     * It would take more than the server has to give.
     *
     * @param reason for people: what is too much, and what to do
     */
    record Refused(String reason) implements Admission {}
}
