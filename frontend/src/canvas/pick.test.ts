import { expect, it } from 'vitest';
import { FrameBuffer } from '../world/FrameBuffer';
import { frame, planet, ship } from '../world/testFrames';
import { Camera } from './Camera';
import { pick } from './pick';

function scene(...bodies: Parameters<typeof frame>[1][]) {
  const frames = new FrameBuffer();
  frames.accept(frame(0, ...bodies), 0);
  frames.sample(0);
  const camera = new Camera();
  camera.resize(1000, 800); // one pixel is one unit, the origin is at 500, 400
  return { frames, camera };
}

it('a_body_under_the_pointer_is_picked', () => {
  const { frames, camera } = scene(planet(1), planet(2, 100, 50));
  expect(pick(frames, camera, 603, 352, 0)).toBe(2);
});

it('empty_space_is_nobody', () => {
  const { frames, camera } = scene(planet(1));
  expect(pick(frames, camera, 700, 400, 3)).toBeNull();
});

it('a_small_body_in_front_of_a_large_one_can_be_picked', () => {
  const { frames, camera } = scene(planet(1, 0, 0, { radius: 100 }), ship(2, 60, 0));
  expect(pick(frames, camera, 559, 400, 0)).toBe(2);
});

it('a_body_too_small_to_see_can_still_be_picked', () => {
  const { frames, camera } = scene(planet(1, 0, 0, { radius: 1e-6 }));
  expect(pick(frames, camera, 502, 400, 0)).toBe(1);
});

it('a_finger_may_miss_by_14_pixels', () => {
  const { frames, camera } = scene(ship(1));
  expect(pick(frames, camera, 520, 400, 14)).toBe(1);
  expect(pick(frames, camera, 520, 400, 3)).toBeNull();
});
