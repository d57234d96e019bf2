import type { BodyId } from '../protocol/frame';
import { bodyName } from '../world/bodyName';
import type { World } from '../world/World';
import type { Camera } from './Camera';
import { drawnRadius } from './drawnRadius';
import { drawText } from './drawText';
import type { Palette } from './Palette';

type Context = CanvasRenderingContext2D;

const RING_GAP_PX = 5;
const LEAST_RING_PX = 11;
const FRESH_MS = 1600;
const LABEL_GAP_PX = 8;

/** Everything that is said about single bodies: rings, labels, and what has just been added. */
export function drawMarks(g: Context, world: World, camera: Camera, palette: Palette, nowMs: number): void {
  drawTaken(g, world, camera, palette);
  drawFresh(g, world, camera, palette, nowMs);
  for (const id of world.selection.ids()) drawSelected(g, world, camera, palette, id);
  const hovered = world.hovered.current();
  if (hovered !== null && !world.selection.has(hovered)) {
    drawCircle(g, world, camera, hovered, palette.text, 1);
    drawLabel(g, world, camera, hovered, palette, palette.text);
  }
  const main = world.selection.main();
  if (main !== undefined) drawLabel(g, world, camera, main, palette, palette.select);
}

/** Somebody else's selection: a faint ring, no more. */
function drawTaken(g: Context, world: World, camera: Camera, palette: Palette): void {
  const { newest } = world.frames;
  for (let i = 0; i < newest.count; i++) {
    if (newest.taken[i] === 0 || world.selection.has(newest.idAt(i))) continue;
    drawCircle(g, world, camera, newest.idAt(i), palette.faint, 1);
  }
}

function drawFresh(g: Context, world: World, camera: Camera, palette: Palette, nowMs: number): void {
  for (const [id, bornMs] of world.fresh) {
    const age = (nowMs - bornMs) / FRESH_MS;
    if (age >= 1) world.fresh.delete(id);
    g.globalAlpha = Math.max(0, 1 - age);
    drawCircle(g, world, camera, id, palette.text, 2, RING_GAP_PX + 6);
    g.globalAlpha = 1;
  }
}

/** Four arcs: a selection differs from every other ring by its shape as well. */
function drawSelected(g: Context, world: World, camera: Camera, palette: Palette, id: BodyId): void {
  const place = placeOf(world, camera, id);
  if (!place) return;
  g.strokeStyle = palette.select;
  g.lineWidth = 2;
  g.beginPath();
  for (let quarter = 0; quarter < 4; quarter++) {
    const from = (quarter * Math.PI) / 2 + 0.3;
    g.moveTo(place.x + place.ring * Math.cos(from), place.y + place.ring * Math.sin(from));
    g.arc(place.x, place.y, place.ring, from, from + 0.97);
  }
  g.stroke();
}

function drawCircle(g: Context, world: World, camera: Camera, id: BodyId, colour: string, px: number, gap = 0): void {
  const place = placeOf(world, camera, id);
  if (!place) return;
  g.strokeStyle = colour;
  g.lineWidth = px;
  g.beginPath();
  g.arc(place.x, place.y, place.ring + gap, 0, 2 * Math.PI);
  g.stroke();
}

function drawLabel(g: Context, world: World, camera: Camera, id: BodyId, palette: Palette, colour: string): void {
  const place = placeOf(world, camera, id);
  if (!place) return;
  const text = bodyName(world.frames.newest.kindAt(place.slot), id);
  drawText(g, palette, colour, text, place.x, place.y - place.ring - LABEL_GAP_PX);
}

function placeOf(world: World, camera: Camera, id: BodyId) {
  const { newest, at } = world.frames;
  const slot = newest.slot.get(id);
  if (slot === undefined) return null;
  const radius = drawnRadius(newest, slot, camera.pixelsPerUnit);
  return {
    slot,
    x: camera.toScreenX(at.x[slot]!),
    y: camera.toScreenY(at.y[slot]!),
    ring: Math.max(LEAST_RING_PX, radius + RING_GAP_PX),
  };
}
