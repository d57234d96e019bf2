import type { BodyId, Frame } from '../protocol/frame';
import { FrameColumns } from './FrameColumns';
import { Outlines } from './Outlines';
import { Playhead } from './Playhead';
import { Watched } from './Watched';

/** Between two frames a body moves about speed · dt; five times as much is a wrap or a new place, not a path. */
const TELEPORT_FACTOR = 5;
/** Lists and figures hear of new frames this often: fast enough to read, too slow to cost a render per frame. */
const NOTIFY_EVERY_MS = 200;

/**
 * The last two frames, and any moment between them.
 *
 * Bodies never enter React's state: drawing reads `sample()`, lists read `newest` when `version()` changes, at 5 Hz.
 */
export class FrameBuffer extends Watched {
  #previous = new FrameColumns();
  #newest = new FrameColumns();
  #playhead = new Playhead();
  /** Slot of each body in the previous frame, or −1: new, or not to be interpolated. */
  #origin = new Int32Array(0);
  #isFresh = true;
  #version = 0;
  #notifiedMs = Number.NEGATIVE_INFINITY;
  #arrivedAtMs: number | null = null;
  readonly outlines = new Outlines();
  /** Position and angle at the sampled moment, by slot of the newest frame. */
  readonly at = { x: new Float64Array(0), y: new Float64Array(0), angle: new Float64Array(0) };

  get newest(): FrameColumns {
    return this.#newest;
  }

  readonly version = (): number => this.#version;

  /** Date.now() of the newest frame; null before the first. */
  readonly arrivedAtMs = (): number | null => this.#arrivedAtMs;

  has(id: BodyId): boolean {
    return this.#newest.slot.has(id);
  }

  /** Whether this slot moved on a path since the previous frame, or jumped. */
  isContinuous(slot: number): boolean {
    return this.#origin[slot]! >= 0;
  }

  ticksPerSecond(rate: number): void {
    this.#playhead.expect(1000 / rate);
  }

  /** The next frame may belong to another life of the room: nothing is interpolated towards it. */
  restart(): void {
    this.#isFresh = true;
  }

  /** Takes a frame in; answers whether the room's clock ran backwards, so that ids may mean other bodies now. */
  accept(frame: Frame, nowMs: number): boolean {
    const wentBack = frame.tick < this.#newest.tick;
    [this.#previous, this.#newest] = [this.#newest, this.#previous];
    if (wentBack) this.outlines.clear();
    this.#newest.fill(frame, this.#previous);
    this.outlines.learn(frame.bodies);
    this.#match(this.#isFresh || wentBack);
    this.#playhead.arrived(frame.tick, nowMs, this.#isFresh || wentBack);
    this.#isFresh = false;
    this.#arrivedAtMs = Date.now();
    this.#notify(nowMs);
    return wentBack;
  }

  /** Computes `at` for a moment one frame interval ago, so that there is a frame on both sides of it. */
  sample(nowMs: number): void {
    const { count, x, y, angle } = this.#newest;
    const before = this.#previous;
    const share = this.#playhead.share(nowMs);
    for (let i = 0; i < count; i++) {
      const from = this.#origin[i]!;
      if (from < 0) {
        this.at.x[i] = x[i]!;
        this.at.y[i] = y[i]!;
        this.at.angle[i] = angle[i]!;
        continue;
      }
      this.at.x[i] = before.x[from]! + (x[i]! - before.x[from]!) * share;
      this.at.y[i] = before.y[from]! + (y[i]! - before.y[from]!) * share;
      this.at.angle[i] = before.angle[from]! + shortTurn(before.angle[from]!, angle[i]!) * share;
    }
  }

  #match(isUnrelated: boolean): void {
    const { count } = this.#newest;
    if (count > this.#origin.length) this.#grow(2 * count);
    const dt = this.#newest.time - this.#previous.time;
    for (let i = 0; i < count; i++) this.#origin[i] = isUnrelated ? -1 : this.#originOf(i, dt);
  }

  #originOf(i: number, dt: number): number {
    const [now, before] = [this.#newest, this.#previous];
    const from = before.slot.get(now.idAt(i)) ?? -1;
    if (from < 0) return -1;
    const moved = Math.hypot(now.x[i]! - before.x[from]!, now.y[i]! - before.y[from]!);
    const speed = Math.max(now.speedAt(i), before.speedAt(from));
    return moved > TELEPORT_FACTOR * speed * dt + now.radius[i]! ? -1 : from;
  }

  #grow(capacity: number): void {
    this.#origin = new Int32Array(capacity);
    this.at.x = new Float64Array(capacity);
    this.at.y = new Float64Array(capacity);
    this.at.angle = new Float64Array(capacity);
  }

  #notify(nowMs: number): void {
    if (nowMs - this.#notifiedMs < NOTIFY_EVERY_MS) return;
    this.#notifiedMs = nowMs;
    this.#version++;
    this.changed();
  }
}

/** The turn from one angle to another the short way round, −π to π. */
function shortTurn(from: number, to: number): number {
  const turn = (to - from) % (2 * Math.PI);
  if (turn > Math.PI) return turn - 2 * Math.PI;
  return turn < -Math.PI ? turn + 2 * Math.PI : turn;
}
