import type { Link } from '../connection/link';
import { Figures } from '../features/Diagnostics/Figures';
import type { World } from '../world/World';
import styles from './App.module.css';

/** The live figures, along the lower edge. */
export function Footer({ world, link }: { world: World; link: Link }) {
  return (
    <footer className={styles.footer}>
      <Figures world={world} link={link.state === 'live' ? link : null} />
    </footer>
  );
}
