import styles from './Icon.module.css';

const PATHS = {
  trash: 'M3 4.5h10M6.5 4V2.5h3V4M4.5 4.5l.6 9h5.8l.6-9M7 7v4M9 7v4',
  down: 'M8 3v10M4.5 9.5 8 13l3.5-3.5',
  up: 'M8 13V3M4.5 6.5 8 3l3.5 3.5',
  close: 'm4 4 8 8M12 4l-8 8',
} as const;

/** A line icon in the colour of the text around it. */
export function Icon({ name }: { name: keyof typeof PATHS }) {
  return (
    <svg viewBox="0 0 16 16" className={styles.icon} aria-hidden="true">
      <path d={PATHS[name]} />
    </svg>
  );
}
