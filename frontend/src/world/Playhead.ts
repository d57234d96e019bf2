/** Frames that are late by up to this much are guessed by going on straight. */
const EXTRAPOLATE_MS = 100;
/** More than this from the expected moment is a pause of the link, not jitter. */
const RESYNC_MS = 250;

/**
 * Where between two frames the picture is.
 *
 * Frames arrive with jitter, ticks do not: the expected arrival runs on with the ticks and is pulled towards the real
 * arrivals by a tenth of the difference, so a single late frame hardly moves the picture. The milliseconds per tick are
 * measured as well, because an overloaded room runs slower than its clock.
 */
export class Playhead {
  #msPerTick = 1000 / 150;
  #tick = 0;
  #arrivedMs = 0;
  #expectedMs = 0;
  #intervalMs = 0;

  expect(msPerTick: number): void {
    this.#msPerTick = msPerTick;
  }

  arrived(tick: number, nowMs: number, isFirst: boolean): void {
    const ticks = tick - this.#tick;
    const expected = this.#expectedMs + ticks * this.#msPerTick;
    const late = nowMs - expected;
    const isResync = isFirst || ticks <= 0 || Math.abs(late) > RESYNC_MS;
    this.#expectedMs = isResync ? nowMs : expected + 0.1 * late;
    if (!isResync) this.#msPerTick += 0.02 * ((nowMs - this.#arrivedMs) / ticks - this.#msPerTick);
    this.#intervalMs = isFirst ? 0 : Math.max(0, ticks) * this.#msPerTick;
    this.#tick = tick;
    this.#arrivedMs = nowMs;
  }

  /** 0 shows the previous frame, 1 the newest, more goes beyond it. */
  share(nowMs: number): number {
    if (this.#intervalMs === 0) return 1;
    const share = (nowMs - this.#expectedMs) / this.#intervalMs;
    return Math.min(Math.max(share, 0), 1 + EXTRAPOLATE_MS / this.#intervalMs);
  }
}
