import { expect, it, vi } from 'vitest';
import { Selection } from './Selection';
import { bodyId } from './testFrames';

const [a, b, c] = [bodyId(1), bodyId(2), bodyId(3)];

it('selecting_one_body_deselects_the_others_and_tells_the_room_of_both', () => {
  const tell = vi.fn();
  const selection = new Selection(tell);
  selection.only(a);
  selection.only(b);

  expect(selection.ids()).toEqual([b]);
  expect(tell.mock.calls).toEqual([
    [a, true],
    [a, false],
    [b, true],
  ]);
});

it('toggling_adds_and_takes_away', () => {
  const selection = new Selection();
  selection.only(a);
  selection.toggle(b);
  selection.toggle(a);

  expect(selection.ids()).toEqual([b]);
});

it('the_last_one_selected_is_the_main_one', () => {
  const selection = new Selection();
  for (const id of [a, b, c, a]) selection.add(id);

  expect(selection.main()).toBe(a);
  expect(selection.ids()).toEqual([b, c, a]);
});

it('the_room_hears_which_one_has_become_the_main_one', () => {
  const tell = vi.fn();
  const selection = new Selection(tell);
  for (const id of [a, b]) selection.add(id);
  tell.mockClear();

  selection.add(a);
  selection.add(a);

  expect(tell.mock.calls).toEqual([[a, true]]);
});

it('what_no_longer_exists_is_dropped_without_telling_the_room', () => {
  const tell = vi.fn();
  const selection = new Selection(tell);
  selection.only(a);
  selection.add(b);
  tell.mockClear();

  selection.keep((id) => id === b);

  expect(selection.ids()).toEqual([b]);
  expect(tell).not.toHaveBeenCalled();
});

it('hands_out_the_same_array_until_something_changes', () => {
  const selection = new Selection();
  selection.only(a);
  const before = selection.ids();
  selection.keep(() => true);

  expect(selection.ids()).toBe(before);
});
