import { useSyncExternalStore } from 'react';
import type { BodyKind } from '../../protocol/frame';
import { Button } from '../../ui/Button';
import { formatCoordinate, formatRange } from '../../ui/formatNumber';
import { Glyph } from '../../ui/Glyph';
import { Icon } from '../../ui/Icon';
import { unitSymbol } from '../../ui/unit';
import { useMedia } from '../../ui/useMedia';
import { bodyName, countOf } from '../../world/bodyName';
import type { FrameColumns } from '../../world/FrameColumns';
import type { World } from '../../world/World';
import { Fact } from './Fact';
import styles from './Inspector.module.css';
import { ShipFacts } from './ShipFacts';

type InspectorProps = { world: World; isOffline: boolean; onDelete: () => void };

/** What is selected: its figures, where it is ordered to, and what can be done with it. */
export function Inspector({ world, isOffline, onDelete }: InspectorProps) {
  useSyncExternalStore(world.frames.subscribe, world.frames.version);
  const selected = useSyncExternalStore(world.selection.subscribe, world.selection.ids);
  const view = useSyncExternalStore(world.view.subscribe, world.view.current);
  const room = useSyncExternalStore(world.room.subscribe, world.room.current);
  const hasFingers = useMedia('(pointer: coarse)');
  const frame = world.frames.newest;
  const slots = selected.map((id) => frame.slot.get(id)).filter((slot) => slot !== undefined);
  if (slots.length === 0) {
    return (
      <section className={styles.inspector} aria-label="Selected">
        <h2 className={styles.none}>Nothing selected</h2>
        <p className={styles.help}>
          {hasFingers
            ? 'Tap a body on the stage or in the list. A long touch on the stage selects several.'
            : 'Click a body on the stage or in the list. Hold Shift to select several.'}
        </p>
      </section>
    );
  }

  const kind = commonKind(frame, slots);
  const name = slots.length === 1 ? bodyName(frame.kindAt(slots[0]!), selected[0]!) : countOf(slots.length, kind);
  const of = (column: Float64Array) => slots.map((slot) => column[slot]!);
  const length = room ? unitSymbol(room.units.length) : '';
  return (
    <section className={styles.inspector} aria-label="Selected">
      <div className={styles.head}>
        <span className={styles.glyph}>
          <Glyph shape={kind === 'body' ? 'group' : kind} />
        </span>
        <h2 className={styles.name}>{name}</h2>
        <Button aria-pressed={view.follow} onClick={() => world.toggleView('follow')}>
          Follow
        </Button>
        <Button aria-label={`Delete ${name}`} title={`Delete ${name}`} disabled={isOffline} onClick={onDelete}>
          <Icon name="trash" />
        </Button>
      </div>
      <dl className={styles.facts}>
        <Fact label="Mass" value={formatRange(of(frame.mass))} unit={room ? unitSymbol(room.units.mass) : ''} />
        <Fact
          label="Speed"
          value={formatRange(slots.map((slot) => frame.speedAt(slot)))}
          unit={room ? `${length}/${unitSymbol(room.units.time)}` : ''}
        />
        <Fact label="Radius" value={formatRange(of(frame.radius))} unit={length} />
        {slots.length === 1 && (
          <Fact label="Position" value={point(frame.x[slots[0]!]!, frame.y[slots[0]!]!)} unit={length} />
        )}
        {kind === 'ship' && <Fact label="Order" value={<Order frame={frame} slots={slots} />} />}
        {kind === 'ship' && slots.length === 1 && <ShipFacts world={world} />}
      </dl>
    </section>
  );
}

/** A fleet is sent into a formation: as long as the places are near each other, its middle is the order. */
function Order({ frame, slots }: { frame: FrameColumns; slots: readonly number[] }) {
  const ordered = slots.filter((slot) => !Number.isNaN(frame.targetX[slot]!));
  if (ordered.length === 0) {
    return <span className={styles.unit}>{slots.length === 1 ? 'none, it wanders' : 'none, they wander'}</span>;
  }
  const x = middle(ordered.map((slot) => frame.targetX[slot]!));
  const y = middle(ordered.map((slot) => frame.targetY[slot]!));
  const isOne = ordered.every(
    (slot) => Math.hypot(frame.targetX[slot]! - x, frame.targetY[slot]! - y) < 20 * frame.radius[slot]!,
  );
  return <span className={styles.order}>{isOne ? `Seek ${point(x, y)}` : `Seek ${ordered.length} points`}</span>;
}

function middle(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

function commonKind(frame: FrameColumns, slots: readonly number[]): BodyKind | 'body' {
  const kind = frame.kindAt(slots[0]!);
  return slots.every((slot) => frame.kindAt(slot) === kind) ? kind : 'body';
}

function point(x: number, y: number): string {
  return `${formatCoordinate(x)}, ${formatCoordinate(y)}`;
}
