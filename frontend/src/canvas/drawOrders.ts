import type { BodyId } from '../protocol/frame';
import type { World } from '../world/World';
import type { Camera } from './Camera';
import type { Palette } from './Palette';
import { addDiamond } from './shapes';

type Context = CanvasRenderingContext2D;

const MARKER_PX = 10;
/** In a formation every ship has its own place, and the markers must not overlap. */
const FORMATION_MARKER_PX = 6;
const CORE = 0.4; // of the marker
const CROSS_PX = 14;

/** Where the user's ships are sent, with a dotted line from each. Hollow until the room has confirmed the order. */
export function drawOrders(g: Context, world: World, camera: Camera, palette: Palette, nowMs: number): void {
  g.strokeStyle = palette.order;
  g.fillStyle = palette.order;
  const pending = world.orders.pending(nowMs);
  const ships = world.selectedShips();
  const size = ships.length > 1 ? FORMATION_MARKER_PX : MARKER_PX;
  for (const id of ships) if (!pending?.ships.includes(id)) drawShipOrder(g, world, camera, id, size);
  if (!pending) return;
  const x = camera.toScreenX(pending.x);
  const y = camera.toScreenY(pending.y);
  for (const id of pending.ships) drawLine(g, world, camera, id, x, y);
  drawMarker(g, x, y, MARKER_PX, pending.isConfirmed);
}

function drawShipOrder(g: Context, world: World, camera: Camera, id: BodyId, size: number): void {
  const { newest } = world.frames;
  const slot = newest.slot.get(id);
  if (slot === undefined || Number.isNaN(newest.targetX[slot]!)) return;
  const x = camera.toScreenX(newest.targetX[slot]!);
  const y = camera.toScreenY(newest.targetY[slot]!);
  drawLine(g, world, camera, id, x, y);
  drawMarker(g, x, y, size, true);
}

function drawLine(g: Context, world: World, camera: Camera, id: BodyId, x: number, y: number): void {
  const { newest, at } = world.frames;
  const slot = newest.slot.get(id);
  if (slot === undefined) return;
  g.lineWidth = 1.2;
  g.setLineDash([2, 6]);
  g.beginPath();
  g.moveTo(camera.toScreenX(at.x[slot]!), camera.toScreenY(at.y[slot]!));
  g.lineTo(x, y);
  g.stroke();
  g.setLineDash([]);
}

function drawMarker(g: Context, x: number, y: number, size: number, isConfirmed: boolean): void {
  g.lineWidth = 2;
  g.beginPath();
  addDiamond(g, x, y, size);
  g.stroke();
  if (!isConfirmed) return;
  g.beginPath();
  addDiamond(g, x, y, CORE * size);
  g.fill();
}

/** The keyboard's cross: where Enter sends the ships. */
export function drawAim(g: Context, world: World, camera: Camera, palette: Palette): void {
  const aim = world.aim.current();
  if (!aim) return;
  const x = camera.toScreenX(aim.x);
  const y = camera.toScreenY(aim.y);
  g.strokeStyle = palette.order;
  g.lineWidth = 2;
  g.beginPath();
  g.arc(x, y, CROSS_PX / 2, 0, 2 * Math.PI);
  for (const [dx, dy] of ARMS) {
    g.moveTo(x + (dx * CROSS_PX) / 3, y + (dy * CROSS_PX) / 3);
    g.lineTo(x + dx * CROSS_PX, y + dy * CROSS_PX);
  }
  g.stroke();
}

const ARMS = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
] as const;
