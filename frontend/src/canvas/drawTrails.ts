import { PLANET, SHIP } from '../world/FrameColumns';
import type { Trail } from '../world/Trails';
import type { World } from '../world/World';
import type { Camera } from './Camera';
import type { Palette } from './Palette';

type Context = CanvasRenderingContext2D;

const STEPS = 10; // of fading; each is one stroke
const STROKE_ALPHA = 0.08; // ten of them make 0.57

/** Where the selected bodies have been, fading to nothing, in the colour of their rim. */
export function drawTrails(g: Context, world: World, camera: Camera, palette: Palette): void {
  const { newest } = world.frames;
  g.lineWidth = 2;
  g.lineJoin = 'round';
  for (const id of world.selection.ids()) {
    const slot = newest.slot.get(id);
    const trail = world.trails.of(id);
    if (slot === undefined || !trail) continue;
    g.strokeStyle = rimOf(newest.kind[slot]!, palette);
    drawTrail(g, trail, camera, world.frames.at.x[slot]!, world.frames.at.y[slot]!);
  }
  g.globalAlpha = 1;
}

/**
 * Each stroke begins at the body and reaches further back than the one before: their sum fades. Strokes laid end to end
 * would show a bead at every seam.
 */
function drawTrail(g: Context, trail: Trail, camera: Camera, bodyX: number, bodyY: number): void {
  g.globalAlpha = STROKE_ALPHA;
  for (let step = 1; step <= STEPS; step++) {
    const end = Math.round((trail.count * step) / STEPS);
    g.beginPath();
    g.moveTo(camera.toScreenX(bodyX), camera.toScreenY(bodyY));
    // The newest point is one frame ahead of the picture, so the line goes on with the point before it.
    for (let age = 1; age < end; age++) addPoint(g, trail, camera, age);
    g.stroke();
  }
}

function addPoint(g: Context, trail: Trail, camera: Camera, age: number): void {
  const point = trail.index(age);
  const x = camera.toScreenX(trail.x[point]!);
  const y = camera.toScreenY(trail.y[point]!);
  // The canvas ignores NaN, so behind a jump the pen has to be lifted.
  if (Number.isNaN(trail.x[trail.index(age - 1)]!)) g.moveTo(x, y);
  else g.lineTo(x, y);
}

function rimOf(kind: number, palette: Palette): string {
  if (kind === SHIP) return palette.ship;
  return kind === PLANET ? palette.planetRim : palette.rockRim;
}
