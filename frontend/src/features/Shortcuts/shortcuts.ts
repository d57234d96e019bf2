/** What a key can do; the page says how. */
export type ShortcutAction =
  | 'add-planet'
  | 'add-asteroid'
  | 'add-ship'
  | 'add-random'
  | 'select-tool'
  | 'find'
  | 'next-body'
  | 'previous-body'
  | 'add-next-body'
  | 'add-previous-body'
  | 'delete'
  | 'clear'
  | 'aim'
  | 'send'
  | 'left'
  | 'right'
  | 'up'
  | 'down'
  | 'zoom-in'
  | 'zoom-out'
  | 'fit'
  | 'help';

export type Shortcut = {
  readonly action: ShortcutAction;
  /** Values of KeyboardEvent.key; letters in lower case. */
  readonly keys: readonly string[];
  /** Whether Shift must be down; undefined where it does not matter. */
  readonly shift?: boolean;
  /** Only while the stage has the focus: elsewhere these keys belong to the browser. */
  readonly onStage?: true;
  /** For the dialog: how the keys are written, and what they do. Rows without text share the row before. */
  readonly shown: string;
  readonly text: string;
  readonly group: 'Add' | 'Select' | 'Send ships' | 'Look';
};

/** Every shortcut of the page, once: the dialog shows this table and the handler obeys it. */
export const SHORTCUTS: readonly Shortcut[] = [
  { action: 'add-planet', keys: ['1'], shown: '1', text: 'Add a planet', group: 'Add' },
  { action: 'add-asteroid', keys: ['2'], shown: '2', text: 'Add an asteroid', group: 'Add' },
  { action: 'add-ship', keys: ['3'], shown: '3', text: 'Add a ship', group: 'Add' },
  { action: 'add-random', keys: ['4'], shown: '4', text: 'Add a body of a random kind', group: 'Add' },
  { action: 'select-tool', keys: ['v'], shown: 'V', text: 'Go to the stage, to select', group: 'Select' },
  { action: 'next-body', keys: ['n'], shift: false, shown: 'N or ]', text: 'Next body, ships first', group: 'Select' },
  { action: 'next-body', keys: [']'], shown: '', text: '', group: 'Select' },
  { action: 'previous-body', keys: ['p'], shift: false, shown: 'P or [', text: 'Previous body', group: 'Select' },
  { action: 'previous-body', keys: ['['], shown: '', text: '', group: 'Select' },
  { action: 'add-next-body', keys: ['n'], shift: true, shown: 'Shift N', text: 'Next body as well', group: 'Select' },
  {
    action: 'add-previous-body',
    keys: ['p'],
    shift: true,
    shown: 'Shift P',
    text: 'Previous body as well',
    group: 'Select',
  },
  { action: 'find', keys: ['/'], shown: '/', text: 'Find a body by id or type', group: 'Select' },
  {
    action: 'delete',
    keys: ['Delete', 'Backspace'],
    shown: 'Delete',
    text: 'Delete what is selected',
    group: 'Select',
  },
  { action: 'clear', keys: ['Escape'], shown: 'Esc', text: 'Put the cross away, or select nothing', group: 'Select' },
  { action: 'aim', keys: ['t'], shown: 'T', text: 'Put a cross on the stage, as the target', group: 'Send ships' },
  {
    action: 'send',
    keys: ['Enter'],
    onStage: true,
    shown: 'Enter',
    text: 'Send the selected ships to the cross',
    group: 'Send ships',
  },
  {
    action: 'left',
    keys: ['ArrowLeft'],
    onStage: true,
    shown: 'Arrows',
    text: 'On the stage: move the cross, or the view',
    group: 'Look',
  },
  { action: 'right', keys: ['ArrowRight'], onStage: true, shown: '', text: '', group: 'Look' },
  { action: 'up', keys: ['ArrowUp'], onStage: true, shown: '', text: '', group: 'Look' },
  { action: 'down', keys: ['ArrowDown'], onStage: true, shown: '', text: '', group: 'Look' },
  { action: 'zoom-in', keys: ['+', '='], shown: '+', text: 'Zoom in', group: 'Look' },
  { action: 'zoom-out', keys: ['-', '_'], shown: '−', text: 'Zoom out', group: 'Look' },
  { action: 'fit', keys: ['f', '0'], shown: 'F or 0', text: 'Show all bodies', group: 'Look' },
  { action: 'help', keys: ['?'], shown: '?', text: 'This page', group: 'Look' },
];

/** What the pointer does on the stage; only for the dialog. */
export const POINTER: readonly { shown: string; text: string }[] = [
  { shown: 'Click a body', text: 'Select it alone' },
  { shown: 'Shift or Ctrl, click', text: 'Select it as well, or no longer' },
  { shown: 'Long touch', text: 'The same on a touch screen' },
  { shown: 'Click empty space', text: 'Send the selected ships there; without ships, select nothing' },
  { shown: 'Drag', text: 'Move the view; two fingers on a touch screen' },
  { shown: 'Wheel or pinch', text: 'Zoom about the pointer' },
];

type Key = Pick<KeyboardEvent, 'key' | 'shiftKey' | 'ctrlKey' | 'metaKey' | 'altKey'>;

/** What this key means here, or null. Keys with Ctrl, Meta or Alt belong to the browser and to assistive technology. */
export function actionOf(event: Key, isOnStage: boolean): ShortcutAction | null {
  if (event.ctrlKey || event.metaKey || event.altKey) return null;
  // With caps lock on, 'N' comes without Shift.
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const found = SHORTCUTS.find(
    ({ keys, shift, onStage }) =>
      keys.includes(key) && (shift === undefined || shift === event.shiftKey) && (!onStage || isOnStage),
  );
  return found?.action ?? null;
}

/** Whether the keys typed into this element are text. */
export function isFormField(element: EventTarget | null): boolean {
  return element instanceof HTMLElement && element.matches('input, textarea, select, [contenteditable]');
}
