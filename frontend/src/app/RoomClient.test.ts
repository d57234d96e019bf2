import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { type FakeSocket, fakeSockets } from '../connection/FakeSocket';
import type { BodyState } from '../protocol/frame';
import { asteroid, bodyId, planet, ship, shipReading } from '../world/testFrames';
import { RoomClient } from './RoomClient';

const golden = join(import.meta.dirname, '../../../docs/protocol/messages');
const roomMessage = readFileSync(join(golden, 'room.json'), 'utf8');

let client: RoomClient;
let sockets: FakeSocket[];

beforeEach(async () => {
  vi.useFakeTimers();
  const fake = fakeSockets();
  sockets = fake.sockets;
  client = new RoomClient(fake.open);
  client.connection.open();
  await accept();
});

afterEach(() => {
  client.connection.close();
  vi.useRealTimers();
});

const server = () => sockets.at(-1)!;

async function accept(): Promise<void> {
  await vi.advanceTimersByTimeAsync(1600);
  server().accept();
  server().message('/app/room', roomMessage);
}

function shows(tick: number, ...bodies: BodyState[]): void {
  server().message('/topic/bodies', bodies, { tick, time: tick / 150, sent: 0, speed: 1 });
  vi.advanceTimersByTime(20);
}

const selected = () =>
  server()
    .sentTo('/app/select-body')
    .map((body) => JSON.parse(body));

describe('selecting', () => {
  it('tells_the_room_what_is_selected_and_what_no_longer', () => {
    shows(5, ship(1), ship(2));
    client.select(bodyId(1), false);
    client.select(bodyId(2), false);

    expect(selected()).toEqual([
      { id: 1, selected: true },
      { id: 1, selected: false },
      { id: 2, selected: true },
    ]);
  });

  it('after_a_reconnect_the_new_session_is_told_of_what_still_exists', async () => {
    shows(5, ship(1), ship(2));
    client.select(bodyId(1), false);
    client.select(bodyId(2), true);
    server().fail();
    await accept();
    expect(selected()).toEqual([]);

    shows(10, ship(2));

    expect(selected()).toEqual([{ id: 2, selected: true }]);
    expect(client.world.selection.ids()).toEqual([2]);
  });

  it('a_large_selection_is_told_in_portions', async () => {
    const ships = Array.from({ length: 120 }, (_, i) => ship(i + 1));
    shows(5, ...ships);
    for (const { id } of ships) client.world.selection.add(id);
    server().fail();
    await accept();
    shows(10, ...ships);

    expect(selected().length).toBe(50);
    await vi.advanceTimersByTimeAsync(3000);
    expect(selected().length).toBe(120);
  });

  it('a_body_that_is_deleted_leaves_the_selection', () => {
    shows(5, ship(1), ship(2));
    client.select(bodyId(1), false);
    shows(10, ship(2));

    expect(client.world.selection.ids()).toEqual([]);
  });
});

describe('the ship selected last', () => {
  it('is_shown_while_it_is_that', () => {
    shows(5, ship(1), ship(2));
    client.select(bodyId(1), false);
    server().message('/user/queue/ship', shipReading(1));
    expect(client.world.mainShip()).toMatchObject({ id: 1, course: { x: 84, y: 0 } });

    client.select(bodyId(2), true);
    expect(client.world.mainShip()).toBeNull();
  });

  it('is_forgotten_when_it_no_longer_exists', () => {
    shows(5, ship(1));
    client.select(bodyId(1), false);
    server().message('/user/queue/ship', shipReading(1));
    shows(10, ship(2));

    expect(client.world.ship.current()).toBeNull();
  });

  it('is_asked_for_anew_after_a_reconnect', async () => {
    shows(5, ship(1));
    client.select(bodyId(1), false);
    server().message('/user/queue/ship', shipReading(1));
    server().fail();
    await accept();

    expect(client.world.mainShip()).toBeNull();
    expect(server().subscription('/user/queue/ship')).toBeDefined();
  });
});

