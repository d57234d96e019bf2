import type { Boundary } from '../protocol/messages';
import type { Camera } from './Camera';
import { niceStep } from './niceStep';
import type { Palette } from './Palette';

type Context = CanvasRenderingContext2D;

/** The empty sky, and the grid if it is asked for. */
export function drawSky(g: Context, camera: Camera, palette: Palette, hasGrid: boolean): void {
  g.fillStyle = palette.sky;
  g.fillRect(0, 0, camera.width, camera.height);
  if (hasGrid) drawGrid(g, camera, palette);
}

function drawGrid(g: Context, camera: Camera, palette: Palette): void {
  const step = niceStep(camera.pixelsPerUnit);
  g.strokeStyle = palette.grid;
  g.lineWidth = 1;
  g.beginPath();
  for (let x = Math.ceil(camera.toWorldX(0) / step) * step; x <= camera.toWorldX(camera.width); x += step) {
    const at = Math.round(camera.toScreenX(x)) + 0.5;
    g.moveTo(at, 0);
    g.lineTo(at, camera.height);
  }
  for (let y = Math.ceil(camera.toWorldY(camera.height) / step) * step; y <= camera.toWorldY(0); y += step) {
    const at = Math.round(camera.toScreenY(y)) + 0.5;
    g.moveTo(0, at);
    g.lineTo(camera.width, at);
  }
  g.stroke();
}

/** The edge of the world: a line where bodies bounce off, dashes where they come in again on the other side. */
export function drawEdge(g: Context, camera: Camera, palette: Palette, edge: Boundary | undefined): void {
  if (!edge || edge.kind === 'open') return;
  const left = camera.toScreenX(edge.minX);
  const top = camera.toScreenY(edge.maxY);
  g.strokeStyle = palette.wall;
  g.lineWidth = 1;
  if (edge.kind === 'periodic') g.setLineDash([8, 6]);
  g.strokeRect(left, top, camera.toScreenX(edge.maxX) - left, camera.toScreenY(edge.minY) - top);
  g.setLineDash([]);
}
