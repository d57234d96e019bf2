import type { Diagnostics } from '../protocol/messages';
import { Watched } from './Watched';

const LENGTH = 60; // 15 s at 4 Hz

/** The newest diagnostics, and the recent past of the figures that have a trend. */
export class History extends Watched {
  #newest: Diagnostics | null = null;
  readonly tickMillis: number[] = [];
  readonly energyDrift: number[] = [];

  readonly newest = (): Diagnostics | null => this.#newest;

  add(diagnostics: Diagnostics): void {
    this.#newest = diagnostics;
    push(this.tickMillis, diagnostics.tickMillis.p50);
    if (diagnostics.energyDrift !== null) push(this.energyDrift, diagnostics.energyDrift);
    this.changed();
  }

  clear(): void {
    this.tickMillis.length = 0;
    this.energyDrift.length = 0;
  }
}

function push(values: number[], value: number): void {
  values.push(value);
  if (values.length > LENGTH) values.shift();
}