describe('events', () => {
  const tell = (...events: object[]) =>
    server().message('/topic/events', { tick: 20, unlisted: 0, events: events.map((e) => ({ ...event, ...e })) });
  const event = { number: 1, tick: 10, time: 0, type: 'arrived', ship: 1, other: null, speed: null };
  const crash = { type: 'destroyed', other: { id: 9, kind: 'asteroid' }, speed: 50 };

  it('are_all_shown_and_one_s_own_are_announced', () => {
    shows(5, ship(1), ship(2));
    client.select(bodyId(1), false);
    tell({ ship: 2 });
    expect(client.world.notices.news()).toBe('');

    tell({ ship: 2 }, { number: 2 });

    expect(client.world.notices.news()).toBe('Ship 1 has arrived');
    expect(client.world.events.recent()).toHaveLength(2);
  });

  it.each(['before', 'after'])('a_selected_ship_that_is_destroyed_is_lamented_when_told_%s_the_frame', (order) => {
    shows(5, ship(1), asteroid(9));
    client.select(bodyId(1), false);
    if (order === 'before') tell(crash);
    shows(10, asteroid(9));
    if (order === 'after') tell(crash);

    expect(client.world.selection.ids()).toEqual([]);
    expect(client.world.notices.problems().map(({ text }) => text)).toEqual([
      'Ship 1 hit Asteroid 9 and is gone. It was selected.',
    ]);
  });

  it('somebody_else_s_loss_is_no_alarm', () => {
    shows(5, ship(1), ship(2), asteroid(9));
    client.select(bodyId(2), false);
    tell(crash);

    expect(client.world.notices.problems()).toEqual([]);
    expect(client.world.events.recent()).toHaveLength(1);
  });

  it('of_a_former_life_of_the_room_are_forgotten', () => {
    shows(5000, ship(1));
    tell({ number: 40 });
    shows(5, ship(1));

    expect(client.world.events.recent()).toEqual([]);
    tell({ number: 1 });
    expect(client.world.events.recent()).toHaveLength(1);
  });
});

describe('orders', () => {
  it('only_selected_ships_are_sent', () => {
    shows(5, ship(1), planet(2));
    client.select(bodyId(2), false);
    client.sendShips({ x: 612, y: 208 });
    expect(server().sentTo('/app/move-selected-spaceships')).toEqual([]);

    client.select(bodyId(1), true);
    client.sendShips({ x: 612, y: 208 });
    expect(server().sentTo('/app/move-selected-spaceships')).toEqual(['{"x":612,"y":208}']);
    expect(client.world.orders.pending(performance.now())).toMatchObject({ ships: [1], isConfirmed: false });
  });

  it('a_refused_order_loses_its_marker_and_says_why', () => {
    shows(5, ship(1));
    client.select(bodyId(1), false);
    client.sendShips({ x: 5000, y: 0 });
    server().message('/user/queue/errors', readFileSync(join(golden, 'problem.json'), 'utf8'));

    expect(client.world.orders.pending(performance.now())).toBeNull();
    expect(client.world.notices.problems()[0]?.text).toContain('lies outside the world');
  });

  it('a_problem_goes_away_by_itself', async () => {
    server().message('/user/queue/errors', { code: 'NO_ROOM', message: 'There is no room.', field: null });
    await vi.advanceTimersByTimeAsync(6100);

    expect(client.world.notices.problems()).toEqual([]);
  });
});

describe('news', () => {
  it('an_added_body_is_announced_and_pointed_out', () => {
    server().message('/user/queue/replies', { command: 'random-planet', ids: [249], tick: 1 });

    expect(client.world.notices.news()).toBe('Added planet 249');
    expect(client.world.fresh.has(bodyId(249))).toBe(true);
  });

  it('a_random_body_is_announced_by_its_kind_once_that_is_known', () => {
    server().message('/user/queue/replies', { command: 'random-body', ids: [7], tick: 1 });
    expect(client.world.notices.news()).toBe('');

    shows(10, asteroid(7));
    expect(client.world.notices.news()).toBe('Added asteroid 7');
  });

  it('a_deleted_body_is_announced_by_its_name', () => {
    shows(5, ship(3));
    client.delete(bodyId(3));
    server().message('/user/queue/replies', { command: 'delete-body', ids: [3], tick: 1 });

    expect(client.world.notices.news()).toBe('Deleted Ship 3');
  });
});

it('a_room_that_begins_anew_takes_trails_and_missing_bodies_with_it', async () => {
  shows(5000, ship(1), ship(2));
  client.select(bodyId(1), false);
  client.select(bodyId(2), true);
  shows(5005, ship(1), ship(2));
  server().fail();
  await accept();
  shows(5, ship(1));

  expect(client.world.selection.ids()).toEqual([1]);
  expect(client.world.trails.of(bodyId(1))?.count).toBe(1);
});

it('a_command_without_a_link_says_so', async () => {
  server().fail();
  client.add('random-spaceship');

  expect(client.world.notices.problems()[0]?.text).toContain('no connection');
});
