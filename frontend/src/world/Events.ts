import type { ShipEvent, ShipEvents } from '../protocol/messages';
import { Watched } from './Watched';

const AT_MOST = 4;
const SHOWN_MS = 8000;
/** What happened longer ago than this many ticks before its message is no news, for a page that has just been opened. */
const NEWS_TICKS = 450;

/** What has just happened to ships: the last few events, each for some seconds. */
export class Events extends Watched {
  #recent: readonly ShipEvent[] = [];
  #last = 0;

  /** The same array until something changes; the newest comes last. */
  readonly recent = (): readonly ShipEvent[] => this.#recent;

  /** Takes a message in, and answers what in it is new. */
  take({ tick, events }: ShipEvents): readonly ShipEvent[] {
    const newest = events.at(-1)?.number ?? 0;
    if (newest < this.#last) this.#last = 0; // the room began anew
    const fresh = events.filter((event) => event.number > this.#last && tick - event.tick <= NEWS_TICKS);
    this.#last = newest;
    if (fresh.length === 0) return fresh;
    this.#recent = [...this.#recent, ...fresh].slice(-AT_MOST);
    setTimeout(() => this.#forget(fresh), SHOWN_MS);
    this.changed();
    return fresh;
  }

  clear(): void {
    this.#last = 0;
    this.#forget(this.#recent);
  }

  #forget(old: readonly ShipEvent[]): void {
    if (!this.#recent.some((event) => old.includes(event))) return;
    this.#recent = this.#recent.filter((event) => !old.includes(event));
    this.changed();
  }
}
