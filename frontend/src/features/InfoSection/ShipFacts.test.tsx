import { render, screen } from '@testing-library/react';
import { beforeEach, expect, it } from 'vitest';
import type { ShipReading } from '../../protocol/messages';
import { asteroid, bodyId, frame, ship, shipReading, testRoom } from '../../world/testFrames';
import { World } from '../../world/World';
import { Inspector } from './Inspector';

let world: World;

const threat = {
  id: bodyId(9),
  timeToContact: 1.52,
  passing: { time: 1.75, gap: 6.25, ship: { x: 107, y: 268 }, body: { x: 124, y: 282 } },
};

beforeEach(() => {
  world = new World();
  world.room.set(testRoom);
  world.frames.accept(frame(5, ship(17), ship(18), asteroid(9)), 0);
  world.selection.only(bodyId(17));
});

function show(reading: ShipReading | null): void {
  world.ship.set(reading);
  render(<Inspector world={world} isOffline={false} onDelete={() => {}} />);
}

/** The value beside a label, as it is read. */
function row(label: string): string | null {
  return screen.getByText(label, { selector: 'dt' }).nextElementSibling?.textContent?.trim() ?? null;
}

it('a_ship_on_its_way_shows_its_course_and_its_thrust_with_units', () => {
  show(shipReading(17));

  expect(row('Course')).toBe('84.0 at 0° u/s');
  expect(row('Thrust')).toBe('120.0 at 270° u/s²');
});

it('a_ship_that_gives_way_shows_for_whom_and_how_they_will_pass', () => {
  show(shipReading(17, { evading: true, threat }));

  expect(row('Detour')).toBe('84.0 at 0° u/s');
  expect(row('Threat')).toBe('Asteroid 9 in 1.5 s');
  expect(row('Passing')).toBe('6.3 u clear in 1.8 s');
});

it('a_ship_at_rest_has_no_direction', () => {
  show(shipReading(17, { course: { x: 0.01, y: 0.02 } }));

  expect(row('Course')).toBe('0 u/s');
});

it('a_contact_that_cannot_be_avoided_is_called_so', () => {
  show(shipReading(17, { threat: { ...threat, passing: { ...threat.passing, gap: -2 } } }));

  expect(row('Passing')).toBe('contact in 1.8 s');
});

it('nobody_in_the_way_and_no_order_are_said_in_words', () => {
  show(shipReading(17));

  expect(row('Order')).toBe('none, it wanders');
  expect(row('Threat')).toBe('nothing in the way');
  expect(screen.queryByText('Passing')).toBeNull();
});

it('where_ships_are_mortal_that_is_said', () => {
  world.room.set({ ...testRoom, ships: 'mortal' });
  show(shipReading(17));

  expect(row('If it hits')).toBe('it is gone');
});

it('a_threat_that_has_gone_meanwhile_is_still_named', () => {
  show(shipReading(17, { threat: { ...threat, id: bodyId(99) } }));

  expect(row('Threat')).toBe('Body 99 in 1.5 s');
});

it('before_the_room_has_told_the_rows_are_there_and_wait', () => {
  show(null);

  expect(row('Course')).toBe('…');
});

it('what_is_told_of_another_ship_is_not_shown', () => {
  show(shipReading(18));

  expect(row('Course')).toBe('…');
});

it('several_ships_have_no_course_in_common', () => {
  world.selection.add(bodyId(18));
  show(shipReading(18));

  expect(screen.queryByText('Course')).toBeNull();
  expect(row('Order')).toBe('none, they wander');
});
