import type { BodyId, BodyKind, Vec2 } from './frame';

export type Bounds = {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
};

/** The edge of the world. */
export type Boundary = { readonly kind: 'open' } | ({ readonly kind: 'walls' | 'periodic' } & Bounds);

/** What a client needs to know of its room before the first frame. */
export type Room = {
  readonly room: string;
  readonly scene: string;
  readonly title: string;
  readonly units: { readonly length: string; readonly mass: string; readonly time: string };
  readonly boundary: Boundary;
  /** The part of the world that is worth looking at first. */
  readonly view: Bounds;
  /** Ticks per second of wall time. */
  readonly tickRate: number;
  readonly frameRate: number;
  readonly maxBodies: number;
  /** What becomes of a ship that runs into another body: it goes on, or is gone. */
  readonly ships: 'bounce' | 'mortal';
};

/** How the room is doing, a few times a second. */
export type Diagnostics = {
  readonly tick: number;
  readonly time: number;
  readonly ticksPerSecond: number;
  readonly tickMillis: { readonly p50: number; readonly p99: number };
  readonly lateTicks: number;
  readonly droppedTicks: number;
  /** Of the room's clock, as a share of real time. */
  readonly speed: number;
  readonly bodies: number;
  readonly clients: number;
  /** From here to the virial ratio: null where the scene does not ask for it, or where it has no meaning. */
  readonly kinetic: number | null;
  readonly potential: number | null;
  readonly energy: number | null;
  readonly energyDrift: number | null;
  readonly momentum: Vec2 | null;
  readonly momentumDrift: number | null;
  /** About the origin. */
  readonly angularMomentum: number | null;
  readonly angularMomentumDrift: number | null;
  readonly centreOfMassX: number | null;
  readonly centreOfMassY: number | null;
  /** 2 · kinetic / |potential|. */
  readonly virialRatio: number | null;
  /** What sums the attraction up: "direct", or "none". */
  readonly gravitySolver: string | null;
  /** Of the gravity solver, relative; null where it is exact. */
  readonly forceError: number | null;
};

/** What became of an accepted command. */
export type Reply = { readonly command: string; readonly ids: readonly BodyId[]; readonly tick: number };

/** Why a command was refused: a code for programs, a sentence for people. */
export type Problem = { readonly code: string; readonly message: string; readonly field: string | null };

/** The closest approach of a ship on its course and a body that goes straight on. */
export type Passing = {
  /** From the moment of the message on. */
  readonly time: number;
  /** Between the rims; negative where they would touch. */
  readonly gap: number;
  /** Where the centres will be. In a periodic world the body is the image that is nearest to the ship. */
  readonly ship: Vec2;
  readonly body: Vec2;
};

/** What a ship would come too close to first if it did as it likes. */
export type Threat = { readonly id: BodyId; readonly timeToContact: number; readonly passing: Passing };

/** What the ship is doing that this client has selected last, ten times a second. */
export type ShipReading = {
  readonly id: BodyId;
  readonly tick: number;
  readonly time: number;
  /** Where it is ordered to; null while it wanders. */
  readonly target: Vec2 | null;
  /** The velocity that it is on its way to. */
  readonly course: Vec2;
  /** Whether that is a detour for the sake of others. */
  readonly evading: boolean;
  /** Of its engine. */
  readonly acceleration: Vec2;
  readonly threat: Threat | null;
};

/** What can happen to a ship. */
export type ShipEventType = 'arrived' | 'collided' | 'destroyed';

export type ShipEvent = {
  /** 1, 2, 3 … for the life of the room. */
  readonly number: number;
  readonly tick: number;
  readonly time: number;
  readonly type: ShipEventType;
  readonly ship: BodyId;
  /** What it ran into, which may be gone by now; null where it has arrived. */
  readonly other: { readonly id: BodyId; readonly kind: BodyKind } | null;
  /** With which the two closed; null where it has arrived. */
  readonly speed: number | null;
};

/** The newest events of the room, the oldest first. */
export type ShipEvents = {
  readonly tick: number;
  /** How many came too fast to be listed, since the room opened. */
  readonly unlisted: number;
  readonly events: readonly ShipEvent[];
};
