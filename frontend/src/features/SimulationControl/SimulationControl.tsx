import type { AddCommand } from '../../protocol/commands';
import { Glyph, type GlyphShape } from '../../ui/Glyph';
import styles from './SimulationControl.module.css';

const ADD: readonly { type: AddCommand; label: string; key: string; shape: GlyphShape }[] = [
  { type: 'random-planet', label: 'Add planet', key: '1', shape: 'planet' },
  { type: 'random-asteroid', label: 'Add asteroid', key: '2', shape: 'asteroid' },
  { type: 'random-spaceship', label: 'Add ship', key: '3', shape: 'ship' },
  { type: 'random-body', label: 'Add random', key: '4', shape: 'dice' },
];

type SimulationControlProps = {
  isOffline: boolean;
  /** The keyboard's cross is out; Select puts it away. */
  isAiming: boolean;
  onAdd: (type: AddCommand) => void;
  onSelectTool: () => void;
};

/** The tool dock: back to selecting, and one button for each thing that can be added. */
export function SimulationControl({ isOffline, isAiming, onAdd, onSelectTool }: SimulationControlProps) {
  return (
    <div role="toolbar" aria-label="Tools" className={styles.dock}>
      <Tool label="Select" hint="V" shape="pointer" isOn={!isAiming} onClick={onSelectTool} />
      <hr className={styles.rule} />
      {ADD.map(({ type, label, key, shape }) => (
        <Tool key={type} label={label} hint={key} shape={shape} isDisabled={isOffline} onClick={() => onAdd(type)} />
      ))}
    </div>
  );
}

type ToolProps = {
  label: string;
  hint: string;
  shape: GlyphShape;
  isOn?: boolean;
  isDisabled?: boolean;
  onClick: () => void;
};

function Tool({ label, hint, shape, isOn, isDisabled, onClick }: ToolProps) {
  return (
    <button
      type="button"
      className={styles.tool}
      aria-pressed={isOn}
      aria-keyshortcuts={hint}
      aria-label={label}
      title={`${label} (${hint})`}
      disabled={isDisabled}
      onClick={onClick}
    >
      <span className={styles.glyph}>
        <Glyph shape={shape} />
      </span>
      <span className={styles.label}>{label}</span>
      <kbd className={styles.key}>{hint}</kbd>
    </button>
  );
}
