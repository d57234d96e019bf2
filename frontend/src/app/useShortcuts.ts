import { type RefObject, useEffect } from 'react';
import { actionOf, isFormField, type ShortcutAction } from '../features/Shortcuts/shortcuts';

/** Obeys the table of shortcuts, except in form fields and while a dialog is open. */
export function useShortcuts(actions: Record<ShortcutAction, () => void>, stage: RefObject<HTMLElement | null>): void {
  useEffect(() => {
    function onKeyDown(event: KeyboardEvent): void {
      if (event.defaultPrevented || isFormField(event.target) || document.querySelector('dialog[open]')) return;
      const action = actionOf(event, event.target === stage.current);
      if (action === null) return;
      event.preventDefault();
      actions[action]();
    }
    window.addEventListener('keydown', onKeyDown);
    return () => window.removeEventListener('keydown', onKeyDown);
  }, [actions, stage]);
}
