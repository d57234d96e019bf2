import type { BodyState, Frame } from './frame';
import { BadMessage, checkVec2, parse, readArray, readNumber, readObject } from './read';

/** The STOMP headers that come with a frame. */
export type FrameHeaders = Readonly<Record<string, string | undefined>>;

/**
 * Decodes `/topic/bodies`. Every field is checked once, here, and trusted afterwards; the parsed objects themselves are
 * handed on, because a copy of 2000 bodies 30 times a second would be garbage.
 */
export function decodeFrame(text: string, headers: FrameHeaders): Frame {
  const bodies = readArray(parse(text, 'bodies'), 'bodies');
  for (const body of bodies) checkBody(body);
  return {
    tick: numberHeader(headers, 'tick'),
    time: numberHeader(headers, 'time'),
    sent: numberHeader(headers, 'sent'),
    speed: numberHeader(headers, 'speed'),
    bodies: bodies as readonly BodyState[],
  };
}

function checkBody(value: unknown): void {
  const body = readObject(value, 'body');
  const id = readNumber(body, 'id');
  if (!Number.isSafeInteger(id) || id <= 0) throw new BadMessage(`id must be a positive integer, was ${id}`);
  checkVec2(body.position, 'position');
  checkVec2(body.velocity, 'velocity');
  checkVec2(body.acceleration, 'acceleration');
  readNumber(body, 'mass');
  readNumber(body, 'radius');
  if (typeof body.selected !== 'boolean') throw new BadMessage(`selected must be true or false, was ${body.selected}`);
  switch (body.kind) {
    case 'planet':
      return;
    case 'asteroid':
      readNumber(body, 'angle');
      for (const vertex of readArray(body.vertices, 'vertices')) checkVec2(vertex, 'vertex');
      return;
    case 'ship':
      readNumber(body, 'thrust');
      if (body.target !== undefined) checkVec2(body.target, 'target');
      return;
    default:
      throw new BadMessage(`kind must be planet, asteroid or ship, was ${body.kind}`);
  }
}

function numberHeader(headers: FrameHeaders, key: string): number {
  const value = Number(headers[key]);
  if (headers[key] === undefined || !Number.isFinite(value)) {
    throw new BadMessage(`header ${key} must be a number, was ${headers[key]}`);
  }
  return value;
}
