import type { Diagnostics } from '../../protocol/messages';
import { formatCount, formatDrift, formatMillis, formatNumber } from '../../ui/formatNumber';

/** Of the link, which only the page's frame knows. */
export type LinkFigures = { readonly delayMs: number; readonly bytesPerSecond: number };

export type FigureGroup = { readonly title: string; readonly figures: readonly (readonly [string, string])[] };

const NONE = 'none';

/** All figures, by what they tell about; "none" for what was not measured, or has no meaning in this scene. */
export function figureGroups(newest: Diagnostics | null, link: LinkFigures | null, drawnHz: number): FigureGroup[] {
  const of = (text: (from: Diagnostics) => string) => (newest ? text(newest) : NONE);
  return [
    {
      title: 'Energy',
      figures: [
        ['Kinetic', of((from) => numberText(from.kinetic))],
        ['Potential', of((from) => numberText(from.potential))],
        ['Total', of((from) => numberText(from.energy))],
        ['Energy drift', of((from) => driftText(from.energyDrift))],
        ['Virial ratio', of((from) => numberText(from.virialRatio))],
      ],
    },
    {
      title: 'Momentum',
      figures: [
        ['Momentum', of(({ momentum }) => pairText(momentum?.x ?? null, momentum?.y ?? null))],
        ['Momentum drift', of((from) => driftText(from.momentumDrift))],
        ['Angular momentum', of((from) => numberText(from.angularMomentum))],
        ['Angular drift', of((from) => driftText(from.angularMomentumDrift))],
        ['Centre of mass', of((from) => pairText(from.centreOfMassX, from.centreOfMassY))],
      ],
    },
    {
      title: 'Room',
      figures: [
        ['Bodies', of((from) => formatCount(from.bodies))],
        ['Clients', of((from) => formatCount(from.clients))],
        ['Gravity', of((from) => from.gravitySolver ?? NONE)],
        ['Force error', of((from) => (from.forceError === null ? NONE : formatNumber(from.forceError)))],
      ],
    },
    {
      title: 'Speed',
      figures: [
        ['Tick', of(({ tickMillis: { p50, p99 } }) => `${formatMillis(p50)} ms, rarely ${formatMillis(p99)}`)],
        ['Ticks/s', of((from) => formatCount(from.ticksPerSecond))],
        ['Clock', of(({ speed }) => `${Math.round(100 * speed)} % of real time`)],
        ['Late, dropped', of((from) => `${formatCount(from.lateTicks)}, ${formatCount(from.droppedTicks)}`)],
        ['Delay', link ? `${formatCount(link.delayMs)} ms` : NONE],
        ['Stream', link ? `${formatCount(link.bytesPerSecond / 1000)} kB/s` : NONE],
        ['Drawing', `${drawnHz} fps`],
      ],
    },
  ];
}

export function numberText(value: number | null): string {
  return value === null ? NONE : formatNumber(value);
}

/** A scene that does not ask for it has no drift to show. */
export function driftText(drift: number | null): string {
  return drift === null ? NONE : formatDrift(drift);
}

function pairText(x: number | null, y: number | null): string {
  return x === null || y === null ? NONE : `${formatNumber(x)}, ${formatNumber(y)}`;
}
