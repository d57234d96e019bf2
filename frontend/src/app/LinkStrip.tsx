import { useEffect, useState } from 'react';
import type { Link } from '../connection/link';
import { Button } from '../ui/Button';
import styles from './LinkStrip.module.css';

type LinkStripProps = { link: Link; frameAtMs: number | null; onTryNow: () => void };

/** Says what one still sees while the link is down, how old it is, and when it will be tried again. */
export function LinkStrip({ link, frameAtMs, onTryNow }: LinkStripProps) {
  const nowMs = useNow();
  if (link.state !== 'disconnected') return null;
  return (
    <section className={styles.strip} aria-label="Connection">
      <p>
        <span role="alert">
          <b>{link.hadLink ? 'Connection lost.' : 'No connection yet.'}</b>
        </span>{' '}
        {frameAtMs !== null && `You see the last frame, ${seconds(nowMs - frameAtMs)} s old. `}
        {link.retryAtMs === null ? 'Trying now.' : `Trying again in ${seconds(link.retryAtMs - nowMs)} s.`}
      </p>
      <Button disabled={link.retryAtMs === null} onClick={onTryNow}>
        Try now
      </Button>
    </section>
  );
}

function seconds(ms: number): number {
  return Math.max(0, Math.ceil(ms / 1000));
}

function useNow(): number {
  const [nowMs, setNowMs] = useState(Date.now);
  useEffect(() => {
    const timer = setInterval(() => setNowMs(Date.now()), 500);
    return () => clearInterval(timer);
  }, []);
  return nowMs;
}
