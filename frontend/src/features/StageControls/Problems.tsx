import { useSyncExternalStore } from 'react';
import { Icon } from '../../ui/Icon';
import type { World } from '../../world/World';
import styles from './StageControls.module.css';

/** Why something was refused: short, beside the stage, gone after a while. */
export function Problems({ world }: { world: World }) {
  const { notices } = world;
  const problems = useSyncExternalStore(notices.subscribe, notices.problems);
  return (
    <div role="alert" className={styles.problems}>
      {problems.map(({ key, text }) => (
        <p key={key} className={styles.problem}>
          <span>{text}</span>
          <button type="button" className={styles.dismiss} aria-label="Dismiss" onClick={() => notices.dismiss(key)}>
            <Icon name="close" />
          </button>
        </p>
      ))}
    </div>
  );
}
