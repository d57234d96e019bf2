/**
 * Holds the newest of many values until the next animation frame.
 *
 * A frame of 2000 bodies takes some 15 ms to decode. A machine that draws slower than frames arrive must not decode those
 * that nobody will see, or it falls behind for ever. A hidden tab has no animation frames and goes by the clock.
 */
export class NewestOnly<T> {
  readonly #deliver: (value: T) => void;
  #waiting: { readonly value: T } | null = null;

  constructor(deliver: (value: T) => void) {
    this.#deliver = deliver;
  }

  put(value: T): void {
    const isScheduled = this.#waiting !== null;
    this.#waiting = { value };
    if (isScheduled) return;
    if (document.visibilityState === 'hidden') setTimeout(this.#flush, 0);
    else requestAnimationFrame(this.#flush);
  }

  drop(): void {
    this.#waiting = null;
  }

  readonly #flush = (): void => {
    const waiting = this.#waiting;
    this.#waiting = null;
    if (waiting) this.#deliver(waiting.value);
  };
}
