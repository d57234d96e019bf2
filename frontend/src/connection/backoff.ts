const FIRST_MS = 500;
/** Somebody is looking: the page is back within two seconds of the server. */
const LONGEST_SEEN_MS = 1500;
const LONGEST_HIDDEN_MS = 15_000;

/**
 * How long to wait before attempt number `failures` (1 is the first after a loss): 0.5 s, doubling. A fifth of it is
 * chance, so that a class room does not come back in one blow.
 */
export function backoffMs(failures: number, isHidden: boolean, chance: number): number {
  const longest = isHidden ? LONGEST_HIDDEN_MS : LONGEST_SEEN_MS;
  const full = Math.min(longest, FIRST_MS * 2 ** Math.min(failures - 1, 10));
  return full * (0.8 + 0.2 * chance);
}
