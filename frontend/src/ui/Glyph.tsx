import styles from './Glyph.module.css';

export type GlyphShape = 'planet' | 'asteroid' | 'ship' | 'dice' | 'pointer' | 'group';

const SHAPES: Record<GlyphShape, React.ReactNode> = {
  planet: <circle cx="11" cy="11" r="7" className={styles.planet} />,
  asteroid: <path d="M7 4l7-1 5 6-2 8-8 2-6-6z" className={styles.asteroid} />,
  ship: <path d="M19.5 11L4 4.6l3.2 6.4L4 17.4z" className={styles.ship} />,
  dice: (
    <g className={styles.line}>
      <rect x="4" y="4" width="14" height="14" rx="2" />
      <circle cx="8" cy="8" r="0.6" />
      <circle cx="14" cy="14" r="0.6" />
      <circle cx="11" cy="11" r="0.6" />
    </g>
  ),
  pointer: <path d="M5 3l12 8-6 1-2 6z" className={styles.line} />,
  group: (
    <g>
      <circle cx="7" cy="8" r="4" className={styles.planet} />
      <path d="M13 11l4-1 3 4-2 5-5 1-3-4z" className={styles.asteroid} />
    </g>
  ),
};

type GlyphProps = {
  shape: GlyphShape;
  /** Draws the same ring as round a selected body on the stage. */
  isRinged?: boolean;
};

/** A small picture; never the only sign, so hidden from screen readers. */
export function Glyph({ shape, isRinged = false }: GlyphProps) {
  return (
    <svg viewBox="-5 -5 32 32" className={styles.glyph} aria-hidden="true">
      {isRinged && <circle cx="11" cy="11" r="13" className={styles.ring} />}
      <g className={styles.shape} data-ringed={isRinged}>
        {SHAPES[shape]}
      </g>
    </svg>
  );
}
