package io.github.apsis.engine.parallel;

/**
 * Work cut into pieces that do not depend on each other: no piece reads what another writes. So it does not matter who does
 * which piece, nor when, and the result has the same bits for any number of threads.
 */
public interface Work {
    /**
     * Does one piece.
     *
     * @param piece 0 to the number of pieces, exclusive
     * @param member who does it, 0 to the size of the team, exclusive: what its scratch memory is kept under
     */
    void doPiece(int piece, int member);
}
