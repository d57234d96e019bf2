const THIN_SPACE = '\u2009';
const MINUS = '\u2212';

/**
 * A number as a person reads it, from solar masses to grains: three or four digits that mean something.
 *
 * 61000 → "61 000", 120.4 → "120.4", 38.42, 0.420, 0.0172, 3.0e−6, 2.0e30.
 */
export function formatNumber(value: number): string {
  if (!Number.isFinite(value)) return 'none';
  const size = Math.abs(value);
  const sign = value < 0 ? MINUS : '';
  if (size === 0) return '0';
  if (size < 0.001 || size >= 1e7) return sign + formatPower(size);
  if (size < 0.9995) return sign + withoutExponent(size);
  if (size >= 999.95) return sign + groupThousands(size.toFixed(0));
  return sign + size.toFixed(size >= 99.995 ? 1 : 2);
}

/** A small relative change with its sign: "+2.1e−6". */
export function formatDrift(value: number): string {
  if (value === 0) return '0';
  return (value < 0 ? MINUS : '+') + formatPower(Math.abs(value));
}

/** A coordinate, of which only the part that can be seen at this zoom is worth reading. */
export function formatCoordinate(value: number): string {
  if (Math.abs(value) < 99.5) return formatNumber(value);
  return (value < 0 ? MINUS : '') + groupThousands(Math.abs(value).toFixed(0));
}

/** Milliseconds: two decimals while they matter. */
export function formatMillis(value: number): string {
  return value < 10 ? value.toFixed(2) : groupThousands(value.toFixed(0));
}

/** An integer with its thousands apart. */
export function formatCount(value: number): string {
  return groupThousands(Math.round(value).toFixed(0));
}

/** "33.15 to 38.42", or one number where all look alike. */
export function formatRange(values: readonly number[]): string {
  const least = formatNumber(Math.min(...values));
  const most = formatNumber(Math.max(...values));
  return least === most ? least : `${least} to ${most}`;
}

function withoutExponent(size: number): string {
  const digits = 2 - Math.floor(Math.log10(size));
  return size.toFixed(digits);
}

function formatPower(size: number): string {
  const [mantissa, exponent] = size.toExponential(1).split('e');
  return `${mantissa}e${exponent!.replace('+', '').replace('-', MINUS)}`;
}

function groupThousands(digits: string): string {
  return digits.replace(/\B(?=(\d{3})+$)/g, THIN_SPACE);
}
