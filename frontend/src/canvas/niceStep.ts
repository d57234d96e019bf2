const LEAST_PX = 80;

/** The shortest of 1, 2, 5, 10, 20 … units that is at least 80 pixels long: for the grid and the scale bar. */
export function niceStep(pixelsPerUnit: number): number {
  const least = LEAST_PX / pixelsPerUnit;
  const power = 10 ** Math.floor(Math.log10(least));
  const factor = [1, 2, 5, 10].find((f) => f * power >= least * (1 - 1e-9)) ?? 10;
  return factor * power;
}
