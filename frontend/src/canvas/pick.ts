import type { BodyId } from '../protocol/frame';
import type { FrameBuffer } from '../world/FrameBuffer';
import type { Camera } from './Camera';
import { drawnRadius } from './drawnRadius';

/**
 * The body at a point of the screen, or null. `slackPx` is how far beside its edge a body may be hit. Among several the
 * nearest centre in its own radii wins, so that a small body in front of a large one can be picked.
 */
export function pick(frames: FrameBuffer, camera: Camera, x: number, y: number, slackPx: number): BodyId | null {
  const { newest, at } = frames;
  let best: BodyId | null = null;
  let bestShare = 1;
  for (let i = 0; i < newest.count; i++) {
    const reachPx = drawnRadius(newest, i, camera.pixelsPerUnit) + slackPx;
    const dx = camera.toScreenX(at.x[i]!) - x;
    const dy = camera.toScreenY(at.y[i]!) - y;
    const share = Math.hypot(dx, dy) / reachPx;
    if (share <= bestShare) {
      best = newest.idAt(i);
      bestShare = share;
    }
  }
  return best;
}
