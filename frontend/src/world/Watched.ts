/** Something whose changes others follow; made for useSyncExternalStore. */
export abstract class Watched {
  readonly #watchers = new Set<() => void>();

  readonly subscribe = (watcher: () => void): (() => void) => {
    this.#watchers.add(watcher);
    return () => this.#watchers.delete(watcher);
  };

  protected changed(): void {
    for (const watcher of this.#watchers) watcher();
  }
}

/** One slow value: the room, the diagnostics, what the pointer is over. */
export class Value<T> extends Watched {
  #current: T;

  constructor(first: T) {
    super();
    this.#current = first;
  }

  readonly current = (): T => this.#current;

  set(next: T): void {
    if (Object.is(next, this.#current)) return;
    this.#current = next;
    this.changed();
  }
}
