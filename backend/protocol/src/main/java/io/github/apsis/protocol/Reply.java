package io.github.apsis.protocol;

import java.util.List;

/**
 * What became of an accepted command.
 *
 * @param command the last part of its destination
 * @param ids the bodies that were added, selected, removed or sent off
 * @param tick the first tick that sees the change
 */
public record Reply(String command, List<Long> ids, long tick) {}
