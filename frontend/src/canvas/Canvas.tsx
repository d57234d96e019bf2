import { type Ref, useEffect, useImperativeHandle, useState, useSyncExternalStore } from 'react';
import type { BodyId, Vec2 } from '../protocol/frame';
import styles from './Canvas.module.css';
import { listenToGestures } from './gestures';
import { pick } from './pick';
import { type Stage, sketchOf } from './sketch';
import { useP5 } from './useP5';

type CanvasProps = {
  stage: Stage;
  label: string;
  /** The link is down: what is shown is the past. */
  isStale: boolean;
  onBody: (id: BodyId, isAdding: boolean) => void;
  onEmptySpace: (point: Vec2, isAdding: boolean) => void;
  ref?: Ref<HTMLElement | null>;
};

/**
 * The stage. p5 draws it without React; React only mounts it, once per page. The canvas says nothing to screen readers,
 * the list of bodies is its twin.
 */
export function Canvas({ stage, label, isStale, onBody, onEmptySpace, ref }: CanvasProps) {
  const [sketch] = useState(() => sketchOf(stage));
  const host = useP5(sketch);
  const { world, camera } = stage;
  const hovered = useSyncExternalStore(world.hovered.subscribe, world.hovered.current);
  useImperativeHandle(ref, () => host.current!, [host]);

  useEffect(() => {
    const { frames, hovered, view } = world;
    return listenToGestures(host.current!, camera, {
      onTap: (x, y, slackPx, isAdding) => {
        const id = pick(frames, camera, x, y, slackPx);
        if (id !== null) onBody(id, isAdding);
        else onEmptySpace({ x: camera.toWorldX(x), y: camera.toWorldY(y) }, isAdding);
      },
      onHover: (x, y) => hovered.set(pick(frames, camera, x, y, 3)),
      onLeave: () => hovered.set(null),
      onPan: () => view.set({ ...view.current(), follow: false }),
    });
  }, [world, camera, host, onBody, onEmptySpace]);

  return (
    <div
      ref={host}
      className={styles.stage}
      role="application"
      aria-label={label}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: the stage is worked with the keyboard, as an application.
      tabIndex={0}
      data-stale={isStale}
      data-over-body={hovered !== null}
    />
  );
}
