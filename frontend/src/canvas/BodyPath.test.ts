import { expect, it, vi } from 'vitest';
import { BodyPath } from './BodyPath';

it('fills_at_most_fifty_shapes_at_once', () => {
  const g = { beginPath: vi.fn(), fill: vi.fn(), stroke: vi.fn() };
  const path = new BodyPath(g as unknown as CanvasRenderingContext2D, 'red');

  for (let i = 0; i < 120; i++) path.next();
  path.flush();

  expect(g.fill).toHaveBeenCalledTimes(3);
  expect(g.beginPath).toHaveBeenCalledTimes(3);
  expect(g.stroke).not.toHaveBeenCalled();
});
