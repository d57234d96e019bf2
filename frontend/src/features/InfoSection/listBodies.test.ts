import { expect, it } from 'vitest';
import { FrameColumns } from '../../world/FrameColumns';
import { asteroid, bodyId, frame, planet, ship } from '../../world/testFrames';
import { holdOrder, listBodies, nextSort } from './listBodies';

const bodies = new FrameColumns();
bodies.fill(
  frame(
    0,
    planet(1, 0, 0, { mass: 900 }),
    ship(17, 0, 0, { velocity: { x: 3, y: 4 } }),
    asteroid(9, 0, 0, { velocity: { x: 60, y: 0 } }),
    ship(170, 0, 0, { velocity: { x: 1, y: 0 } }),
  ),
  new FrameColumns(),
);

it('the_fastest_comes_first', () => {
  expect(listBodies(bodies, '', 'speed')).toEqual([9, 17, 170, 1]);
});

it('the_heaviest_comes_first_and_equals_by_id', () => {
  expect(listBodies(bodies, '', 'mass')).toEqual([1, 9, 17, 170]);
});

it.each([
  ['17', [17, 170]],
  ['ship', [17, 170]],
  ['Ship 170', [170]],
  [' ASTER ', [9]],
  ['comet', []],
])('finding_%s_finds_%s', (find, ids) => {
  expect(listBodies(bodies, find, 'id')).toEqual(ids);
});

it('a_held_order_does_not_let_rows_jump', () => {
  const ids = [9, 17, 1, 5].map(bodyId);
  const shown = [1, 9, 4, 17].map(bodyId);
  expect(holdOrder(ids, shown)).toEqual([1, 9, 17, 5]);
});

it('the_sort_button_goes_round', () => {
  expect(nextSort(nextSort(nextSort('speed')))).toBe('speed');
});
