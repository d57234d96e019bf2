import { act, render, screen } from '@testing-library/react';
import userEvent from '@testing-library/user-event';
import { beforeEach, expect, it, vi } from 'vitest';
import { bodyId, frame, planet, ship, testRoom } from '../../world/testFrames';
import { World } from '../../world/World';
import { InfoSection } from './InfoSection';
import { Inspector } from './Inspector';

let world: World;

beforeEach(() => {
  // jsdom has no layout; the virtual list asks how high its box is.
  vi.spyOn(HTMLElement.prototype, 'clientHeight', 'get').mockReturnValue(600);
  vi.spyOn(HTMLElement.prototype, 'clientWidth', 'get').mockReturnValue(300);
  world = new World();
});

function show(...bodies: Parameters<typeof frame>[1][]) {
  world.room.set(testRoom);
  world.frames.accept(frame(5, ...bodies), 0);
  const onSelect = vi.fn();
  const onDelete = vi.fn();
  render(<InfoSection world={world} isOffline={false} onSelect={onSelect} onDelete={onDelete} />);
  return { onSelect, onDelete };
}

it('every_body_has_a_card', () => {
  show(planet(1), ship(17, 0, 0, { velocity: { x: 3, y: 4 } }));

  expect(screen.getAllByRole('listitem')).toHaveLength(2);
  expect(screen.getByRole('button', { name: 'Ship 17, mass 12.00, speed 5.00' })).toHaveTextContent('Ship 17');
  expect(screen.getByText('2 bodies')).toBeVisible();
});

it('a_card_selects_its_body_alone_and_with_shift_as_well', async () => {
  const { onSelect } = show(ship(17));
  const user = userEvent.setup();

  await user.click(screen.getByRole('button', { name: /^Ship 17/ }));
  await user.keyboard('{Shift>}');
  await user.click(screen.getByRole('button', { name: /^Ship 17/ }));

  expect(onSelect.mock.calls).toEqual([
    [17, false],
    [17, true],
  ]);
});

it('a_card_shows_that_its_body_is_selected', () => {
  show(ship(17), ship(18));
  act(() => world.selection.only(bodyId(18)));

  expect(screen.getByRole('button', { name: /^Ship 18/, pressed: true })).toBeVisible();
  expect(screen.getByRole('button', { name: /^Ship 17/, pressed: false })).toBeVisible();
});

it('a_card_deletes_its_body', async () => {
  const { onDelete } = show(ship(17));
  await userEvent.click(screen.getByRole('button', { name: 'Delete Ship 17' }));

  expect(onDelete).toHaveBeenCalledExactlyOnceWith(17);
});

it('the_find_box_leaves_what_was_asked_for', async () => {
  show(ship(17), planet(2));
  await userEvent.type(screen.getByRole('searchbox', { name: 'Find by id or type' }), 'pla');

  expect(screen.getAllByRole('listitem')).toHaveLength(1);
  expect(screen.getByText('1 of 2')).toBeVisible();
});

it('the_sort_button_changes_the_order', async () => {
  show(ship(5, 0, 0, { velocity: { x: 9, y: 0 } }), planet(2, 0, 0, { mass: 900 }));
  await userEvent.click(screen.getByRole('button', { name: /Sorted by Speed/ }));

  expect(screen.getAllByRole('listitem')[0]).toHaveTextContent('Planet 2');
});

it('an_empty_world_says_that_it_waits', () => {
  show();
  expect(screen.getByText('Bodies show up here as soon as they exist.')).toBeVisible();
});

it('arrows_walk_through_the_cards', async () => {
  show(ship(1), ship(2), ship(3));
  screen.getByRole('button', { name: /^Ship 1,/ }).focus();
  await userEvent.keyboard('{ArrowDown}');
  await act(() => new Promise(requestAnimationFrame));

  expect(screen.getByRole('button', { name: /^Ship 2,/ })).toHaveFocus();
});

it('the_inspector_shows_the_figures_of_one_ship_and_its_order', () => {
  world.room.set(testRoom);
  world.frames.accept(frame(5, ship(17, 1, 2, { target: { x: 612, y: 208 } })), 0);
  world.selection.only(bodyId(17));
  render(<Inspector world={world} isOffline={false} onDelete={() => {}} />);

  expect(screen.getByRole('heading', { name: 'Ship 17' })).toBeVisible();
  expect(screen.getByText('Seek 612, 208')).toBeVisible();
  expect(screen.queryByRole('textbox')).toBeNull();
});

it('the_inspector_shows_ranges_for_several_bodies', () => {
  world.frames.accept(frame(5, ship(1), ship(2, 0, 0, { mass: 20 })), 0);
  world.selection.only(bodyId(1));
  world.selection.add(bodyId(2));
  render(<Inspector world={world} isOffline={false} onDelete={() => {}} />);

  expect(screen.getByRole('heading', { name: '2 ships' })).toBeVisible();
  expect(screen.getByText('12.00 to 20.00')).toBeVisible();
});

it('following_can_be_switched', async () => {
  world.frames.accept(frame(5, ship(1)), 0);
  world.selection.only(bodyId(1));
  render(<Inspector world={world} isOffline={false} onDelete={() => {}} />);
  await userEvent.click(screen.getByRole('button', { name: 'Follow' }));

  expect(screen.getByRole('button', { name: 'Follow', pressed: true })).toBeVisible();
  expect(world.view.current().follow).toBe(true);
});
