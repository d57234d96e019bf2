import { expect, it } from 'vitest';
import { DelayMeter, RateMeter } from './meters';

it('thirty_frames_in_a_second_are_30_hz', () => {
  const meter = new RateMeter(0);
  for (let i = 0; i < 30; i++) {
    meter.countFrame();
    meter.countBytes(1000);
  }

  expect(meter.take(1000)).toEqual({ hz: 30, bytesPerSecond: 30_000 });
  expect(meter.take(2000).hz).toBe(0);
});

it('a_server_clock_that_is_an_hour_ahead_does_not_change_the_delay', () => {
  const meter = new DelayMeter();
  meter.roundTrip(10);
  const hour = 3_600_000;
  for (let i = 0; i < 100; i++) meter.arrived(i * 33, i * 33 + hour);

  expect(meter.delayMs()).toBeCloseTo(5, 1);
});

it('frames_that_come_200_ms_later_than_the_best_show_as_delay', () => {
  const meter = new DelayMeter();
  meter.arrived(0, 0);
  for (let i = 1; i < 60; i++) meter.arrived(i * 33 + 200, i * 33);

  expect(meter.delayMs()).toBeGreaterThan(190);
});
