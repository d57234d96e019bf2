import type { ReactNode } from 'react';
import styles from './Inspector.module.css';

type FactProps = { label: string; value: ReactNode; unit?: string };

/** One figure of the inspector. */
export function Fact({ label, value, unit }: FactProps) {
  return (
    <div className={styles.fact}>
      <dt>{label}</dt>
      <dd>
        {value} {unit && <span className={styles.unit}>{unit}</span>}
      </dd>
    </div>
  );
}
