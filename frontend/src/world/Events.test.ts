import { beforeEach, expect, it, vi } from 'vitest';
import type { ShipEvent } from '../protocol/messages';
import { Events } from './Events';
import { eventText } from './eventText';
import { bodyId } from './testFrames';

const rock = { id: bodyId(9), kind: 'asteroid' } as const;

function event(number: number, more: Partial<ShipEvent> = {}): ShipEvent {
  return { number, tick: 1000, time: 6.7, type: 'arrived', ship: bodyId(17), other: null, speed: null, ...more };
}

const message = (...events: ShipEvent[]) => ({ tick: 1010, unlisted: 0, events });
const numbers = (events: readonly ShipEvent[]) => events.map(({ number }) => number);

beforeEach(() => {
  vi.useFakeTimers();
});

it('each_event_is_new_once_however_often_it_is_told', () => {
  const events = new Events();

  expect(numbers(events.take(message(event(1), event(2))))).toEqual([1, 2]);
  expect(numbers(events.take(message(event(1), event(2), event(3))))).toEqual([3]);
  expect(numbers(events.take(message(event(2), event(3))))).toEqual([]);
});

it('no_more_than_four_are_shown_and_each_for_eight_seconds', () => {
  const events = new Events();
  events.take(message(event(1), event(2), event(3)));
  vi.advanceTimersByTime(4000);
  events.take(message(event(4), event(5)));
  expect(numbers(events.recent())).toEqual([2, 3, 4, 5]);

  vi.advanceTimersByTime(4000);
  expect(numbers(events.recent())).toEqual([4, 5]);

  vi.advanceTimersByTime(4000);
  expect(events.recent()).toEqual([]);
});

it('what_happened_before_the_page_was_opened_is_no_news', () => {
  expect(new Events().take(message(event(1, { tick: 200 }), event(2)))).toEqual([event(2)]);
});

it('a_room_that_began_anew_counts_from_one_again', () => {
  const events = new Events();
  events.take(message(event(40)));

  expect(numbers(events.take(message(event(1))))).toEqual([1]);
});

it('hands_out_the_same_array_until_something_changes', () => {
  const events = new Events();
  events.take(message(event(1)));
  const before = events.recent();
  events.take(message(event(1)));

  expect(events.recent()).toBe(before);
});

it.each([
  ['Ship 17 has arrived', event(1)],
  ['Ship 17 hit Asteroid 9', event(1, { type: 'collided', other: rock, speed: 12.5 })],
  ['Ship 17 hit Asteroid 9 and is gone', event(1, { type: 'destroyed', other: rock, speed: 12.5 })],
])('%s', (text, of) => {
  expect(eventText(of)).toBe(text);
});
