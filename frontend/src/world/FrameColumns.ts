import type { BodyId, BodyKind, BodyState, Frame } from '../protocol/frame';

export const KINDS: readonly BodyKind[] = ['planet', 'asteroid', 'ship'];
export const PLANET = 0;
export const ASTEROID = 1;
export const SHIP = 2;

/** Under this speed, a fiftieth of its radius per time unit, a ship keeps its heading: the direction of almost nothing is noise. */
const STILL_RADII = 0.02;

/** One frame as columns: one array per quantity, one slot per body. Grows, never shrinks. */
export class FrameColumns {
  count = 0;
  tick = 0;
  time = 0;
  /** Of the room's clock, as a share of real time. */
  speed = 1;
  largestRadius = 0;
  id = new Float64Array(0);
  kind = new Uint8Array(0);
  x = new Float64Array(0);
  y = new Float64Array(0);
  vx = new Float64Array(0);
  vy = new Float64Array(0);
  ax = new Float64Array(0);
  ay = new Float64Array(0);
  mass = new Float64Array(0);
  radius = new Float64Array(0);
  /** Asteroids: the turn of the outline. Ships: their heading. Radians. */
  angle = new Float64Array(0);
  thrust = new Float64Array(0);
  /** NaN where a body has no order. */
  targetX = new Float64Array(0);
  targetY = new Float64Array(0);
  /** 1 where anyone has selected the body. */
  taken = new Uint8Array(0);
  /** Slot of a body. */
  readonly slot = new Map<BodyId, number>();

  idAt(i: number): BodyId {
    return this.id[i] as BodyId;
  }

  kindAt(i: number): BodyKind {
    return KINDS[this.kind[i]!]!;
  }

  speedAt(i: number): number {
    return Math.hypot(this.vx[i]!, this.vy[i]!);
  }

  /** Takes over a frame. A ship that stands still keeps the heading it had in `before`. */
  fill(frame: Frame, before: FrameColumns): void {
    const { bodies } = frame;
    if (bodies.length > this.id.length) this.#grow(bodies.length);
    this.count = bodies.length;
    this.tick = frame.tick;
    this.time = frame.time;
    this.speed = frame.speed;
    this.largestRadius = 0;
    this.slot.clear();
    for (let i = 0; i < bodies.length; i++) {
      const body = bodies[i]!;
      this.slot.set(body.id, i);
      this.#put(i, body);
      this.largestRadius = Math.max(this.largestRadius, body.radius);
      if (body.kind === 'ship') this.angle[i] = this.#heading(i, body.id, before);
    }
  }

  #put(i: number, body: BodyState): void {
    this.id[i] = body.id;
    this.kind[i] = KINDS.indexOf(body.kind);
    this.x[i] = body.position.x;
    this.y[i] = body.position.y;
    this.vx[i] = body.velocity.x;
    this.vy[i] = body.velocity.y;
    this.ax[i] = body.acceleration.x;
    this.ay[i] = body.acceleration.y;
    this.mass[i] = body.mass;
    this.radius[i] = body.radius;
    this.taken[i] = body.selected ? 1 : 0;
    this.angle[i] = body.kind === 'asteroid' ? body.angle : 0;
    this.thrust[i] = body.kind === 'ship' ? body.thrust : 0;
    const target = body.kind === 'ship' ? body.target : undefined;
    this.targetX[i] = target?.x ?? Number.NaN;
    this.targetY[i] = target?.y ?? Number.NaN;
  }

  #heading(i: number, id: BodyId, before: FrameColumns): number {
    if (this.speedAt(i) > STILL_RADII * this.radius[i]!) return Math.atan2(this.vy[i]!, this.vx[i]!);
    const old = before.slot.get(id);
    return old === undefined ? 0 : before.angle[old]!;
  }

  #grow(count: number): void {
    const capacity = Math.max(64, 2 * count);
    for (const name of COLUMNS) this[name] = new Float64Array(capacity);
    this.kind = new Uint8Array(capacity);
    this.taken = new Uint8Array(capacity);
  }
}

const COLUMNS = [
  'id',
  'x',
  'y',
  'vx',
  'vy',
  'ax',
  'ay',
  'mass',
  'radius',
  'angle',
  'thrust',
  'targetX',
  'targetY',
] as const;
