import { useSyncExternalStore } from 'react';
import { useMedia } from '../../ui/useMedia';
import { countOf } from '../../world/bodyName';
import type { World } from '../../world/World';
import styles from './StageControls.module.css';

/** What a click into the empty sky would do now, if it would do something. */
export function OrderHint({ world }: { world: World }) {
  useSyncExternalStore(world.selection.subscribe, world.selection.ids);
  useSyncExternalStore(world.frames.subscribe, world.frames.version);
  const aim = useSyncExternalStore(world.aim.subscribe, world.aim.current);
  const hasFingers = useMedia('(pointer: coarse)');
  const count = world.selectedShips().length;
  if (count === 0) return null;
  const ships = <b>{countOf(count, 'ship')}</b>;
  return (
    <p className={styles.hint}>
      {aim ? (
        <>Arrows move the cross, Enter sends {ships} there</>
      ) : (
        <>
          {hasFingers ? 'Tap' : 'Click'} empty space to send {ships} there
        </>
      )}
    </p>
  );
}
