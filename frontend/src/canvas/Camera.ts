import type { Bounds } from '../protocol/messages';

/** Share of the stage that stays free around what `fit` shows. */
const MARGIN = 0.08;
/** How far one can zoom from what was last fitted, in and out. */
const RANGE = 10_000;

/** The only place that knows both the world (scene units, y up) and the screen (CSS pixels, y down). */
export class Camera {
  x = 0;
  y = 0;
  pixelsPerUnit = 1;
  width = 1;
  height = 1;
  #fitted = 1;
  #watchers = new Set<() => void>();

  readonly subscribe = (watcher: () => void): (() => void) => {
    this.#watchers.add(watcher);
    return () => this.#watchers.delete(watcher);
  };

  readonly scale = (): number => this.pixelsPerUnit;

  toScreenX(x: number): number {
    return this.width / 2 + (x - this.x) * this.pixelsPerUnit;
  }

  toScreenY(y: number): number {
    return this.height / 2 - (y - this.y) * this.pixelsPerUnit;
  }

  toWorldX(screenX: number): number {
    return this.x + (screenX - this.width / 2) / this.pixelsPerUnit;
  }

  toWorldY(screenY: number): number {
    return this.y - (screenY - this.height / 2) / this.pixelsPerUnit;
  }

  resize(width: number, height: number): void {
    this.width = width;
    this.height = height;
  }

  lookAt(x: number, y: number): void {
    this.x = x;
    this.y = y;
  }

  /** Moves the picture by so many pixels, as a drag does. */
  panBy(dxPx: number, dyPx: number): void {
    this.x -= dxPx / this.pixelsPerUnit;
    this.y += dyPx / this.pixelsPerUnit;
  }

  /** Zooms about a point of the screen, which stays where it is. */
  zoomAt(screenX: number, screenY: number, factor: number): void {
    const wanted = this.pixelsPerUnit * factor;
    const x = this.toWorldX(screenX);
    const y = this.toWorldY(screenY);
    this.pixelsPerUnit = Math.min(Math.max(wanted, this.#fitted / RANGE), this.#fitted * RANGE);
    this.x = x - (screenX - this.width / 2) / this.pixelsPerUnit;
    this.y = y + (screenY - this.height / 2) / this.pixelsPerUnit;
    this.#changed();
  }

  zoom(factor: number): void {
    this.zoomAt(this.width / 2, this.height / 2, factor);
  }

  /** Shows these bounds whole, with a margin. A single point is shown at the present scale. */
  fit({ minX, minY, maxX, maxY }: Bounds): void {
    this.lookAt((minX + maxX) / 2, (minY + maxY) / 2);
    const free = 1 - 2 * MARGIN;
    const scale = Math.min((free * this.width) / (maxX - minX), (free * this.height) / (maxY - minY));
    if (Number.isFinite(scale) && scale > 0) this.pixelsPerUnit = this.#fitted = scale;
    this.#changed();
  }

  #changed(): void {
    for (const watcher of this.#watchers) watcher();
  }
}
