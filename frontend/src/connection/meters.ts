/** Counts what arrived, and says once a second how much that was per second. */
export class RateMeter {
  #frames = 0;
  #bytes = 0;
  #sinceMs: number;

  constructor(nowMs: number) {
    this.#sinceMs = nowMs;
  }

  countFrame(): void {
    this.#frames++;
  }

  countBytes(bytes: number): void {
    this.#bytes += bytes;
  }

  /** Rates since the last call. */
  take(nowMs: number): { hz: number; bytesPerSecond: number } {
    const seconds = Math.max(0.001, (nowMs - this.#sinceMs) / 1000);
    const rates = { hz: this.#frames / seconds, bytesPerSecond: this.#bytes / seconds };
    this.#frames = 0;
    this.#bytes = 0;
    this.#sinceMs = nowMs;
    return rates;
  }
}

/**
 * How old a frame is when it arrives.
 *
 * The two clocks differ by an unknown amount, so `arrival − sent` means nothing by itself; its minimum is the best trip
 * seen plus that amount. What a trip takes above the minimum is real, and the best trip itself takes about half of the
 * measured round trip.
 */
export class DelayMeter {
  #best = Number.POSITIVE_INFINITY;
  #excessMs = 0;
  #halfTripMs = 0;

  roundTrip(ms: number): void {
    this.#halfTripMs = ms / 2;
  }

  arrived(nowMs: number, sentMs: number): void {
    const raw = nowMs - sentMs;
    if (Number.isNaN(raw)) return;
    // Forgets 0.06 ms a second at 30 Hz, more than two quartz clocks drift apart.
    this.#best = Math.min(this.#best + 0.002, raw);
    this.#excessMs += (raw - this.#best - this.#excessMs) * 0.2;
  }

  delayMs(): number {
    return this.#halfTripMs + this.#excessMs;
  }
}
