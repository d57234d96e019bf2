import { expect, it } from 'vitest';
import { formatCoordinate, formatDrift, formatMillis, formatNumber, formatRange } from './formatNumber';

it.each([
  [0, '0'],
  [12, '12.00'],
  [38.42, '38.42'],
  [120.44, '120.4'],
  [99.999, '100.0'],
  [999.96, '1\u2009000'],
  [9400, '9\u2009400'],
  [61000, '61\u2009000'],
  [1234567, '1\u2009234\u2009567'],
  [1.989e30, '2.0e30'],
  [0.42, '0.420'],
  [0.9999, '1.00'],
  [0.0172, '0.0172'],
  [0.00123, '0.00123'],
  [3.0027e-6, '3.0e\u22126'],
  [-7.5, '\u22127.50'],
  [-0.00001, '\u22121.0e\u22125'],
  [Number.NaN, 'none'],
])('%d_reads_%s', (value, text) => {
  expect(formatNumber(value)).toBe(text);
});

it('a_drift_shows_its_sign', () => {
  expect(formatDrift(2.1e-6)).toBe('+2.1e\u22126');
  expect(formatDrift(-3.4e-13)).toBe('\u22123.4e\u221213');
  expect(formatDrift(0)).toBe('0');
});

it('equal_looking_ends_of_a_range_are_one_number', () => {
  expect(formatRange([12, 12.001])).toBe('12.00');
  expect(formatRange([33.15, 38.42, 36])).toBe('33.15 to 38.42');
});

it('a_far_coordinate_has_no_decimals', () => {
  expect(formatCoordinate(612.4)).toBe('612');
  expect(formatCoordinate(-1200.7)).toBe('\u22121\u2009201');
  expect(formatCoordinate(0.387)).toBe('0.387');
});

it('short_times_keep_two_decimals', () => {
  expect(formatMillis(1.844)).toBe('1.84');
  expect(formatMillis(18.2)).toBe('18');
});
