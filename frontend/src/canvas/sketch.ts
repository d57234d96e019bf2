import type { World } from '../world/World';
import type { Camera } from './Camera';
import { drawArrows } from './drawArrows';
import { drawBodies } from './drawBodies';
import { drawMarks } from './drawMarks';
import { drawAim, drawOrders } from './drawOrders';
import { drawPlan } from './drawPlan';
import { drawEdge, drawSky } from './drawSky';
import { drawTrails } from './drawTrails';
import type { Palette } from './Palette';
import type { Sketch } from './useP5';

/** What the stage shows, and how. */
export type Stage = {
  readonly world: World;
  readonly camera: Camera;
  readonly palette: () => Palette;
  /** Asked at every frame, because the user may change it while the page is open. */
  readonly isStill: () => boolean;
};

const FPS_WINDOW_MS = 1000;

/** The sketch of a stage: the order of drawing, from the sky to the keyboard's cross. */
export function sketchOf({ world, camera, palette: readPalette, isStill }: Stage): Sketch {
  return (p, host) => {
    const palette = readPalette();
    let drawn = 0;
    let sinceMs = performance.now();

    function countFrame(nowMs: number): void {
      drawn++;
      if (nowMs - sinceMs < FPS_WINDOW_MS) return;
      world.drawnHz.set(Math.round((drawn * 1000) / (nowMs - sinceMs)));
      drawn = 0;
      sinceMs = nowMs;
    }

    return {
      setup: () => {
        p.createCanvas(host.clientWidth, host.clientHeight).elt.setAttribute('aria-hidden', 'true');
      },
      draw: () => {
        const g = p.drawingContext;
        const nowMs = performance.now();
        const view = world.view.current();
        camera.resize(p.width, p.height);
        world.frames.sample(nowMs);
        if (view.follow) follow(world, camera);
        drawSky(g, camera, palette, view.grid);
        drawEdge(g, camera, palette, world.room.current()?.boundary);
        if (view.trails && !isStill()) drawTrails(g, world, camera, palette);
        drawOrders(g, world, camera, palette, nowMs);
        drawBodies(g, world.frames, camera, { palette, hasFlames: !isStill() });
        drawMarks(g, world, camera, palette, nowMs);
        if (view.plan) drawPlan(g, world, camera, palette);
        drawArrows(g, world, camera, palette);
        drawAim(g, world, camera, palette);
        countFrame(nowMs);
      },
    };
  };
}

/** Keeps the middle of the selection in the middle of the stage. */
function follow({ frames, selection }: World, camera: Camera): void {
  let x = 0;
  let y = 0;
  let count = 0;
  for (const id of selection.ids()) {
    const slot = frames.newest.slot.get(id);
    if (slot === undefined) continue;
    x += frames.at.x[slot]!;
    y += frames.at.y[slot]!;
    count++;
  }
  if (count > 0) camera.lookAt(x / count, y / count);
}
