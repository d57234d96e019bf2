import type { AddCommand } from '../../protocol/commands';
import { Button } from '../../ui/Button';
import { Glyph, type GlyphShape } from '../../ui/Glyph';
import styles from './StageControls.module.css';

const ADD: readonly { type: AddCommand; label: string; shape: GlyphShape }[] = [
  { type: 'random-planet', label: 'Planet', shape: 'planet' },
  { type: 'random-asteroid', label: 'Asteroid', shape: 'asteroid' },
  { type: 'random-spaceship', label: 'Ship', shape: 'ship' },
];

type EmptyStageProps = { isOffline: boolean; onAdd: (type: AddCommand) => void };

/** A room without bodies: what to do about it. */
export function EmptyStage({ isOffline, onAdd }: EmptyStageProps) {
  return (
    <div className={styles.empty}>
      <h2 className={styles.emptyTitle}>No bodies yet</h2>
      <p className={styles.emptyText}>Add bodies one by one.</p>
      <div className={styles.emptyActions}>
        {ADD.map(({ type, label, shape }) => (
          <Button
            key={type}
            className={styles.emptyAction}
            aria-label={`Add a first ${label.toLowerCase()}`}
            disabled={isOffline}
            onClick={() => onAdd(type)}
          >
            <Glyph shape={shape} />
            {label}
          </Button>
        ))}
      </div>
    </div>
  );
}
