import { act, render, screen } from '@testing-library/react';
import userEvent from '@testing-library/user-event';
import { expect, it } from 'vitest';
import { bodyId, frame, planet, ship, testRoom } from '../../world/testFrames';
import { World } from '../../world/World';
import { EventList } from './EventList';
import { OrderHint } from './OrderHint';
import { Problems } from './Problems';
import { ViewSwitches } from './ViewSwitches';

it.each([
  ['Trails', 'trails', false],
  ['Velocity', 'velocity', false],
  ['Force', 'force', true],
  ['Plan', 'plan', false],
  ['Grid', 'grid', false],
] as const)('%s_can_be_switched', async (name, option, after) => {
  const world = new World();
  render(<ViewSwitches world={world} />);

  await userEvent.click(screen.getByRole('button', { name }));

  expect(world.view.current()[option]).toBe(after);
  expect(screen.getByRole('button', { name })).toHaveAttribute('aria-pressed', String(after));
});

it('the_hint_speaks_only_while_there_is_a_ship_to_send', () => {
  const world = new World();
  world.frames.accept(frame(5, ship(1), planet(2)), 0);
  render(<OrderHint world={world} />);
  expect(screen.queryByText(/empty space/)).toBeNull();

  act(() => world.selection.only(bodyId(2)));
  expect(screen.queryByText(/empty space/)).toBeNull();

  act(() => world.selection.add(bodyId(1)));
  expect(screen.getByText(/empty space to send/)).toHaveTextContent('Click empty space to send 1 ship there');
});

it('events_are_listed_in_words_with_the_speed_of_a_crash', () => {
  const world = new World();
  world.room.set(testRoom);
  render(<EventList world={world} />);
  expect(screen.getByRole('log', { name: 'Events' })).toBeEmptyDOMElement();

  const arrived = { number: 1, tick: 5, time: 0, type: 'arrived', ship: bodyId(17), other: null, speed: null } as const;
  const other = { id: bodyId(9), kind: 'asteroid' } as const;
  const events = [arrived, { ...arrived, number: 2, type: 'collided', other, speed: 12.5 } as const];
  act(() => void world.events.take({ tick: 6, unlisted: 0, events }));

  expect(screen.getByText('Ship 17 has arrived')).toBeVisible();
  expect(screen.getByText('Ship 17 hit Asteroid 9')).toHaveTextContent('12.50 u/s');
});

it('a_problem_is_said_at_once_and_can_be_dismissed', async () => {
  const world = new World();
  render(<Problems world={world} />);
  act(() => world.notices.problem('There is no room for another planet here.'));
  expect(screen.getByRole('alert')).toHaveTextContent('There is no room for another planet here.');

  await userEvent.click(screen.getByRole('button', { name: 'Dismiss' }));
  expect(screen.getByRole('alert')).toBeEmptyDOMElement();
});
