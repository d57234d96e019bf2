import { render, screen } from '@testing-library/react';
import userEvent from '@testing-library/user-event';
import { expect, it, vi } from 'vitest';
import { LinkState } from './LinkState';
import { LinkStrip } from './LinkStrip';

it('shows_offline_while_the_connection_is_down', async () => {
  const onTryNow = vi.fn();
  const link = { state: 'disconnected', hadLink: true, retryAtMs: Date.now() + 3900 } as const;
  render(<LinkStrip link={link} frameAtMs={Date.now() - 5900} onTryNow={onTryNow} />);

  expect(screen.getByRole('alert')).toHaveTextContent('Connection lost.');
  expect(screen.getByText(/You see the last frame, 6 s old\. Trying again in 4 s\./)).toBeVisible();
  await userEvent.click(screen.getByRole('button', { name: 'Try now' }));
  expect(onTryNow).toHaveBeenCalledOnce();
});

it('says_nothing_of_a_last_frame_where_there_was_none', () => {
  render(
    <LinkStrip link={{ state: 'disconnected', hadLink: false, retryAtMs: null }} frameAtMs={null} onTryNow={vi.fn()} />,
  );

  expect(screen.getByRole('alert')).toHaveTextContent('No connection yet.');
  expect(screen.queryByText(/last frame/)).toBeNull();
  expect(screen.getByRole('button', { name: 'Try now' })).toBeDisabled();
});

it.each([
  [{ state: 'live', hz: 29.8, delayMs: 18, bytesPerSecond: 1 } as const, 'Live, 30 Hz'],
  [{ state: 'live', hz: 30, delayMs: 240, bytesPerSecond: 1 } as const, 'Delay 240 ms'],
  [{ state: 'connecting' } as const, 'Connecting'],
  [{ state: 'disconnected', hadLink: true, retryAtMs: null } as const, 'Disconnected'],
])('a_link_that_is_%o_reads_%s', (link, text) => {
  render(<LinkState link={link} />);
  expect(screen.getByText(text)).toBeVisible();
});
