import type { BodyId, BodyKind, Vec2 } from './frame';
import type {
  Boundary,
  Bounds,
  Diagnostics,
  Problem,
  Reply,
  Room,
  ShipEvent,
  ShipEvents,
  ShipReading,
  Threat,
} from './messages';
import { BadMessage, parse, readArray, readNullable, readNumber, readObject, readString } from './read';

/** Decodes the answer of `/app/room`. */
export function decodeRoom(text: string): Room {
  const room = readObject(parse(text, 'room'), 'room');
  const units = readObject(room.units, 'units');
  return {
    room: readString(room, 'room'),
    scene: readString(room, 'scene'),
    title: readString(room, 'title'),
    units: { length: readString(units, 'length'), mass: readString(units, 'mass'), time: readString(units, 'time') },
    boundary: boundary(room.boundary),
    view: bounds(readObject(room.view, 'view')),
    tickRate: readNumber(room, 'tickRate'),
    frameRate: readNumber(room, 'frameRate'),
    maxBodies: readNumber(room, 'maxBodies'),
    // An older server does not tell: there they bounce.
    ships: room.ships === 'mortal' ? 'mortal' : 'bounce',
  };
}

/** Decodes `/topic/diagnostics`. */
export function decodeDiagnostics(text: string): Diagnostics {
  const from = readObject(parse(text, 'diagnostics'), 'diagnostics');
  const tickMillis = readObject(from.tickMillis, 'tickMillis');
  return {
    tick: readNumber(from, 'tick'),
    time: readNumber(from, 'time'),
    ticksPerSecond: readNumber(from, 'ticksPerSecond'),
    tickMillis: { p50: readNumber(tickMillis, 'p50'), p99: readNumber(tickMillis, 'p99') },
    lateTicks: readNumber(from, 'lateTicks'),
    droppedTicks: readNumber(from, 'droppedTicks'),
    speed: readNumber(from, 'speed'),
    bodies: readNumber(from, 'bodies'),
    clients: readNumber(from, 'clients'),
    kinetic: readNullable(from, 'kinetic', readNumber),
    potential: readNullable(from, 'potential', readNumber),
    energy: readNullable(from, 'energy', readNumber),
    energyDrift: readNullable(from, 'energyDrift', readNumber),
    momentum: readNullable(from, 'momentum', readVec2),
    momentumDrift: readNullable(from, 'momentumDrift', readNumber),
    angularMomentum: readNullable(from, 'angularMomentum', readNumber),
    angularMomentumDrift: readNullable(from, 'angularMomentumDrift', readNumber),
    centreOfMassX: readNullable(from, 'centreOfMassX', readNumber),
    centreOfMassY: readNullable(from, 'centreOfMassY', readNumber),
    virialRatio: readNullable(from, 'virialRatio', readNumber),
    gravitySolver: readNullable(from, 'gravitySolver', readString),
    forceError: readNullable(from, 'forceError', readNumber),
  };
}

/** Decodes `/topic/events`. */
export function decodeEvents(text: string): ShipEvents {
  const from = readObject(parse(text, 'events'), 'events');
  return {
    tick: readNumber(from, 'tick'),
    unlisted: readNumber(from, 'unlisted'),
    events: readArray(from.events, 'events').map(readEvent),
  };
}

const EVENT_TYPES = ['arrived', 'collided', 'destroyed'] as const;
const KINDS = ['planet', 'asteroid', 'ship'] as const;

function readEvent(value: unknown): ShipEvent {
  const event = readObject(value, 'event');
  const type = EVENT_TYPES.find((known) => known === event.type);
  if (!type) throw new BadMessage(`type must be ${EVENT_TYPES.join(', ')}, was ${event.type}`);
  return {
    number: readNumber(event, 'number'),
    tick: readNumber(event, 'tick'),
    time: readNumber(event, 'time'),
    type,
    ship: readId(event, 'ship'),
    other: readNullable(event, 'other', readOther),
    speed: readNullable(event, 'speed', readNumber),
  };
}

function readOther(from: ReturnType<typeof readObject>, key: string): { id: BodyId; kind: BodyKind } {
  const other = readObject(from[key], key);
  const kind = KINDS.find((known) => known === other.kind);
  if (!kind) throw new BadMessage(`kind must be ${KINDS.join(', ')}, was ${other.kind}`);
  return { id: readId(other, 'id'), kind };
}

/** Decodes `/user/queue/ship`. */
export function decodeShip(text: string): ShipReading {
  const ship = readObject(parse(text, 'ship'), 'ship');
  if (typeof ship.evading !== 'boolean') throw new BadMessage(`evading must be true or false, was ${ship.evading}`);
  return {
    id: readId(ship, 'id'),
    tick: readNumber(ship, 'tick'),
    time: readNumber(ship, 'time'),
    target: readNullable(ship, 'target', readVec2),
    course: readVec2(ship, 'course'),
    evading: ship.evading,
    acceleration: readVec2(ship, 'acceleration'),
    threat: readNullable(ship, 'threat', readThreat),
  };
}

function readThreat(from: ReturnType<typeof readObject>, key: string): Threat {
  const threat = readObject(from[key], key);
  const passing = readObject(threat.passing, 'passing');
  return {
    id: readId(threat, 'id'),
    timeToContact: readNumber(threat, 'timeToContact'),
    passing: {
      time: readNumber(passing, 'time'),
      gap: readNumber(passing, 'gap'),
      ship: readVec2(passing, 'ship'),
      body: readVec2(passing, 'body'),
    },
  };
}

function readId(from: ReturnType<typeof readObject>, key: string): BodyId {
  const id = readNumber(from, key);
  if (!Number.isSafeInteger(id) || id <= 0) throw new BadMessage(`${key} must be a positive integer, was ${id}`);
  return id as BodyId;
}

/** Decodes `/user/queue/replies`. */
export function decodeReply(text: string): Reply {
  const reply = readObject(parse(text, 'reply'), 'reply');
  const ids = readArray(reply.ids, 'ids');
  if (!ids.every(Number.isSafeInteger)) throw new BadMessage(`ids must be integers, was ${JSON.stringify(ids)}`);
  return { command: readString(reply, 'command'), ids: ids as readonly BodyId[], tick: readNumber(reply, 'tick') };
}

/** Decodes `/user/queue/errors`, and the body of a STOMP ERROR frame. */
export function decodeProblem(text: string): Problem {
  const problem = readObject(parse(text, 'problem'), 'problem');
  return {
    code: readString(problem, 'code'),
    message: readString(problem, 'message'),
    field: readNullable(problem, 'field', readString),
  };
}

function boundary(value: unknown): Boundary {
  const from = readObject(value, 'boundary');
  const kind = readString(from, 'kind');
  if (kind === 'open') return { kind };
  if (kind === 'walls' || kind === 'periodic') return { kind, ...bounds(from) };
  throw new BadMessage(`boundary must be open, walls or periodic, was ${kind}`);
}

function bounds(from: ReturnType<typeof readObject>): Bounds {
  return {
    minX: readNumber(from, 'minX'),
    minY: readNumber(from, 'minY'),
    maxX: readNumber(from, 'maxX'),
    maxY: readNumber(from, 'maxY'),
  };
}

function readVec2(from: ReturnType<typeof readObject>, key: string): Vec2 {
  const vector = readObject(from[key], key);
  return { x: readNumber(vector, 'x'), y: readNumber(vector, 'y') };
}
