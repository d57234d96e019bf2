import { expect, it } from 'vitest';
import { FrameBuffer } from './FrameBuffer';
import { Trails } from './Trails';
import { bodyId, FRAME_MS, frame, planet } from './testFrames';

const velocity = { x: 300, y: 0 };

it('only_selected_bodies_leave_a_trail', () => {
  const frames = new FrameBuffer();
  const trails = new Trails();
  frames.accept(frame(0, planet(1), planet(2)), 0);
  trails.record(frames, [bodyId(2)]);

  expect(trails.of(bodyId(1))).toBeUndefined();
  expect(trails.of(bodyId(2))?.count).toBe(1);
});

it('a_trail_is_broken_where_its_body_jumps', () => {
  const frames = new FrameBuffer();
  const trails = new Trails();
  [0, 10, -900].forEach((x, i) => {
    frames.accept(frame(5 * i, planet(1, x, 0, { velocity })), i * FRAME_MS);
    trails.record(frames, [bodyId(1)]);
  });

  const trail = trails.of(bodyId(1))!;
  const points = Array.from({ length: trail.count }, (_, age) => trail.x[trail.index(age)]);
  expect(points).toEqual([-900, Number.NaN, 10, 0]);
});

it('deselecting_forgets_the_trail', () => {
  const frames = new FrameBuffer();
  const trails = new Trails();
  frames.accept(frame(0, planet(1)), 0);
  trails.record(frames, [bodyId(1)]);
  trails.record(frames, []);

  expect(trails.of(bodyId(1))).toBeUndefined();
});
