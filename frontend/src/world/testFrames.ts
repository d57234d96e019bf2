import type { Asteroid, BodyId, BodyState, Frame, Planet, Ship } from '../protocol/frame';
import type { Room, ShipReading } from '../protocol/messages';

// Bodies and frames for tests: everything at rest at the origin, unless said otherwise.

const still = { velocity: { x: 0, y: 0 }, acceleration: { x: 0, y: 0 }, mass: 12, radius: 8, selected: false };

export const bodyId = (id: number) => id as BodyId;

export function planet(id: number, x = 0, y = 0, more: Partial<Planet> = {}): Planet {
  return { ...still, id: bodyId(id), kind: 'planet', position: { x, y }, ...more };
}

export function ship(id: number, x = 0, y = 0, more: Partial<Ship> = {}): Ship {
  return { ...still, id: bodyId(id), kind: 'ship', position: { x, y }, thrust: 0, ...more };
}

export function asteroid(id: number, x = 0, y = 0, more: Partial<Asteroid> = {}): Asteroid {
  const vertices = [
    { x: 8, y: 0 },
    { x: -4, y: 7 },
    { x: -4, y: -7 },
  ];
  return { ...still, id: bodyId(id), kind: 'asteroid', position: { x, y }, angle: 0, vertices, ...more };
}

export const testRoom: Room = {
  room: 'public',
  scene: 'test',
  title: 'Test',
  units: { length: 'units', mass: 'kg', time: 's' },
  boundary: { kind: 'open' },
  view: { minX: 0, minY: 0, maxX: 1, maxY: 1 },
  tickRate: 150,
  frameRate: 30,
  maxBodies: 2000,
  ships: 'bounce',
};

/** A ship that goes 84 to the right, wanders and has nothing in its way, unless said otherwise. */
export function shipReading(id: number, more: Partial<ShipReading> = {}): ShipReading {
  return {
    id: bodyId(id),
    tick: 5,
    time: 5 / 150,
    target: null,
    course: { x: 84, y: 0 },
    evading: false,
    acceleration: { x: 0, y: -120 },
    threat: null,
    ...more,
  };
}

/** Ticks are 1/150 of a time unit; a frame comes every fifth. */
export function frame(tick: number, ...bodies: BodyState[]): Frame {
  return { tick, time: tick / 150, sent: tick * 6.6667, speed: 1, bodies };
}

export const FRAME_MS = 1000 / 30;
