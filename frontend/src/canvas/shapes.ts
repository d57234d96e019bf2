type Path = Pick<CanvasRenderingContext2D, 'moveTo' | 'lineTo' | 'arc' | 'closePath' | 'rect'>;

/**
 * A square about a point. Drawn counter-clockwise like the outlines (hence the negative height): in one path, shapes of
 * opposite sense punch holes into each other where they overlap.
 */
export function addSquare(path: Path, x: number, y: number, side: number): void {
  path.rect(x - side / 2, y + side / 2, side, -side);
}

export function addDisc(path: Path, x: number, y: number, radius: number): void {
  path.moveTo(x + radius, y);
  path.arc(x, y, radius, 0, 2 * Math.PI);
}

// Light comes from the upper left: the lit part is a circle of 1.02 r, moved there by 0.32 r on both axes. Night is what
// it leaves of the disc, a crescent between the two circles' points of intersection, which scale with r.
const LIGHT = (-3 / 4) * Math.PI;
const LIT_RADIUS = 1.02;
const LIT_SHIFT = Math.hypot(0.32, 0.32);
const DISC_ANGLE = Math.acos((LIT_SHIFT ** 2 + 1 - LIT_RADIUS ** 2) / (2 * LIT_SHIFT));
const LIT_ANGLE = Math.atan2(Math.sin(DISC_ANGLE), Math.cos(DISC_ANGLE) - LIT_SHIFT);

/** The night side of a planet. */
export function addNight(path: Path, x: number, y: number, radius: number): void {
  path.arc(x, y, radius, LIGHT + DISC_ANGLE, LIGHT - DISC_ANGLE + 2 * Math.PI);
  const litX = x + LIT_SHIFT * radius * Math.cos(LIGHT);
  const litY = y + LIT_SHIFT * radius * Math.sin(LIGHT);
  path.arc(litX, litY, LIT_RADIUS * radius, LIGHT - LIT_ANGLE, LIGHT + LIT_ANGLE, true);
  path.closePath();
}

/** A convex outline in world units, turned by `angle` (counter-clockwise, y up) and put on the screen. */
export function addOutline(
  path: Path,
  outline: Float64Array,
  x: number,
  y: number,
  pixelsPerUnit: number,
  angle: number,
): void {
  const cos = Math.cos(angle) * pixelsPerUnit;
  const sin = Math.sin(angle) * pixelsPerUnit;
  for (let v = 0; v < outline.length; v += 2) {
    const screenX = x + cos * outline[v]! - sin * outline[v + 1]!;
    const screenY = y - sin * outline[v]! - cos * outline[v + 1]!;
    if (v === 0) path.moveTo(screenX, screenY);
    else path.lineTo(screenX, screenY);
  }
  path.closePath();
}

const DART = [1.5, 0, -1, 0.85, -0.5, 0, -1, -0.85]; // forward and left, in radii
const FLAME = [-0.6, 0.35, -1.9, 0, -0.6, -0.35];

/** A ship: a dart with a notch, heading along `angle`. */
export function addDart(path: Path, x: number, y: number, radius: number, angle: number): void {
  addTurned(path, DART, x, y, radius, angle);
}

export function addFlame(path: Path, x: number, y: number, radius: number, angle: number): void {
  addTurned(path, FLAME, x, y, radius, angle);
}

function addTurned(path: Path, shape: readonly number[], x: number, y: number, radius: number, angle: number): void {
  const cos = Math.cos(angle) * radius;
  const sin = Math.sin(angle) * radius;
  for (let v = 0; v < shape.length; v += 2) {
    const screenX = x + cos * shape[v]! - sin * shape[v + 1]!;
    const screenY = y - sin * shape[v]! - cos * shape[v + 1]!;
    if (v === 0) path.moveTo(screenX, screenY);
    else path.lineTo(screenX, screenY);
  }
  path.closePath();
}

export function addDiamond(path: Path, x: number, y: number, radius: number): void {
  path.moveTo(x, y - radius);
  path.lineTo(x + radius, y);
  path.lineTo(x, y + radius);
  path.lineTo(x - radius, y);
  path.closePath();
}
