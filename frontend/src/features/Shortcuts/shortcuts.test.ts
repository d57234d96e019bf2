import { expect, it } from 'vitest';
import { actionOf, isFormField, SHORTCUTS } from './shortcuts';

const press = (key: string, held: Partial<KeyboardEvent> = {}) => ({
  key,
  shiftKey: false,
  ctrlKey: false,
  metaKey: false,
  altKey: false,
  ...held,
});

it('every_shortcut_of_the_table_is_obeyed', () => {
  for (const { keys, shift, action } of SHORTCUTS) {
    for (const key of keys) expect(actionOf(press(key, { shiftKey: shift ?? false }), true)).toBe(action);
  }
});

it('no_two_actions_share_a_key', () => {
  const taken = SHORTCUTS.flatMap(({ keys, shift }) => keys.map((key) => `${key} ${shift ?? false}`));
  expect(new Set(taken).size).toBe(taken.length);
});

it.each(['ctrlKey', 'metaKey', 'altKey'] as const)('leaves_%s_to_the_browser', (held) => {
  expect(actionOf(press('f', { [held]: true }), true)).toBeNull();
});

it('arrows_and_enter_belong_to_the_browser_outside_the_stage', () => {
  for (const key of ['ArrowLeft', 'ArrowUp', 'Enter']) expect(actionOf(press(key), false)).toBeNull();
});

it('caps_lock_does_not_change_a_shortcut', () => {
  expect(actionOf(press('N'), false)).toBe('next-body');
  expect(actionOf(press('N', { shiftKey: true }), false)).toBe('add-next-body');
});

it('text_fields_keep_their_keys', () => {
  expect(isFormField(document.createElement('input'))).toBe(true);
  expect(isFormField(document.createElement('button'))).toBe(false);
});

it('every_action_is_in_the_dialog', () => {
  const shown = new Set(SHORTCUTS.filter(({ text }) => text !== '').map(({ action }) => action));
  const silent = SHORTCUTS.map(({ action }) => action).filter((action) => !shown.has(action));
  expect([...new Set(silent)]).toEqual(['right', 'up', 'down']);
});
