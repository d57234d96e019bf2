import { expect, it } from 'vitest';
import { backoffMs } from './backoff';

it('doubles_from_half_a_second', () => {
  expect([1, 2, 3].map((n) => backoffMs(n, true, 1))).toEqual([500, 1000, 2000]);
});

it('stays_under_two_seconds_while_somebody_looks', () => {
  expect(backoffMs(30, false, 1)).toBeLessThan(2000);
});

it('goes_up_to_15_seconds_in_a_hidden_tab', () => {
  expect(backoffMs(30, true, 1)).toBe(15_000);
});

it('spreads_the_clients_of_one_room', () => {
  expect(backoffMs(1, false, 0)).toBe(400);
});
