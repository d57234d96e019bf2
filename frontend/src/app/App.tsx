import { useCallback, useEffect, useMemo, useRef, useState, useSyncExternalStore } from 'react';
import { Canvas } from '../canvas/Canvas';
import { niceStep } from '../canvas/niceStep';
import type { Stage } from '../canvas/sketch';
import { ShortcutsDialog } from '../features/Shortcuts/ShortcutsDialog';
import { SimulationControl } from '../features/SimulationControl/SimulationControl';
import { EmptyStage } from '../features/StageControls/EmptyStage';
import { EventList } from '../features/StageControls/EventList';
import { OrderHint } from '../features/StageControls/OrderHint';
import { Problems } from '../features/StageControls/Problems';
import { ScaleBar } from '../features/StageControls/ScaleBar';
import { ViewSwitches } from '../features/StageControls/ViewSwitches';
import { ZoomControl } from '../features/StageControls/ZoomControl';
import type { BodyId, Vec2 } from '../protocol/frame';
import { canvasTokens } from '../ui/canvasTokens';
import { formatCount } from '../ui/formatNumber';
import { unitSymbol } from '../ui/unit';
import { PHONE, useMedia } from '../ui/useMedia';
import styles from './App.module.css';
import { Footer } from './Footer';
import { fitBodies, fitRoom } from './fit';
import { Header } from './Header';
import { actionsOf } from './keyboard';
import { LinkStrip } from './LinkStrip';
import type { RoomClient } from './RoomClient';
import { Sheet } from './Sheet';
import { SidePanel } from './SidePanel';
import { useShortcuts } from './useShortcuts';

const stillness = window.matchMedia('(prefers-reduced-motion: reduce)');

/** The whole page around one room. */
export function App({ client }: { client: RoomClient }) {
  const { world, camera, connection } = client;
  const stageElement = useRef<HTMLElement>(null);
  const findElement = useRef<HTMLInputElement>(null);
  const [hasHelp, setHasHelp] = useState(false);
  const [stage] = useState<Stage>(() => ({ world, camera, palette: canvasTokens, isStill: () => stillness.matches }));
  const link = useSyncExternalStore(connection.subscribe, connection.link);
  const room = useSyncExternalStore(world.room.subscribe, world.room.current);
  const news = useSyncExternalStore(world.notices.subscribe, world.notices.news);
  const aim = useSyncExternalStore(world.aim.subscribe, world.aim.current);
  const scale = useSyncExternalStore(camera.subscribe, camera.scale);
  useSyncExternalStore(world.frames.subscribe, world.frames.version);
  const isPhone = useMedia(PHONE);
  const scene = room?.scene;
  const isOffline = link.state !== 'live';
  const count = world.frames.newest.count;

  useEffect(() => {
    connection.open();
    return () => connection.close();
  }, [connection]);

  useEffect(() => {
    if (scene !== undefined) fitRoom(client, stageElement.current!);
  }, [client, scene]);

  const actions = useMemo(
    () =>
      actionsOf(client, {
        focusStage: () => stageElement.current?.focus(),
        focusFind: () => findElement.current?.focus(),
        openHelp: () => setHasHelp(true),
        fit: () => fitBodies(client),
      }),
    [client],
  );
  useShortcuts(actions, stageElement);

  const onBody = useCallback((id: BodyId, isAdding: boolean) => client.select(id, isAdding), [client]);
  const onEmptySpace = useCallback(
    (point: Vec2, isAdding: boolean) => {
      if (isAdding) return;
      if (world.selectedShips().length > 0) client.sendShips(point);
      else world.selection.clear();
    },
    [client, world],
  );

  return (
    <div className={styles.app}>
      <Header world={world} link={link} onHelp={() => setHasHelp(true)} />
      <LinkStrip link={link} frameAtMs={world.frames.arrivedAtMs()} onTryNow={connection.tryNow} />
      <main className={styles.main}>
        <Canvas
          ref={stageElement}
          stage={stage}
          label={`Stage with ${formatCount(count)} bodies`}
          isStale={link.state === 'disconnected'}
          onBody={onBody}
          onEmptySpace={onEmptySpace}
        />
        {world.frames.arrivedAtMs() !== null && count === 0 && (
          <EmptyStage isOffline={isOffline} onAdd={(type) => client.add(type)} />
        )}
        <SimulationControl
          isOffline={isOffline}
          isAiming={aim !== null}
          onAdd={(type) => client.add(type)}
          onSelectTool={actions['select-tool']}
        />
        <ViewSwitches world={world} />
        <ZoomControl onZoomOut={actions['zoom-out']} onZoomIn={actions['zoom-in']} onFit={actions.fit} />
        {room && <ScaleBar length={niceStep(scale)} pixelsPerUnit={scale} unit={unitSymbol(room.units.length)} />}
        {!isOffline && <OrderHint world={world} />}
        <EventList world={world} />
        <Problems world={world} />
      </main>
      {isPhone ? (
        <Sheet client={client} link={link} findRef={findElement} />
      ) : (
        <SidePanel client={client} link={link} findRef={findElement} />
      )}
      {!isPhone && <Footer world={world} link={link} />}
      <div role="status" className={styles.news}>
        {news}
      </div>
      <ShortcutsDialog isOpen={hasHelp} onClose={() => setHasHelp(false)} />
    </div>
  );
}
