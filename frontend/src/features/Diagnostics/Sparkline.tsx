import styles from './Sparkline.module.css';

const WIDTH = 64;
const HEIGHT = 18;

type SparklineProps = { values: readonly number[]; trend?: 'neutral' | 'ok' };

/** The recent course of a figure, without a scale; the figure stands beside it. */
export function Sparkline({ values, trend = 'neutral' }: SparklineProps) {
  if (values.length < 2) return null;
  return (
    <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} className={styles.spark} data-trend={trend} aria-hidden="true">
      <polyline points={pointsOf(values)} />
    </svg>
  );
}

function pointsOf(values: readonly number[]): string {
  const least = Math.min(...values);
  const range = Math.max(...values) - least;
  const dx = WIDTH / (values.length - 1);
  // A constant is a line in the middle, not on the floor.
  const y = (value: number) => (range === 0 ? HEIGHT / 2 : HEIGHT - 2 - ((HEIGHT - 4) * (value - least)) / range);
  return values.map((value, i) => `${(i * dx).toFixed(1)},${y(value).toFixed(1)}`).join(' ');
}
