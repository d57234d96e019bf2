import { expect, it } from 'vitest';
import { niceStep } from './niceStep';

it.each([
  [1, 100],
  [0.8, 100],
  [0.5, 200],
  [0.2, 500],
  [30, 5],
  [4e7, 2e-6],
])('at_%d_pixels_per_unit_the_grid_has_a_line_every_%d', (pixelsPerUnit, step) => {
  expect(niceStep(pixelsPerUnit)).toBeCloseTo(step, 12);
});
