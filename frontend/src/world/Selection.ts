import type { BodyId } from '../protocol/frame';
import { Watched } from './Watched';

/** What this client has selected, in the order of selecting; the last one is the main one. */
export class Selection extends Watched {
  #ids: readonly BodyId[] = [];
  readonly #tell: (id: BodyId, selected: boolean) => void;

  /** `tell` hears of every body that the user selects or deselects, so that the room can be told. */
  constructor(tell: (id: BodyId, selected: boolean) => void = () => {}) {
    super();
    this.#tell = tell;
  }

  /** The same array until the selection changes. */
  readonly ids = (): readonly BodyId[] => this.#ids;

  has(id: BodyId): boolean {
    return this.#ids.includes(id);
  }

  main(): BodyId | undefined {
    return this.#ids.at(-1);
  }

  /** Selects this body alone. */
  only(id: BodyId): void {
    this.#become([id]);
  }

  /** Selects this body as well. One that was selected before becomes the main one, and the room is told again. */
  add(id: BodyId): void {
    const isAgain = this.has(id) && this.main() !== id;
    this.#become([...this.#ids.filter((other) => other !== id), id]);
    if (isAgain) this.#tell(id, true);
  }

  toggle(id: BodyId): void {
    if (this.has(id)) this.#become(this.#ids.filter((other) => other !== id));
    else this.add(id);
  }

  clear(): void {
    this.#become([]);
  }

  /** Drops what no longer exists. The room has forgotten it already and is not told. */
  keep(exists: (id: BodyId) => boolean): void {
    if (this.#ids.every(exists)) return;
    this.#ids = this.#ids.filter(exists);
    this.changed();
  }

  #become(next: readonly BodyId[]): void {
    const before = this.#ids;
    this.#ids = next;
    for (const id of before) if (!next.includes(id)) this.#tell(id, false);
    for (const id of next) if (!before.includes(id)) this.#tell(id, true);
    this.changed();
  }
}
