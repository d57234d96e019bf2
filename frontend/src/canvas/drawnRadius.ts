import { type FrameColumns, PLANET, SHIP } from '../world/FrameColumns';

/** Under this true radius a body is a square: nobody can see the difference. */
export const SQUARE_BELOW_PX = 2;
/** Under this drawn radius a body is a flat shape without a rim. */
export const FLAT_BELOW_PX = 4;

// Never smaller, so that it can be seen and clicked. A dart needs more pixels than a dot to show where it is heading.
const SMALLEST_PX = 2.5;
const SMALLEST_SHIP_PX = 4.5;
const SMALLEST_PLANET_PX = 3;
/** What the largest planet of the scene has on top: seen from far away, a sun is still more than its planets. */
const LARGEST_PLANET_PX = 5;

/** Radius on the screen, in pixels, of the body in this slot. */
export function drawnRadius(frame: FrameColumns, slot: number, pixelsPerUnit: number): number {
  return Math.max(smallest(frame, slot), frame.radius[slot]! * pixelsPerUnit);
}

function smallest(frame: FrameColumns, slot: number): number {
  const kind = frame.kind[slot];
  if (kind === SHIP) return SMALLEST_SHIP_PX;
  if (kind !== PLANET) return SMALLEST_PX;
  return SMALLEST_PLANET_PX + LARGEST_PLANET_PX * Math.cbrt(frame.radius[slot]! / frame.largestRadius);
}
