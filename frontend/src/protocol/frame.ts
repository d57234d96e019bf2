/** Names a body for the life of its room; never reused there. */
export type BodyId = number & { readonly __brand: 'BodyId' };

export type BodyKind = 'planet' | 'asteroid' | 'ship';

/** A point or a vector in scene units, x to the right and y up. */
export type Vec2 = { readonly x: number; readonly y: number };

type Moving = {
  readonly id: BodyId;
  readonly position: Vec2;
  readonly velocity: Vec2;
  readonly acceleration: Vec2;
  readonly mass: number;
  /** Of the bounding circle, which is what collides. */
  readonly radius: number;
  /** Whether anyone in the room has selected it. */
  readonly selected: boolean;
};

export type Planet = Moving & { readonly kind: 'planet' };

export type Asteroid = Moving & {
  readonly kind: 'asteroid';
  /** Radians, counter-clockwise. */
  readonly angle: number;
  /** The convex outline about the centre at angle 0, counter-clockwise. */
  readonly vertices: readonly Vec2[];
};

export type Ship = Moving & {
  readonly kind: 'ship';
  /** Force of the engine as a share of its maximum, 0 to 1. */
  readonly thrust: number;
  /** Where an order leads; absent without an order. */
  readonly target?: Vec2;
};

export type BodyState = Planet | Asteroid | Ship;

/** Every body at one moment of the simulation. */
export type Frame = {
  readonly tick: number;
  /** Simulated time, in the time unit of the scene. */
  readonly time: number;
  /** Server clock when it was sent, milliseconds since 1970. */
  readonly sent: number;
  /** Of the room's clock, as a share of real time: 1, or less where the room is too heavy for its server. */
  readonly speed: number;
  readonly bodies: readonly BodyState[];
};
