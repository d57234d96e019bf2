import { useVirtualizer } from '@tanstack/react-virtual';
import { type KeyboardEvent, useEffect, useRef, useState, useSyncExternalStore } from 'react';
import type { BodyId } from '../../protocol/frame';
import { tokenPx } from '../../ui/tokenPx';
import { PHONE, useMedia } from '../../ui/useMedia';
import type { FrameColumns } from '../../world/FrameColumns';
import type { World } from '../../world/World';
import { BodyCard, type BodyReading } from './BodyCard';
import styles from './BodyList.module.css';

type BodyListProps = {
  world: World;
  ids: readonly BodyId[];
  isOffline: boolean;
  onSelect: (id: BodyId, isAdding: boolean) => void;
  onDelete: (id: BodyId) => void;
  /** The pointer or the focus is in the list: its order must hold. */
  onHold: (isHeld: boolean) => void;
};

/** The cards that are in view, of as many bodies as there are. The stage's twin for everyone who cannot see it. */
export function BodyList({ world, ids, isOffline, onSelect, onDelete, onHold }: BodyListProps) {
  const scroller = useRef<HTMLDivElement>(null);
  const [active, setActive] = useState<BodyId | null>(null);
  const selected = useSyncExternalStore(world.selection.subscribe, world.selection.ids);
  const hovered = useSyncExternalStore(world.hovered.subscribe, world.hovered.current);
  const isPhone = useMedia(PHONE);
  const virtual = useVirtualizer({
    count: ids.length,
    getScrollElement: () => scroller.current,
    estimateSize: () => tokenPx('--card-height', 40) + tokenPx('--card-gap', 2),
    getItemKey: (index) => ids[index]!,
    overscan: 6,
    useFlushSync: false,
  });

  // biome-ignore lint/correctness/useExhaustiveDependencies: the height of a card is another one on a phone.
  useEffect(() => virtual.measure(), [virtual, isPhone]);

  const main = selected.at(-1);
  // biome-ignore lint/correctness/useExhaustiveDependencies: only a new selection moves the list, not a new order of it.
  useEffect(() => {
    const box = scroller.current;
    if (main === undefined || box?.matches(':hover, :focus-within')) return;
    const index = ids.indexOf(main);
    if (index >= 0) virtual.scrollToIndex(index, { align: 'auto' });
  }, [main]);

  const items = virtual.getVirtualItems();
  // The tab order needs a card that is there: the one last used, the selected one, or the first in view.
  const rendered = items.map(({ index }) => ids[index]!);
  const tabStop = [active, main].find((id) => id != null && rendered.includes(id)) ?? rendered[0];

  function move(event: KeyboardEvent, from: number): void {
    const to = STEPS[event.key]?.(from, ids.length - 1);
    if (to === undefined || ids[to] === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    setActive(ids[to]);
    virtual.scrollToIndex(to, { align: 'auto' });
    requestAnimationFrame(() => scroller.current?.querySelector<HTMLElement>(`[data-body="${ids[to]}"]`)?.focus());
  }

  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: it only listens whether somebody is reading in it.
    <div
      ref={scroller}
      className={styles.scroller}
      onPointerEnter={() => onHold(true)}
      onPointerLeave={(event) => onHold(event.currentTarget.matches(':focus-within'))}
      onFocus={(event) => {
        onHold(true);
        setActive(Number(event.target.dataset.body ?? active) as BodyId);
      }}
      onBlur={() => onHold(false)}
    >
      <ul className={styles.list} aria-label="Bodies" style={{ height: virtual.getTotalSize() }}>
        {items.map(({ index, start, key }) => {
          const body = readingOf(world.frames.newest, ids[index]!);
          return (
            <li
              key={key}
              className={styles.row}
              style={{ transform: `translateY(${start}px)` }}
              aria-setsize={ids.length}
              aria-posinset={index + 1}
            >
              {body && (
                <BodyCard
                  body={body}
                  isSelected={selected.includes(body.id)}
                  isHovered={hovered === body.id}
                  isOffline={isOffline}
                  isTabStop={body.id === tabStop}
                  onSelect={onSelect}
                  onDelete={onDelete}
                  onHover={(id) => world.hovered.set(id)}
                  onKeyDown={(event) => move(event, index)}
                />
              )}
            </li>
          );
        })}
      </ul>
    </div>
  );
}

const STEPS: Readonly<Record<string, (from: number, last: number) => number>> = {
  ArrowDown: (from) => from + 1,
  ArrowUp: (from) => from - 1,
  Home: () => 0,
  End: (_from, last) => last,
};

function readingOf(frame: FrameColumns, id: BodyId): BodyReading | null {
  const i = frame.slot.get(id);
  return i === undefined ? null : { id, kind: frame.kindAt(i), mass: frame.mass[i]!, speed: frame.speedAt(i) };
}
