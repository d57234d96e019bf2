import type { BodyId, Vec2 } from '../protocol/frame';
import type { FrameColumns } from './FrameColumns';

/** An order that was given and not yet seen in a frame. */
export type PendingOrder = Vec2 & { readonly ships: readonly BodyId[]; readonly isConfirmed: boolean };

/** Neither frame nor reply nor refusal for so long: the order is lost, and its marker would lie. */
const LOST_AFTER_MS = 3000;

/** The order that the user has just given: drawn at once, hollow until the room confirms it. */
export class Orders {
  #pending: PendingOrder | null = null;
  #givenMs = 0;

  pending(nowMs: number): PendingOrder | null {
    if (this.#pending && nowMs - this.#givenMs > LOST_AFTER_MS) this.#pending = null;
    return this.#pending;
  }

  give(target: Vec2, ships: readonly BodyId[], nowMs: number): void {
    this.#pending = { x: target.x, y: target.y, ships, isConfirmed: false };
    this.#givenMs = nowMs;
  }

  confirm(): void {
    if (this.#pending) this.#pending = { ...this.#pending, isConfirmed: true };
  }

  refuse(): void {
    this.#pending = null;
  }

  /** Once a frame shows the order on one of its ships, the frame is what is drawn. */
  seen(frame: FrameColumns): void {
    const order = this.#pending;
    if (order?.ships.some((id) => isUnderOrder(frame, id, order))) this.#pending = null;
  }
}

function isUnderOrder(frame: FrameColumns, id: BodyId, order: Vec2): boolean {
  const i = frame.slot.get(id);
  if (i === undefined) return false;
  // The room may round the point or give every ship a place beside it.
  const near = 20 * frame.radius[i]!;
  return Math.hypot(frame.targetX[i]! - order.x, frame.targetY[i]! - order.y) <= near;
}
