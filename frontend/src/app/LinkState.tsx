import { type Link, SLOW_DELAY_MS } from '../connection/link';
import { formatCount } from '../ui/formatNumber';
import styles from './Header.module.css';

/** A dot and a word for the link: its shape changes with its colour. */
export function LinkState({ link }: { link: Link }) {
  const { mood, text } = describe(link);
  return (
    <span className={styles.link} data-mood={mood}>
      <span className={styles.dot} aria-hidden="true" />
      {text}
    </span>
  );
}

function describe(link: Link): { mood: 'ok' | 'warn' | 'bad' | 'wait'; text: string } {
  if (link.state === 'connecting') return { mood: 'wait', text: 'Connecting' };
  if (link.state === 'disconnected') return { mood: 'bad', text: 'Disconnected' };
  if (link.delayMs > SLOW_DELAY_MS) return { mood: 'warn', text: `Delay ${formatCount(link.delayMs)} ms` };
  return { mood: 'ok', text: `Live, ${Math.round(link.hz)} Hz` };
}
