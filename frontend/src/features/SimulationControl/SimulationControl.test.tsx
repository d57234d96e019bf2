import { render, screen } from '@testing-library/react';
import userEvent from '@testing-library/user-event';
import { expect, it, vi } from 'vitest';
import { SimulationControl } from './SimulationControl';

function show(isOffline = false) {
  const onAdd = vi.fn();
  const onSelectTool = vi.fn();
  render(<SimulationControl isOffline={isOffline} isAiming={false} onAdd={onAdd} onSelectTool={onSelectTool} />);
  return { onAdd, onSelectTool };
}

it.each([
  ['Add planet', 'random-planet'],
  ['Add asteroid', 'random-asteroid'],
  ['Add ship', 'random-spaceship'],
  ['Add random', 'random-body'],
])('%s_asks_for_a_%s', async (name, type) => {
  const { onAdd } = show();

  await userEvent.click(screen.getByRole('button', { name }));

  expect(onAdd).toHaveBeenCalledExactlyOnceWith(type);
});

it('nothing_can_be_added_while_the_connection_is_down', () => {
  show(true);

  for (const button of screen.getAllByRole('button', { name: /^Add/ })) expect(button).toBeDisabled();
});
