/** A message that breaks the treaty. Its text names the field and what came. */
export class BadMessage extends Error {}

type Fields = Readonly<Record<string, unknown>>;

export function readObject(value: unknown, name: string): Fields {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw bad(name, 'an object', value);
  return value as Fields;
}

export function readArray(value: unknown, name: string): readonly unknown[] {
  if (!Array.isArray(value)) throw bad(name, 'an array', value);
  return value;
}

export function readNumber(from: Fields, key: string): number {
  const value = from[key];
  // JSON has no NaN, but 1e999 parses to infinity.
  if (typeof value !== 'number' || !Number.isFinite(value)) throw bad(key, 'a finite number', value);
  return value;
}

export function readString(from: Fields, key: string): string {
  const value = from[key];
  if (typeof value !== 'string') throw bad(key, 'a string', value);
  return value;
}

/** Checks the two numbers in place; a frame of 2000 bodies holds some 30 000 of them, so nothing is copied. */
export function checkVec2(value: unknown, name: string): void {
  const vector = readObject(value, name);
  readNumber(vector, 'x');
  readNumber(vector, 'y');
}

/** Reads a field that may be null; a missing one counts as null, so that an older server is still understood. */
export function readNullable<T>(from: Fields, key: string, read: (from: Fields, key: string) => T): T | null {
  return from[key] === null || from[key] === undefined ? null : read(from, key);
}

export function parse(text: string, name: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    throw new BadMessage(`${name} must be JSON, was ${text.slice(0, 40)}`);
  }
}

function bad(name: string, allowed: string, value: unknown): BadMessage {
  return new BadMessage(`${name} must be ${allowed}, was ${JSON.stringify(value)?.slice(0, 40)}`);
}
