import { type KeyboardEvent, type ReactNode, useId, useRef, useState, useSyncExternalStore } from 'react';
import { formatCount, formatMillis } from '../../ui/formatNumber';
import type { World } from '../../world/World';
import styles from './Figures.module.css';
import { FigureTable } from './FigureTable';
import { driftText, type LinkFigures, numberText } from './figureGroups';
import { Sparkline } from './Sparkline';

type FiguresProps = { world: World; link: LinkFigures | null };

/**
 * How the room, the link and the drawing are doing, in one line: the proof beside the picture. What has no width left
 * stands in the table of all figures, which a button opens above the line.
 */
export function Figures({ world, link }: FiguresProps) {
  const newest = useSyncExternalStore(world.history.subscribe, world.history.newest);
  const drawnHz = useSyncExternalStore(world.drawnHz.subscribe, world.drawnHz.current);
  const [isOpen, setIsOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const table = useId();
  const { tickMillis, energyDrift } = world.history;

  function onKeyDown(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || !isOpen) return;
    event.preventDefault(); // the selection keeps its own Escape
    setIsOpen(false);
    button.current?.focus();
  }

  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: Escape closes the table from wherever in it the focus is
    <div className={styles.bar} onKeyDown={onKeyDown}>
      <dl className={styles.figures} data-stale={link === null}>
        <Figure label="Bodies" value={newest && formatCount(newest.bodies)} />
        <Figure label="Tick" value={newest && `${formatMillis(newest.tickMillis.p50)} ms`}>
          <Sparkline values={tickMillis} />
        </Figure>
        <Figure label="Energy" value={newest && numberText(newest.energy)} need="wide" />
        <Figure label="Energy drift" value={newest && driftText(newest.energyDrift)}>
          <Sparkline values={energyDrift} trend="ok" />
        </Figure>
        <Figure label="Momentum drift" value={newest && driftText(newest.momentumDrift)} need="medium" />
        <Figure label="Angular drift" value={newest && driftText(newest.angularMomentumDrift)} need="wide" />
        <Figure label="Virial ratio" value={newest && numberText(newest.virialRatio)} />
        <Figure label="Delay" value={link && `${formatCount(link.delayMs)} ms`} need="wide" />
        <Figure label="Drawing" value={`${drawnHz} fps`} isLast />
      </dl>
      <button
        ref={button}
        type="button"
        className={styles.more}
        aria-expanded={isOpen}
        aria-controls={table}
        onClick={() => setIsOpen(!isOpen)}
      >
        All figures
      </button>
      <section id={table} className={styles.table} aria-label="All figures" hidden={!isOpen}>
        {isOpen && <FigureTable world={world} link={link} />}
      </section>
    </div>
  );
}

type FigureProps = {
  label: string;
  value: string | null;
  /** The width of the page below which it is left to the table. */
  need?: 'narrow' | 'medium' | 'wide';
  isLast?: boolean;
  children?: ReactNode;
};

function Figure({ label, value, need = 'narrow', isLast = false, children }: FigureProps) {
  return (
    <div className={styles.figure} data-need={need} data-last={isLast}>
      <dt>{label}</dt>
      <dd>
        {value ?? 'none'} {children}
      </dd>
    </div>
  );
}
