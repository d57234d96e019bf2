import type { Ref } from 'react';
import type { Link } from '../connection/link';
import { InfoSection } from '../features/InfoSection/InfoSection';
import { Inspector } from '../features/InfoSection/Inspector';
import type { RoomClient } from './RoomClient';
import styles from './SidePanel.module.css';

type SidePanelProps = { client: RoomClient; link: Link; findRef: Ref<HTMLInputElement> };

/** What is selected, over the list of all bodies. */
export function SidePanel({ client, link, findRef }: SidePanelProps) {
  const isOffline = link.state !== 'live';
  return (
    <aside className={styles.side} aria-label="Bodies">
      <Inspector world={client.world} isOffline={isOffline} onDelete={() => client.deleteSelected()} />
      <InfoSection
        world={client.world}
        isOffline={isOffline}
        onSelect={(id, isAdding) => client.select(id, isAdding)}
        onDelete={(id) => client.delete(id)}
        findRef={findRef}
      />
    </aside>
  );
}
