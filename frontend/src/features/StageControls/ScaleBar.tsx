import { formatNumber } from '../../ui/formatNumber';
import styles from './StageControls.module.css';

type ScaleBarProps = { length: number; pixelsPerUnit: number; unit: string };

/** How long a stretch of the stage is: one step of the grid. */
export function ScaleBar({ length, pixelsPerUnit, unit }: ScaleBarProps) {
  const text = length >= 1 ? formatNumber(length).replace(/\.0+$/, '') : String(Number(length.toPrecision(3)));
  return (
    <div className={styles.scale}>
      <div className={styles.bar} style={{ width: length * pixelsPerUnit }} />
      {text} {unit}
    </div>
  );
}
