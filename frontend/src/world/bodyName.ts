import type { BodyId, BodyKind } from '../protocol/frame';

const NAMES: Record<BodyKind, string> = { planet: 'Planet', asteroid: 'Asteroid', ship: 'Ship' };

/** "Ship 17": the same name on the stage, in the list and in what is announced. */
export function bodyName(kind: BodyKind, id: BodyId): string {
  return `${NAMES[kind]} ${id}`;
}

/** "3 ships", "1 planet", "4 bodies". */
export function countOf(count: number, kind: BodyKind | 'body'): string {
  const plural = kind === 'body' ? 'bodies' : `${kind}s`;
  return `${count} ${count === 1 ? kind : plural}`;
}
