import { render, screen } from '@testing-library/react';
import { beforeEach, expect, it } from 'vitest';
import { ShortcutsDialog } from './ShortcutsDialog';
import { SHORTCUTS } from './shortcuts';

beforeEach(() => {
  // jsdom knows the element but not how to open it.
  HTMLDialogElement.prototype.showModal ??= function showModal(this: HTMLDialogElement) {
    this.open = true;
  };
  HTMLDialogElement.prototype.close ??= function close(this: HTMLDialogElement) {
    this.open = false;
  };
});

it('shows_every_row_of_the_table_and_the_licences', () => {
  render(<ShortcutsDialog isOpen onClose={() => {}} />);

  expect(screen.getByRole('dialog', { name: 'Keyboard and pointer' })).toBeVisible();
  for (const { text } of SHORTCUTS) if (text) expect(screen.getAllByText(text).length).toBeGreaterThan(0);
  expect(screen.getByText(/LGPL 2\.1/)).toBeVisible();
});
