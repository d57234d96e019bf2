import type { Vec2 } from '../../protocol/frame';
import type { Threat } from '../../protocol/messages';
import { formatNumber } from '../../ui/formatNumber';
import { unitSymbol } from '../../ui/unit';
import { bodyName } from '../../world/bodyName';
import type { World } from '../../world/World';
import { Fact } from './Fact';
import styles from './Inspector.module.css';

/** What a ship is doing: where it is on its way to, what its engine does for it, and what is in the way. */
export function ShipFacts({ world }: { world: World }) {
  const reading = world.mainShip();
  const units = world.room.current()?.units;
  const length = units ? unitSymbol(units.length) : '';
  const time = units ? unitSymbol(units.time) : '';
  if (!reading) {
    // The room tells ten times a second: this is what a selection begins with, and what is left of it offline.
    return ['Course', 'Thrust', 'Threat'].map((label) => <Fact key={label} label={label} value={<Faint text="…" />} />);
  }
  const { course, evading, acceleration, threat } = reading;
  return (
    <>
      <Fact label={evading ? 'Detour' : 'Course'} value={vector(course)} unit={`${length}/${time}`} />
      <Fact label="Thrust" value={vector(acceleration)} unit={`${length}/${time}²`} />
      {threat ? (
        <>
          <Fact label="Threat" value={<Threatening world={world} threat={threat} />} unit={time} />
          <Fact label="Passing" value={<Gap threat={threat} unit={length} />} unit={time} />
        </>
      ) : (
        <Fact label="Threat" value={<Faint text="nothing in the way" />} />
      )}
      {world.room.current()?.ships === 'mortal' && <Fact label="If it hits" value="it is gone" />}
    </>
  );
}

function Threatening({ world, threat }: { world: World; threat: Threat }) {
  const { newest } = world.frames;
  const slot = newest.slot.get(threat.id);
  const name = slot === undefined ? `Body ${threat.id}` : bodyName(newest.kindAt(slot), threat.id);
  return (
    <>
      <span className={styles.threat}>{name}</span> in {threat.timeToContact.toFixed(1)}
    </>
  );
}

/** What will be left between the rims on the course that was chosen. */
function Gap({ threat: { passing }, unit }: { threat: Threat; unit: string }) {
  const when = `in ${passing.time.toFixed(1)}`;
  if (passing.gap < 0) return `contact ${when}`;
  return (
    <>
      {formatShort(passing.gap)} <span className={styles.unit}>{unit}</span> clear {when}
    </>
  );
}

function Faint({ text }: { text: string }) {
  return <span className={styles.unit}>{text}</span>;
}

/** "84.2 at 23°": counter-clockwise from the right of the stage. What is as good as nothing has no direction. */
function vector({ x, y }: Vec2): string {
  const size = formatShort(Math.hypot(x, y));
  if (size === '0') return size;
  const degrees = (Math.round((Math.atan2(y, x) * 180) / Math.PI) + 360) % 360;
  return `${size} at ${degrees}°`;
}

/** One decimal: these figures change too fast for more. */
function formatShort(size: number): string {
  return size >= 0.05 && size < 99.95 ? size.toFixed(1) : formatNumber(size < 0.05 ? 0 : size);
}
