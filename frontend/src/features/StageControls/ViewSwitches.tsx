import { useSyncExternalStore } from 'react';
import { Button } from '../../ui/Button';
import { Segments } from '../../ui/Segments';
import type { ViewOptions } from '../../world/ViewOptions';
import type { World } from '../../world/World';
import styles from './StageControls.module.css';

const SWITCHES: readonly { option: keyof ViewOptions; label: string; title: string }[] = [
  { option: 'trails', label: 'Trails', title: 'Where the selected bodies have been' },
  { option: 'velocity', label: 'Velocity', title: 'Velocity of the selected bodies' },
  { option: 'force', label: 'Force', title: 'Force on the selected bodies, dashed' },
  { option: 'plan', label: 'Plan', title: 'Thrust, course and nearest threat of the ship selected last' },
  { option: 'grid', label: 'Grid', title: 'Grid in units of the scene' },
];

/** What the stage shows beside the bodies. */
export function ViewSwitches({ world }: { world: World }) {
  const view = useSyncExternalStore(world.view.subscribe, world.view.current);
  return (
    <div className={styles.switches}>
      <Segments label="Show on the stage">
        {SWITCHES.map(({ option, label, title }) => (
          <Button key={option} aria-pressed={view[option]} title={title} onClick={() => world.toggleView(option)}>
            {label}
          </Button>
        ))}
      </Segments>
    </div>
  );
}
