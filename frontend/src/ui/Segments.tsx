import type { ReactNode } from 'react';
import styles from './Segments.module.css';

type SegmentsProps = { label: string; children: ReactNode };

/** Buttons that belong together, in one row without gaps. */
export function Segments({ label, children }: SegmentsProps) {
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset is for forms.
    <div role="group" aria-label={label} className={styles.segments}>
      {children}
    </div>
  );
}
