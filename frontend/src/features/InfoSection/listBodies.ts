import type { BodyId } from '../../protocol/frame';
import { bodyName } from '../../world/bodyName';
import type { FrameColumns } from '../../world/FrameColumns';

export type SortBy = 'speed' | 'mass' | 'id';

export const SORT_LABELS: Record<SortBy, string> = { speed: 'Speed', mass: 'Mass', id: 'Id' };

const NEXT: Record<SortBy, SortBy> = { speed: 'mass', mass: 'id', id: 'speed' };

/** What the sort button leads to next. */
export function nextSort(sort: SortBy): SortBy {
  return NEXT[sort];
}

/** The bodies whose name contains what was typed; fastest, heaviest or oldest first. */
export function listBodies(frame: FrameColumns, find: string, sort: SortBy): BodyId[] {
  const wanted = find.trim().toLowerCase();
  const ids: BodyId[] = [];
  for (let i = 0; i < frame.count; i++) {
    const id = frame.idAt(i);
    if (wanted === '' || bodyName(frame.kindAt(i), id).toLowerCase().includes(wanted)) ids.push(id);
  }
  const rank = rankOf(frame, sort);
  return ids.sort((a, b) => rank(b) - rank(a) || a - b);
}

/** The same bodies in the order that the reader has before their eyes; new ones at the end, so that no row jumps. */
export function holdOrder(ids: readonly BodyId[], shown: readonly BodyId[]): BodyId[] {
  const wanted = new Set(ids);
  const old = new Set(shown);
  return [...shown.filter((id) => wanted.has(id)), ...ids.filter((id) => !old.has(id))];
}

function rankOf(frame: FrameColumns, sort: SortBy): (id: BodyId) => number {
  const { slot } = frame;
  if (sort === 'id') return (id) => -id;
  if (sort === 'mass') return (id) => frame.mass[slot.get(id)!]!;
  return (id) => frame.speedAt(slot.get(id)!);
}
