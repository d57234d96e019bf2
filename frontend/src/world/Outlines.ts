import type { BodyId, BodyState } from '../protocol/frame';

/** The asteroids' outlines, x and y in turn about the centre. They never change, so each is converted once. */
export class Outlines {
  readonly #byId = new Map<BodyId, Float64Array>();

  of(id: BodyId): Float64Array | undefined {
    return this.#byId.get(id);
  }

  clear(): void {
    this.#byId.clear();
  }

  learn(bodies: readonly BodyState[]): void {
    for (const body of bodies) {
      if (body.kind !== 'asteroid' || this.#byId.has(body.id)) continue;
      this.#byId.set(body.id, Float64Array.from(body.vertices.flatMap(({ x, y }) => [x, y])));
    }
    // Deleted bodies leave their outlines behind; swept when they outnumber the living.
    if (this.#byId.size > 2 * bodies.length + 64) this.#sweep(new Set(bodies.map((body) => body.id)));
  }

  #sweep(alive: ReadonlySet<BodyId>): void {
    for (const id of this.#byId.keys()) if (!alive.has(id)) this.#byId.delete(id);
  }
}
