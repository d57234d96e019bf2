import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { NewestOnly } from './NewestOnly';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

it('of_many_values_between_two_pictures_only_the_newest_counts', () => {
  const deliver = vi.fn();
  const newest = new NewestOnly<number>(deliver);
  for (const value of [1, 2, 3]) newest.put(value);
  vi.advanceTimersByTime(20);
  newest.put(4);
  vi.advanceTimersByTime(20);

  expect(deliver.mock.calls).toEqual([[3], [4]]);
});

it('what_was_dropped_is_not_delivered', () => {
  const deliver = vi.fn();
  const newest = new NewestOnly<number>(deliver);
  newest.put(1);
  newest.drop();
  vi.advanceTimersByTime(20);

  expect(deliver).not.toHaveBeenCalled();
});
