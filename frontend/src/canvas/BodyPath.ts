/** The browser's cost of one fill grows worse than linearly with its shapes: 415 ms for 10 000 in one, 40 in fifties. */
const SHAPES_PER_FILL = 50;

/** Collects shapes of one colour into a path, and fills it from time to time. */
export class BodyPath {
  readonly #g: CanvasRenderingContext2D;
  readonly #fill: string;
  readonly #rim: string | null;
  readonly #rimPx: number;
  #shapes = 0;

  constructor(g: CanvasRenderingContext2D, fill: string, rim: string | null = null, rimPx = 0) {
    this.#g = g;
    this.#fill = fill;
    this.#rim = rim;
    this.#rimPx = rimPx;
  }

  /** The context, ready for one more shape. */
  next(): CanvasRenderingContext2D {
    if (this.#shapes === SHAPES_PER_FILL) this.flush();
    if (this.#shapes++ === 0) this.#g.beginPath();
    return this.#g;
  }

  flush(): void {
    if (this.#shapes === 0) return;
    this.#shapes = 0;
    this.#g.fillStyle = this.#fill;
    this.#g.fill();
    if (this.#rim === null) return;
    this.#g.strokeStyle = this.#rim;
    this.#g.lineWidth = this.#rimPx;
    this.#g.stroke();
  }
}
