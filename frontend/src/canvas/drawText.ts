import type { Palette } from './Palette';

/** A name on the stage, centred; a dark edge keeps it legible over bodies. */
export function drawText(
  g: CanvasRenderingContext2D,
  palette: Palette,
  colour: string,
  text: string,
  x: number,
  y: number,
): void {
  g.font = palette.labelFont;
  g.textAlign = 'center';
  g.lineJoin = 'round';
  g.lineWidth = 4;
  g.strokeStyle = palette.sky;
  g.strokeText(text, x, y);
  g.fillStyle = colour;
  g.fillText(text, x, y);
}
