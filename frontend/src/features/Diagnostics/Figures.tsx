import { type ReactNode, useSyncExternalStore } from 'react';
import { formatCount, formatDrift, formatMillis } from '../../ui/formatNumber';
import type { World } from '../../world/World';
import styles from './Figures.module.css';
import { Sparkline } from './Sparkline';

type FiguresProps = {
  world: World;
  /** Of the link, which only the page's frame knows; null while it is down. */
  link: { readonly delayMs: number; readonly bytesPerSecond: number } | null;
};

/** How the room, the link and the drawing are doing. The proof beside the picture. */
export function Figures({ world, link }: FiguresProps) {
  const newest = useSyncExternalStore(world.history.subscribe, world.history.newest);
  const drawnHz = useSyncExternalStore(world.drawnHz.subscribe, world.drawnHz.current);
  const { tickMillis, energyDrift } = world.history;
  return (
    <dl className={styles.figures} data-stale={link === null}>
      <Figure label="Bodies" value={newest && formatCount(newest.bodies)} />
      <Figure label="Tick" value={newest && `${formatMillis(newest.tickMillis.p50)} ms`}>
        <Sparkline values={tickMillis} />
      </Figure>
      <Figure label="Energy drift" value={newest && driftText(newest.energyDrift)}>
        <Sparkline values={energyDrift} trend="ok" />
      </Figure>
      <Figure label="Momentum drift" value={newest && driftText(newest.momentumDrift)} isMinor />
      <Figure label="Ticks/s" value={newest && formatCount(newest.ticksPerSecond)} isMinor />
      <Figure label="Delay" value={link && `${formatCount(link.delayMs)} ms`} />
      <Figure label="Stream" value={link && `${formatCount(link.bytesPerSecond / 1000)} kB/s`} isMinor />
      <Figure label="Clients" value={newest && formatCount(newest.clients)} isMinor />
      <Figure label="Drawing" value={`${drawnHz} fps`} isLast />
    </dl>
  );
}

type FigureProps = {
  label: string;
  value: string | null;
  /** Left out where there is no width for it. */
  isMinor?: boolean;
  isLast?: boolean;
  children?: ReactNode;
};

function Figure({ label, value, isMinor = false, isLast = false, children }: FigureProps) {
  return (
    <div className={styles.figure} data-minor={isMinor} data-last={isLast}>
      <dt>{label}</dt>
      <dd>
        {value ?? 'none'} {children}
      </dd>
    </div>
  );
}

/** A scene that does not ask for it has no drift to show. */
function driftText(drift: number | null): string {
  return drift === null ? 'none' : formatDrift(drift);
}
