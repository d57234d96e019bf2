import type { BodyId } from '../protocol/frame';
import type { FrameColumns } from '../world/FrameColumns';
import type { World } from '../world/World';
import type { Camera } from './Camera';
import { drawArrow } from './drawArrow';
import { drawnRadius } from './drawnRadius';
import type { Palette } from './Palette';

type Context = CanvasRenderingContext2D;
type Vector = (frame: FrameColumns, i: number) => { x: number; y: number };

/** An arrow of this length is the root mean square of all bodies: arrows of one picture can be compared. */
const TYPICAL_PX = 40;
const SHORTEST_PX = 8;
const LONGEST_PX = 110;

const velocity: Vector = (frame, i) => ({ x: frame.vx[i]!, y: frame.vy[i]! });
const force: Vector = (frame, i) => ({ x: frame.ax[i]! * frame.mass[i]!, y: frame.ay[i]! * frame.mass[i]! });

/** The velocity (solid) and the force (dashed) of the bodies one is looking at. */
export function drawArrows(g: Context, world: World, camera: Camera, palette: Palette): void {
  const { velocity: hasVelocity, force: hasForce } = world.view.current();
  if (!hasVelocity && !hasForce) return;
  g.strokeStyle = palette.text;
  g.fillStyle = palette.text;
  g.lineWidth = 1.5;
  const bodies = lookedAt(world);
  if (bodies.length === 0) return;
  if (hasVelocity) drawAll(g, world, camera, bodies, velocity);
  if (hasForce) {
    g.setLineDash([4, 3]);
    drawAll(g, world, camera, bodies, force);
    g.setLineDash([]);
  }
}

function lookedAt(world: World): BodyId[] {
  const hovered = world.hovered.current();
  const selected = world.selection.ids();
  return hovered === null || world.selection.has(hovered) ? [...selected] : [...selected, hovered];
}

function drawAll(g: Context, world: World, camera: Camera, bodies: readonly BodyId[], of: Vector): void {
  const { newest, at } = world.frames;
  const typical = rootMeanSquare(newest, of);
  if (typical === 0) return;
  for (const id of bodies) {
    const i = newest.slot.get(id);
    if (i === undefined) continue;
    const { x, y } = of(newest, i);
    const size = Math.hypot(x, y);
    // The root, because forces in one scene span many powers of ten.
    const length = Math.min(LONGEST_PX, TYPICAL_PX * Math.sqrt(size / typical));
    if (length < SHORTEST_PX) continue;
    const start = drawnRadius(newest, i, camera.pixelsPerUnit) + 3;
    drawArrow(g, camera.toScreenX(at.x[i]!), camera.toScreenY(at.y[i]!), x / size, -y / size, start, length);
  }
}

function rootMeanSquare(frame: FrameColumns, of: Vector): number {
  let sum = 0;
  for (let i = 0; i < frame.count; i++) {
    const { x, y } = of(frame, i);
    sum += x * x + y * y;
  }
  return Math.sqrt(sum / Math.max(1, frame.count));
}
