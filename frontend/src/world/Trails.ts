import type { BodyId } from '../protocol/frame';
import type { FrameBuffer } from './FrameBuffer';

const LENGTH = 300; // points, 10 s at 30 Hz

/** Where a body has been. A ring of points; NaN marks a jump. */
export class Trail {
  readonly x = new Float64Array(LENGTH);
  readonly y = new Float64Array(LENGTH);
  #head = 0;
  count = 0;

  add(x: number, y: number): void {
    this.x[this.#head] = x;
    this.y[this.#head] = y;
    this.#head = (this.#head + 1) % LENGTH;
    this.count = Math.min(this.count + 1, LENGTH);
  }

  /** Index of the point that is `age` points old; 0 is the newest. */
  index(age: number): number {
    return (this.#head - 1 - age + 2 * LENGTH) % LENGTH;
  }
}

/** The trails of the selected bodies; a body's trail begins when it is selected. */
export class Trails {
  readonly #byId = new Map<BodyId, Trail>();

  of(id: BodyId): Trail | undefined {
    return this.#byId.get(id);
  }

  clear(): void {
    this.#byId.clear();
  }

  record(frames: FrameBuffer, selected: readonly BodyId[]): void {
    for (const id of this.#byId.keys()) if (!selected.includes(id)) this.#byId.delete(id);
    for (const id of selected) this.#extend(frames, id);
  }

  #extend(frames: FrameBuffer, id: BodyId): void {
    const i = frames.newest.slot.get(id);
    if (i === undefined) return;
    const trail = this.#byId.get(id) ?? new Trail();
    this.#byId.set(id, trail);
    if (trail.count > 0 && !frames.isContinuous(i)) trail.add(Number.NaN, Number.NaN);
    trail.add(frames.newest.x[i]!, frames.newest.y[i]!);
  }
}
