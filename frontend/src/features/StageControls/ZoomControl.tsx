import { Button } from '../../ui/Button';
import { Segments } from '../../ui/Segments';
import styles from './StageControls.module.css';

type ZoomControlProps = { onZoomOut: () => void; onZoomIn: () => void; onFit: () => void };

export function ZoomControl({ onZoomOut, onZoomIn, onFit }: ZoomControlProps) {
  return (
    <div className={styles.zoom}>
      <Segments label="Zoom">
        <Button className={styles.step} aria-label="Zoom out" title="Zoom out (−)" onClick={onZoomOut}>
          −
        </Button>
        <Button className={styles.step} aria-label="Zoom in" title="Zoom in (+)" onClick={onZoomIn}>
          +
        </Button>
        <Button title="Show all bodies (F)" onClick={onFit}>
          Fit
        </Button>
      </Segments>
    </div>
  );
}
