import { type Ref, useRef, useState, useSyncExternalStore } from 'react';
import type { BodyId } from '../../protocol/frame';
import { Button } from '../../ui/Button';
import { formatCount } from '../../ui/formatNumber';
import { Icon } from '../../ui/Icon';
import { unitSymbol } from '../../ui/unit';
import type { World } from '../../world/World';
import { BodyList } from './BodyList';
import styles from './InfoSection.module.css';
import { holdOrder, listBodies, nextSort, SORT_LABELS, type SortBy } from './listBodies';

type InfoSectionProps = {
  world: World;
  isOffline: boolean;
  onSelect: (id: BodyId, isAdding: boolean) => void;
  onDelete: (id: BodyId) => void;
  findRef?: Ref<HTMLInputElement>;
};

/** Every body as a card, with a box to find one and a choice of order. */
export function InfoSection({ world, isOffline, onSelect, onDelete, findRef }: InfoSectionProps) {
  const [find, setFind] = useState('');
  const [sort, setSort] = useState<SortBy>('speed');
  const isHeld = useRef(false);
  const shown = useRef<readonly BodyId[]>([]);
  useSyncExternalStore(world.frames.subscribe, world.frames.version);
  const room = useSyncExternalStore(world.room.subscribe, world.room.current);
  const hasFrame = world.frames.arrivedAtMs() !== null;
  const { count } = world.frames.newest;

  const listed = listBodies(world.frames.newest, find, sort);
  const ids = isHeld.current ? holdOrder(listed, shown.current) : listed;
  shown.current = ids;

  function changeSort(): void {
    shown.current = [];
    setSort(nextSort(sort));
  }

  return (
    <section className={styles.section} aria-label="Bodies">
      <div className={styles.find}>
        <input
          ref={findRef}
          type="search"
          className={styles.input}
          placeholder="Find by id or type"
          aria-label="Find by id or type"
          value={find}
          onChange={(event) => setFind(event.target.value)}
        />
        <Button
          className={styles.sort}
          aria-label={`Sorted by ${SORT_LABELS[sort]}, change to ${SORT_LABELS[nextSort(sort)]}`}
          title={`Sort by ${SORT_LABELS[nextSort(sort)].toLowerCase()}`}
          onClick={changeSort}
        >
          {SORT_LABELS[sort]} <Icon name={sort === 'id' ? 'up' : 'down'} />
        </Button>
      </div>
      <div className={styles.columns} aria-hidden="true">
        <span className={styles.count}>{hasFrame ? countText(ids.length, count) : ''}</span>
        <span className={styles.column}>
          Mass <i>{room && unitSymbol(room.units.mass)}</i>
        </span>
        <span className={styles.column}>
          Speed <i>{room && `${unitSymbol(room.units.length)}/${unitSymbol(room.units.time)}`}</i>
        </span>
      </div>
      {hasFrame && ids.length > 0 && (
        <BodyList
          world={world}
          ids={ids}
          isOffline={isOffline}
          onSelect={onSelect}
          onDelete={onDelete}
          onHold={(held) => {
            isHeld.current = held;
          }}
        />
      )}
      {hasFrame && ids.length === 0 && <p className={styles.empty}>{emptyText(count, find)}</p>}
      {!hasFrame && <Skeleton />}
    </section>
  );
}

function countText(listed: number, all: number): string {
  const bodies = all === 1 ? 'body' : 'bodies';
  return listed === all ? `${formatCount(all)} ${bodies}` : `${formatCount(listed)} of ${formatCount(all)}`;
}

function emptyText(count: number, find: string): string {
  return count === 0 ? 'Bodies show up here as soon as they exist.' : `No body is called “${find.trim()}”.`;
}

function Skeleton() {
  return (
    <div className={styles.skeleton} aria-hidden="true">
      {[0, 1, 2, 3, 4, 5].map((row) => (
        <span key={row} />
      ))}
    </div>
  );
}
