import type { KeyboardEvent } from 'react';
import type { BodyId, BodyKind } from '../../protocol/frame';
import { formatNumber } from '../../ui/formatNumber';
import { Glyph } from '../../ui/Glyph';
import { Icon } from '../../ui/Icon';
import { bodyName } from '../../world/bodyName';
import styles from './BodyCard.module.css';

export type BodyReading = {
  readonly id: BodyId;
  readonly kind: BodyKind;
  readonly mass: number;
  readonly speed: number;
};

type BodyCardProps = {
  body: BodyReading;
  isSelected: boolean;
  isHovered: boolean;
  isOffline: boolean;
  /** One card of the list is in the tab order; arrows lead to the others. */
  isTabStop: boolean;
  onSelect: (id: BodyId, isAdding: boolean) => void;
  onDelete: (id: BodyId) => void;
  onHover: (id: BodyId | null) => void;
  onKeyDown: (event: KeyboardEvent) => void;
};

/** One body in the list: its kind, mass and speed, a way to select it and a way to delete it. */
export function BodyCard(props: BodyCardProps) {
  const { body, isSelected, isHovered, isOffline, isTabStop, onSelect, onDelete, onHover, onKeyDown } = props;
  const name = bodyName(body.kind, body.id);
  const tabIndex = isTabStop ? 0 : -1;
  return (
    <div
      className={styles.card}
      data-selected={isSelected}
      data-hovered={isHovered}
      onPointerEnter={() => onHover(body.id)}
      onPointerLeave={() => onHover(null)}
    >
      <button
        type="button"
        className={styles.select}
        aria-pressed={isSelected}
        aria-label={`${name}, mass ${formatNumber(body.mass)}, speed ${formatNumber(body.speed)}`}
        data-body={body.id}
        tabIndex={tabIndex}
        onKeyDown={onKeyDown}
        onClick={(event) => onSelect(body.id, event.shiftKey || event.ctrlKey || event.metaKey)}
      >
        <Glyph shape={body.kind} isRinged={isSelected} />
        <span className={styles.name}>{name}</span>
        <span className={styles.number}>{formatNumber(body.mass)}</span>
        <span className={styles.number}>{formatNumber(body.speed)}</span>
      </button>
      <button
        type="button"
        className={styles.delete}
        aria-label={`Delete ${name}`}
        disabled={isOffline}
        tabIndex={tabIndex}
        onClick={() => onDelete(body.id)}
      >
        <Icon name="trash" />
      </button>
    </div>
  );
}
