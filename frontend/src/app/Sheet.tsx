import { type KeyboardEvent, type Ref, useState, useSyncExternalStore } from 'react';
import type { Link } from '../connection/link';
import { FigureTable } from '../features/Diagnostics/FigureTable';
import { InfoSection } from '../features/InfoSection/InfoSection';
import { Inspector } from '../features/InfoSection/Inspector';
import { formatCount } from '../ui/formatNumber';
import type { RoomClient } from './RoomClient';
import styles from './SidePanel.module.css';

type SheetProps = { client: RoomClient; link: Link; findRef: Ref<HTMLInputElement> };

const TABS = ['selected', 'bodies', 'diagnostics'] as const;
type Tab = (typeof TABS)[number];

/** On a phone: the side panel and the figures as three tabs of one sheet, which folds away for a larger stage. */
export function Sheet({ client, link, findRef }: SheetProps) {
  const { world } = client;
  const [tab, setTab] = useState<Tab>('selected');
  const [isOpen, setIsOpen] = useState(true);
  useSyncExternalStore(world.frames.subscribe, world.frames.version);
  const selected = useSyncExternalStore(world.selection.subscribe, world.selection.ids);
  const isOffline = link.state !== 'live';

  const labels: Record<Tab, string> = {
    selected: selected.length > 0 ? `Selected ${formatCount(selected.length)}` : 'Selected',
    bodies: `Bodies ${formatCount(world.frames.newest.count)}`,
    diagnostics: 'Diagnostics',
  };

  function show(next: Tab): void {
    setTab(next);
    setIsOpen(true);
  }

  function onKeyDown(event: KeyboardEvent<HTMLElement>): void {
    const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    if (step === 0) return;
    const next = TABS[(TABS.indexOf(tab) + step + TABS.length) % TABS.length]!;
    show(next);
    document.getElementById(`tab-${next}`)?.focus();
  }

  return (
    <aside className={styles.sheet} aria-label="Bodies">
      <button
        type="button"
        className={styles.grip}
        aria-expanded={isOpen}
        aria-controls="sheet-panel"
        aria-label={isOpen ? 'Fold the sheet' : 'Unfold the sheet'}
        onClick={() => setIsOpen(!isOpen)}
      />
      <div role="tablist" aria-label="Sheet" className={styles.tabs} onKeyDown={onKeyDown}>
        {TABS.map((name) => (
          <button
            key={name}
            id={`tab-${name}`}
            type="button"
            role="tab"
            aria-selected={tab === name}
            aria-controls="sheet-panel"
            tabIndex={tab === name ? 0 : -1}
            className={styles.tab}
            onClick={() => show(name)}
          >
            {labels[name]}
          </button>
        ))}
      </div>
      <div
        id="sheet-panel"
        role="tabpanel"
        aria-labelledby={`tab-${tab}`}
        // Nothing in the figures takes the focus, and keys must scroll them.
        tabIndex={tab === 'diagnostics' ? 0 : undefined}
        className={styles.panel}
        hidden={!isOpen}
      >
        {tab === 'selected' && (
          <Inspector world={world} isOffline={isOffline} onDelete={() => client.deleteSelected()} />
        )}
        {tab === 'bodies' && (
          <InfoSection
            world={world}
            isOffline={isOffline}
            onSelect={(id, isAdding) => client.select(id, isAdding)}
            onDelete={(id) => client.delete(id)}
            findRef={findRef}
          />
        )}
        {tab === 'diagnostics' && <FigureTable world={world} link={link.state === 'live' ? link : null} />}
      </div>
    </aside>
  );
}
