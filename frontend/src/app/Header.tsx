import { useSyncExternalStore } from 'react';
import type { Link } from '../connection/link';
import { Button } from '../ui/Button';
import { formatCount } from '../ui/formatNumber';
import { unitSymbol } from '../ui/unit';
import type { World } from '../world/World';
import styles from './Header.module.css';
import { LinkState } from './LinkState';

type HeaderProps = { world: World; link: Link; onHelp: () => void };

/** What one is looking at, its clock, and whether it is live. */
export function Header({ world, link, onHelp }: HeaderProps) {
  useSyncExternalStore(world.frames.subscribe, world.frames.version);
  const room = useSyncExternalStore(world.room.subscribe, world.room.current);
  return (
    <header className={styles.header}>
      <h1 className={styles.brand}>Apsis</h1>
      <span className={styles.scene}>{room?.title}</span>
      <span className={styles.clock}>
        {room && (
          <>
            t {clockText(world.frames.newest.time)} <span className={styles.unit}>{unitSymbol(room.units.time)}</span>
          </>
        )}
      </span>
      <SlowClock speed={world.frames.newest.speed} />
      <LinkState link={link} />
      <Button className={styles.help} aria-label="Keyboard shortcuts" title="Keyboard shortcuts (?)" onClick={onHelp}>
        ?
      </Button>
    </header>
  );
}

/** Whether the room's clock keeps up with real time; its physics is the same at any speed. */
export function SlowClock({ speed }: { speed: number }) {
  if (speed >= 1) return null;
  const percent = Math.round(100 * speed);
  return (
    <span
      className={styles.slow}
      title={`This room is too heavy for its server: its clock runs at ${percent} % of real time. Every tick is as exact as ever.`}
    >
      {percent} % speed
    </span>
  );
}

/** Two decimals as long as they are more than flicker. */
function clockText(time: number): string {
  const whole = Math.floor(time);
  return time < 1e5 ? `${formatCount(whole)}${(time - whole).toFixed(2).slice(1)}` : formatCount(time);
}
