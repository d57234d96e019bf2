import type { FrameBuffer } from '../world/FrameBuffer';
import { ASTEROID, type FrameColumns, PLANET, SHIP } from '../world/FrameColumns';
import { BodyPath } from './BodyPath';
import type { Camera } from './Camera';
import { drawnRadius, FLAT_BELOW_PX, SQUARE_BELOW_PX } from './drawnRadius';
import type { Palette } from './Palette';
import { addDart, addDisc, addFlame, addNight, addOutline, addSquare } from './shapes';

/** From this share of its force on, the engine shows a flame. */
const FLAME_FROM = 0.3;
const ROCK_RIM_PX = 1.2;
/** Without a GPU the rims of 2000 rocks cost more than all else: 16 pictures a second with them, 50 without. */
const CROWD = 600;
const CROWDED_RIM_FROM_PX = 9;
/** Dust: it can be hit within its pick radius, which is larger. */
const LEAST_SQUARE_PX = 3;
const PLANET_RIM = 0.07; // of the radius

export type Look = { readonly palette: Palette; readonly hasFlames: boolean };

/**
 * Draws every body in view. Runs 60 times a second: allocates nothing, never calls React, and uses the canvas directly,
 * because p5's own shapes cost 105 to 123 ms a frame at 10 000 bodies.
 */
export function drawBodies(g: CanvasRenderingContext2D, frames: FrameBuffer, camera: Camera, look: Look): void {
  drawRocks(g, frames, camera, look.palette);
  drawPlanets(g, frames, camera, look.palette);
  if (look.hasFlames) drawFlames(g, frames, camera, look.palette);
  drawShips(g, frames, camera, look.palette);
}

/** A canvas has one open path at a time, so small rocks and rimmed ones are two passes. */
function drawRocks(g: CanvasRenderingContext2D, frames: FrameBuffer, camera: Camera, palette: Palette): void {
  const scale = camera.pixelsPerUnit;
  const { newest, at, outlines } = frames;
  const flat = new BodyPath(g, palette.rock);
  for (let i = 0; i < newest.count; i++) {
    if (newest.kind[i] !== ASTEROID || isRimmed(newest, i, scale) || !isInView(frames, camera, i)) continue;
    const x = camera.toScreenX(at.x[i]!);
    const y = camera.toScreenY(at.y[i]!);
    const trueRadius = newest.radius[i]! * scale;
    const outline = outlines.of(newest.idAt(i));
    if (!outline || trueRadius < SQUARE_BELOW_PX)
      addSquare(flat.next(), x, y, Math.max(LEAST_SQUARE_PX, 2 * trueRadius));
    else addOutline(flat.next(), outline, x, y, scale, at.angle[i]!);
  }
  flat.flush();
  const rimmed = new BodyPath(g, palette.rock, palette.rockRim, ROCK_RIM_PX);
  for (let i = 0; i < newest.count; i++) {
    if (newest.kind[i] !== ASTEROID || !isRimmed(newest, i, scale) || !isInView(frames, camera, i)) continue;
    const outline = outlines.of(newest.idAt(i))!;
    addOutline(rimmed.next(), outline, camera.toScreenX(at.x[i]!), camera.toScreenY(at.y[i]!), scale, at.angle[i]!);
  }
  rimmed.flush();
}

function isRimmed({ count, radius }: FrameColumns, slot: number, pixelsPerUnit: number): boolean {
  return radius[slot]! * pixelsPerUnit >= (count > CROWD ? CROWDED_RIM_FROM_PX : FLAT_BELOW_PX);
}

function drawPlanets(g: CanvasRenderingContext2D, frames: FrameBuffer, camera: Camera, palette: Palette): void {
  const { newest, at } = frames;
  for (let i = 0; i < newest.count; i++) {
    if (newest.kind[i] !== PLANET || !isInView(frames, camera, i)) continue;
    const radius = drawnRadius(newest, i, camera.pixelsPerUnit);
    const x = camera.toScreenX(at.x[i]!);
    const y = camera.toScreenY(at.y[i]!);
    g.fillStyle = palette.planet;
    g.beginPath();
    addDisc(g, x, y, radius);
    g.fill();
    if (radius < FLAT_BELOW_PX) continue;
    g.fillStyle = palette.planetNight;
    g.beginPath();
    addNight(g, x, y, radius);
    g.fill();
    g.strokeStyle = palette.planetRim;
    g.lineWidth = Math.max(ROCK_RIM_PX, PLANET_RIM * radius);
    g.beginPath();
    addDisc(g, x, y, radius);
    g.stroke();
  }
}

function drawFlames(g: CanvasRenderingContext2D, frames: FrameBuffer, camera: Camera, palette: Palette): void {
  const { newest, at } = frames;
  const path = new BodyPath(g, palette.flame);
  for (let i = 0; i < newest.count; i++) {
    if (newest.kind[i] !== SHIP || newest.thrust[i]! <= FLAME_FROM || !isInView(frames, camera, i)) continue;
    const radius = drawnRadius(newest, i, camera.pixelsPerUnit);
    addFlame(path.next(), camera.toScreenX(at.x[i]!), camera.toScreenY(at.y[i]!), radius, at.angle[i]!);
  }
  path.flush();
}

function drawShips(g: CanvasRenderingContext2D, frames: FrameBuffer, camera: Camera, palette: Palette): void {
  const { newest, at } = frames;
  const path = new BodyPath(g, palette.ship);
  for (let i = 0; i < newest.count; i++) {
    if (newest.kind[i] !== SHIP || !isInView(frames, camera, i)) continue;
    const radius = drawnRadius(newest, i, camera.pixelsPerUnit);
    addDart(path.next(), camera.toScreenX(at.x[i]!), camera.toScreenY(at.y[i]!), radius, at.angle[i]!);
  }
  path.flush();
}

/** Twice the radius leaves space for flame and rim. */
function isInView({ newest, at }: FrameBuffer, camera: Camera, i: number): boolean {
  const reach = 2 * drawnRadius(newest, i, camera.pixelsPerUnit);
  const x = camera.toScreenX(at.x[i]!);
  const y = camera.toScreenY(at.y[i]!);
  return x > -reach && x < camera.width + reach && y > -reach && y < camera.height + reach;
}
