const SYMBOLS: Readonly<Record<string, string>> = {
  units: 'u',
  unit: 'u',
  'solar masses': 'M☉',
  'solar mass': 'M☉',
  days: 'd',
  day: 'd',
  years: 'yr',
  year: 'yr',
  seconds: 's',
};

/** The short form of a unit, for columns and behind values; what it does not know it leaves. */
export function unitSymbol(unit: string): string {
  return SYMBOLS[unit] ?? unit;
}
