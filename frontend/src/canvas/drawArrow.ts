const HEAD_PX = 8;

/** An arrow along the unit vector (ux, uy) of the screen, which begins `start` pixels from (x, y). */
export function drawArrow(
  g: CanvasRenderingContext2D,
  x: number,
  y: number,
  ux: number,
  uy: number,
  start: number,
  length: number,
): void {
  const tipX = x + ux * (start + length);
  const tipY = y + uy * (start + length);
  const neckX = tipX - ux * HEAD_PX;
  const neckY = tipY - uy * HEAD_PX;
  g.beginPath();
  g.moveTo(x + ux * start, y + uy * start);
  g.lineTo(neckX, neckY);
  g.stroke();
  g.beginPath();
  g.moveTo(tipX, tipY);
  g.lineTo(neckX - uy * 0.5 * HEAD_PX, neckY + ux * 0.5 * HEAD_PX);
  g.lineTo(neckX + uy * 0.5 * HEAD_PX, neckY - ux * 0.5 * HEAD_PX);
  g.fill();
}
