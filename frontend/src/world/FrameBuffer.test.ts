import { describe, expect, it } from 'vitest';
import { FrameBuffer } from './FrameBuffer';
import { asteroid, bodyId, FRAME_MS, frame, planet, ship } from './testFrames';

/** Two frames, one interval apart; sampling at 2 intervals shows the second. */
function between(first: ReturnType<typeof frame>, second: ReturnType<typeof frame>): FrameBuffer {
  const frames = new FrameBuffer();
  frames.accept(first, 0);
  frames.accept(second, FRAME_MS);
  return frames;
}

const fast = { velocity: { x: 300, y: 0 } };

describe('between two frames', () => {
  it('a_body_is_half_way_after_half_the_interval', () => {
    const frames = between(frame(0, planet(1, 0, 0, fast)), frame(5, planet(1, 10, 0, fast)));

    frames.sample(1.5 * FRAME_MS);

    expect(frames.at.x[0]).toBeCloseTo(5, 6);
  });

  it('the_newest_frame_is_reached_one_interval_after_it_came', () => {
    const frames = between(frame(0, planet(1, 0, 0, fast)), frame(5, planet(1, 10, 0, fast)));

    frames.sample(2 * FRAME_MS);

    expect(frames.at.x[0]).toBeCloseTo(10, 6);
  });

  it('a_late_frame_is_guessed_for_100_ms_and_no_longer', () => {
    const frames = between(frame(0, planet(1, 0, 0, fast)), frame(5, planet(1, 10, 0, fast)));

    frames.sample(60_000);

    expect(frames.at.x[0]).toBeCloseTo(10 + 10 * 3, 6); // 100 ms are 3 intervals
  });

  it('an_angle_turns_the_short_way', () => {
    const frames = between(frame(0, asteroid(1, 0, 0, { angle: 3.1 })), frame(5, asteroid(1, 0, 0, { angle: -3.1 })));

    frames.sample(1.5 * FRAME_MS);

    expect(Math.cos(frames.at.angle[0]!)).toBeCloseTo(-1, 3);
  });

  it('a_body_that_wraps_round_jumps_and_does_not_fly_across', () => {
    const frames = between(frame(0, planet(1, 998, 0, fast)), frame(5, planet(1, -992, 0, fast)));

    frames.sample(1.5 * FRAME_MS);

    expect(frames.at.x[0]).toBe(-992);
    expect(frames.isContinuous(0)).toBe(false);
  });

  it('bodies_keep_their_own_path_when_one_before_them_is_deleted', () => {
    const frames = between(frame(0, planet(1), planet(2, 100, 0, fast)), frame(5, planet(2, 110, 0, fast)));

    frames.sample(1.5 * FRAME_MS);

    expect(frames.at.x[0]).toBeCloseTo(105, 6);
  });

  it('a_new_body_is_where_it_is', () => {
    const frames = between(frame(0, planet(1)), frame(5, planet(1), planet(2, 40, 7)));

    frames.sample(FRAME_MS);

    expect([frames.at.x[1], frames.at.y[1]]).toEqual([40, 7]);
  });
});

describe('the life of the room', () => {
  it('a_clock_that_runs_backwards_is_noticed_and_nothing_is_interpolated', () => {
    const frames = new FrameBuffer();
    frames.accept(frame(5000, planet(1, 0, 0, fast)), 0);

    expect(frames.accept(frame(5, planet(1, 4, 0, fast)), FRAME_MS)).toBe(true);
    frames.sample(1.5 * FRAME_MS);
    expect(frames.at.x[0]).toBe(4);
  });

  it('after_a_restart_the_first_frame_stands_alone', () => {
    const frames = new FrameBuffer();
    frames.accept(frame(0, planet(1, 0, 0, fast)), 0);
    frames.restart();

    frames.accept(frame(5, planet(1, 4, 0, fast)), FRAME_MS);
    frames.sample(1.5 * FRAME_MS);

    expect(frames.at.x[0]).toBe(4);
  });

  it('a_ship_that_has_stopped_keeps_its_heading', () => {
    const frames = between(frame(0, ship(1, 0, 0, { velocity: { x: 0, y: 40 } })), frame(5, ship(1)));

    expect(frames.newest.angle[0]).toBeCloseTo(Math.PI / 2, 9);
  });

  it('lists_hear_of_frames_five_times_a_second', () => {
    const frames = new FrameBuffer();
    for (let i = 0; i < 30; i++) frames.accept(frame(5 * i, planet(1)), i * FRAME_MS);

    expect(frames.version()).toBe(5);
  });

  it('two_thousand_bodies_fit', () => {
    const many = Array.from({ length: 2000 }, (_, i) => planet(i + 1, i));
    const frames = between(frame(0, planet(1)), frame(5, ...many));

    frames.sample(2 * FRAME_MS);

    expect(frames.at.x[1999]).toBe(1999);
    expect(frames.has(bodyId(2000))).toBe(true);
  });
});

it('jitter_of_the_network_hardly_moves_the_picture', () => {
  const frames = new FrameBuffer();
  const jitter = [0, 6, -5, 9, -8, 3, -4, 7, -9, 2];
  for (let i = 0; i < 100; i++) {
    frames.accept(frame(5 * i, planet(1, 10 * i, 0, fast)), i * FRAME_MS + jitter[i % 10]!);
  }

  frames.sample(99.5 * FRAME_MS + 10);

  // Half an interval after the last frame, 10 ms later: 98 whole steps, then 0.5 + 0.3.
  expect(frames.at.x[0]!).toBeGreaterThan(980 + 6);
  expect(frames.at.x[0]!).toBeLessThan(980 + 10);
});
