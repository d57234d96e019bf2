import { useSyncExternalStore } from 'react';
import type { World } from '../../world/World';
import styles from './FigureTable.module.css';
import { figureGroups, type LinkFigures } from './figureGroups';

type FigureTableProps = { world: World; link: LinkFigures | null };

/** Every figure of the room, the link and the drawing, in groups. */
export function FigureTable({ world, link }: FigureTableProps) {
  const newest = useSyncExternalStore(world.history.subscribe, world.history.newest);
  const drawnHz = useSyncExternalStore(world.drawnHz.subscribe, world.drawnHz.current);
  return (
    <div className={styles.groups} data-stale={link === null}>
      {figureGroups(newest, link, drawnHz).map(({ title, figures }) => (
        <div key={title} className={styles.group}>
          <h2 className={styles.title}>{title}</h2>
          <dl>
            {figures.map(([label, value]) => (
              <div key={label} className={styles.row}>
                <dt>{label}</dt>
                <dd>{value}</dd>
              </div>
            ))}
          </dl>
        </div>
      ))}
    </div>
  );
}
