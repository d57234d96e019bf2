import { Watched } from './Watched';

export type Notice = { readonly key: number; readonly text: string };

const SHOWN_MS = 6000;
const AT_MOST = 3;

/** Short messages: problems, which are shown for a while, and news, which is only said to screen readers. */
export class Notices extends Watched {
  #problems: readonly Notice[] = [];
  #news = '';
  #key = 0;

  readonly problems = (): readonly Notice[] => this.#problems;

  readonly news = (): string => this.#news;

  problem(text: string): void {
    const notice = { key: ++this.#key, text };
    // The same refusal twice in a row is one message, shown anew.
    this.#problems = [...this.#problems.filter((other) => other.text !== text), notice].slice(-AT_MOST);
    setTimeout(() => this.dismiss(notice.key), SHOWN_MS);
    this.changed();
  }

  dismiss(key: number): void {
    this.#problems = this.#problems.filter((notice) => notice.key !== key);
    this.changed();
  }

  announce(text: string): void {
    this.#news = text;
    this.changed();
  }
}
