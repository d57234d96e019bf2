import { useSyncExternalStore } from 'react';
import { formatNumber } from '../../ui/formatNumber';
import { unitSymbol } from '../../ui/unit';
import { eventText } from '../../world/eventText';
import type { World } from '../../world/World';
import styles from './StageControls.module.css';

/**
 * What has just happened to ships. Silent for screen readers, which would hear of every ship of a crowd; what happens to one's own is
 * announced.
 */
export function EventList({ world }: { world: World }) {
  const events = useSyncExternalStore(world.events.subscribe, world.events.recent);
  const room = useSyncExternalStore(world.room.subscribe, world.room.current);
  const unit = room ? `${unitSymbol(room.units.length)}/${unitSymbol(room.units.time)}` : '';
  return (
    <div role="log" aria-label="Events" aria-live="off" className={styles.events}>
      {events.map((event) => (
        <p key={event.number} className={styles.event} data-type={event.type}>
          {eventText(event)}
          {event.speed !== null && (
            <span className={styles.eventSpeed}>
              {formatNumber(event.speed)} {unit}
            </span>
          )}
        </p>
      ))}
    </div>
  );
}
