import { expect, it } from 'vitest';
import { Camera } from './Camera';

function camera(): Camera {
  const made = new Camera();
  made.resize(1000, 800);
  made.fit({ minX: -500, minY: -400, maxX: 500, maxY: 400 });
  return made;
}

it('y_points_up_in_the_world_and_down_on_the_screen', () => {
  expect(camera().toScreenY(100)).toBeLessThan(camera().toScreenY(0));
});

it('a_point_survives_the_trip_to_the_screen_and_back', () => {
  const c = camera();
  c.zoomAt(13, 700, 3.7);
  c.panBy(40, -9);

  expect(c.toWorldX(c.toScreenX(612.5))).toBeCloseTo(612.5, 9);
  expect(c.toWorldY(c.toScreenY(-208.25))).toBeCloseTo(-208.25, 9);
});

it('zooming_keeps_the_point_under_the_pointer', () => {
  const c = camera();
  const before = [c.toWorldX(250), c.toWorldY(90)];

  c.zoomAt(250, 90, 2);

  expect([c.toWorldX(250), c.toWorldY(90)]).toEqual([expect.closeTo(before[0]!, 9), expect.closeTo(before[1]!, 9)]);
});

it('fit_shows_the_bounds_whole', () => {
  const c = camera();
  c.fit({ minX: 1e-6, minY: 0, maxX: 3e-6, maxY: 1e-6 });

  expect(c.toScreenX(1e-6)).toBeGreaterThan(0);
  expect(c.toScreenX(3e-6)).toBeLessThan(1000);
});

it('fitting_a_single_point_keeps_the_scale', () => {
  const c = camera();
  const scale = c.pixelsPerUnit;
  c.fit({ minX: 5, minY: 5, maxX: 5, maxY: 5 });

  expect(c.pixelsPerUnit).toBe(scale);
  expect(c.toScreenX(5)).toBe(500);
});

it('dragging_moves_the_picture_with_the_hand', () => {
  const c = camera();
  const before = c.toScreenX(0);
  c.panBy(25, 0);
  expect(c.toScreenX(0)).toBeCloseTo(before + 25, 9);
});
