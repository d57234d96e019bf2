import type { Vec2 } from '../protocol/frame';
import type { ShipReading, Threat } from '../protocol/messages';
import { bodyName } from '../world/bodyName';
import type { World } from '../world/World';
import type { Camera } from './Camera';
import { drawArrow } from './drawArrow';
import { drawnRadius } from './drawnRadius';
import { drawText } from './drawText';
import type { Palette } from './Palette';

type Context = CanvasRenderingContext2D;

/** Of full thrust. */
const LONGEST_PX = 56;
const SHORTEST_PX = 8;
/** Without a threat the course is shown so far ahead, time. */
const AHEAD = 1;
const RING_GAP_PX = 7;
const TICK_PX = 5;
const LABEL_GAP_PX = 10;

/** What the ship that was selected last is about to do: its thrust, its course, its nearest threat and where the two pass. */
export function drawPlan(g: Context, world: World, camera: Camera, palette: Palette): void {
  const reading = world.mainShip();
  const slot = reading ? world.frames.newest.slot.get(reading.id) : undefined;
  if (!reading || slot === undefined) return;
  const { at } = world.frames;
  const from = { x: camera.toScreenX(at.x[slot]!), y: camera.toScreenY(at.y[slot]!) };
  drawCourse(g, world, camera, palette, reading, slot, from);
  if (reading.threat) drawThreat(g, world, camera, palette, reading.threat);
  drawThrust(g, world, camera, palette, reading, slot, from);
}

/** From the ship to where it will be at the closest approach, with its circle there. */
function drawCourse(
  g: Context,
  world: World,
  camera: Camera,
  palette: Palette,
  { course, threat }: ShipReading,
  slot: number,
  from: Vec2,
): void {
  const { at, newest } = world.frames;
  const end = threat?.passing.ship ?? { x: at.x[slot]! + AHEAD * course.x, y: at.y[slot]! + AHEAD * course.y };
  const radius = drawnRadius(newest, slot, camera.pixelsPerUnit);
  if (Math.hypot(camera.toScreenX(end.x) - from.x, camera.toScreenY(end.y) - from.y) < radius) return; // it stays
  g.strokeStyle = palette.ship;
  g.lineWidth = 1.2;
  g.setLineDash([7, 4]);
  drawLine(g, from.x, from.y, camera.toScreenX(end.x), camera.toScreenY(end.y));
  g.setLineDash([]);
  drawRing(g, camera.toScreenX(end.x), camera.toScreenY(end.y), radius);
}

/** A ring with four ticks round the body, its way to the closest approach, and the line between the two there. */
function drawThreat(g: Context, world: World, camera: Camera, palette: Palette, threat: Threat): void {
  const { at, newest } = world.frames;
  const slot = newest.slot.get(threat.id);
  if (slot === undefined) return;
  const x = camera.toScreenX(at.x[slot]!);
  const y = camera.toScreenY(at.y[slot]!);
  const radius = drawnRadius(newest, slot, camera.pixelsPerUnit);
  const ring = radius + RING_GAP_PX;
  g.strokeStyle = palette.threat;
  g.lineWidth = 2;
  drawRing(g, x, y, ring);
  for (const [ux, uy] of DIAGONALS) {
    drawLine(g, x + ux * ring, y + uy * ring, x + ux * (ring + TICK_PX), y + uy * (ring + TICK_PX));
  }
  const { body } = threat.passing;
  const [bodyX, bodyY] = [camera.toScreenX(body.x), camera.toScreenY(body.y)];
  drawGap(g, world, camera, threat, newest.radius[slot]!);
  g.lineWidth = 1.2;
  drawRing(g, bodyX, bodyY, radius);
  g.setLineDash([2, 4]);
  drawLine(g, x, y, bodyX, bodyY);
  g.setLineDash([]);
  const name = bodyName(newest.kindAt(slot), threat.id);
  // Below, because the name of the ship stands above it.
  drawText(g, palette, palette.threat, name, x, y + ring + TICK_PX + LABEL_GAP_PX);
}

/** From rim to rim; nothing where they would touch. */
function drawGap(g: Context, world: World, camera: Camera, { passing }: Threat, radius: number): void {
  const { ship, body, gap } = passing;
  const main = world.frames.newest.slot.get(world.selection.main()!);
  if (gap <= 0 || main === undefined) return;
  const [dx, dy] = [body.x - ship.x, body.y - ship.y];
  const distance = Math.hypot(dx, dy);
  const from = world.frames.newest.radius[main]! / distance;
  const to = 1 - radius / distance;
  drawLine(
    g,
    camera.toScreenX(ship.x + from * dx),
    camera.toScreenY(ship.y + from * dy),
    camera.toScreenX(ship.x + to * dx),
    camera.toScreenY(ship.y + to * dy),
  );
}

/** In the colour of the flame, as long as the engine is strained. */
function drawThrust(
  g: Context,
  world: World,
  camera: Camera,
  palette: Palette,
  { acceleration }: ShipReading,
  slot: number,
  from: Vec2,
): void {
  const { newest } = world.frames;
  const size = Math.hypot(acceleration.x, acceleration.y);
  const length = LONGEST_PX * newest.thrust[slot]!;
  if (size === 0 || length < SHORTEST_PX) return;
  g.strokeStyle = palette.flame;
  g.fillStyle = palette.flame;
  g.lineWidth = 2;
  const start = drawnRadius(newest, slot, camera.pixelsPerUnit) + 3;
  drawArrow(g, from.x, from.y, acceleration.x / size, -acceleration.y / size, start, length);
}

function drawLine(g: Context, fromX: number, fromY: number, toX: number, toY: number): void {
  g.beginPath();
  g.moveTo(fromX, fromY);
  g.lineTo(toX, toY);
  g.stroke();
}

function drawRing(g: Context, x: number, y: number, radius: number): void {
  g.beginPath();
  g.arc(x, y, radius, 0, 2 * Math.PI);
  g.stroke();
}

const DIAGONALS = [
  [Math.SQRT1_2, Math.SQRT1_2],
  [Math.SQRT1_2, -Math.SQRT1_2],
  [-Math.SQRT1_2, Math.SQRT1_2],
  [-Math.SQRT1_2, -Math.SQRT1_2],
] as const;
