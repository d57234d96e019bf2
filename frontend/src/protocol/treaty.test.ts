import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { encode } from './commands';
import { decodeDiagnostics, decodeEvents, decodeProblem, decodeReply, decodeRoom, decodeShip } from './decode';
import { decodeFrame } from './decodeFrame';
import type { BodyId } from './frame';

const folder = join(import.meta.dirname, '../../../docs/protocol/messages');
const golden = (name: string) => readFileSync(join(folder, name), 'utf8');
const parsed = (name: string): unknown => JSON.parse(golden(name));
const headers = { tick: '19260', time: '128.4', sent: '1790000000000', speed: '1.0' };
const id = 17 as BodyId;

/** Every golden message and what proves that we speak it. A new message without an entry fails the last test. */
const proofs: Record<string, () => void> = {
  'bodies.json': () => {
    const frame = decodeFrame(golden('bodies.json'), headers);
    expect(frame.bodies).toEqual(parsed('bodies.json'));
    expect(frame).toMatchObject({ tick: 19260, time: 128.4, sent: 1790000000000, speed: 1 });
  },
  'diagnostics.json': () => expect(decodeDiagnostics(golden('diagnostics.json'))).toEqual(parsed('diagnostics.json')),
  'room.json': () => expect(decodeRoom(golden('room.json'))).toEqual(parsed('room.json')),
  'reply.json': () => expect(decodeReply(golden('reply.json'))).toEqual(parsed('reply.json')),
  'problem.json': () => expect(decodeProblem(golden('problem.json'))).toEqual(parsed('problem.json')),
  'events.json': () => expect(decodeEvents(golden('events.json'))).toEqual(parsed('events.json')),
  'ship.json': () => expect(decodeShip(golden('ship.json'))).toEqual(parsed('ship.json')),
  'select-body.json': () => {
    const send = encode({ type: 'select-body', id, selected: true });
    expect(JSON.parse(send.body)).toEqual(parsed('select-body.json'));
    expect(send.destination).toBe('/app/select-body');
  },
  'delete-body.json': () => {
    const send = encode({ type: 'delete-body', id });
    expect(JSON.parse(send.body)).toEqual(parsed('delete-body.json'));
    expect(send.destination).toBe('/app/delete-body');
  },
  'move-selected-spaceships.json': () => {
    const send = encode({ type: 'move-selected-spaceships', x: 612, y: 208 });
    expect(JSON.parse(send.body)).toEqual(parsed('move-selected-spaceships.json'));
    expect(send.destination).toBe('/app/move-selected-spaceships');
  },
};

describe('the treaty', () => {
  it.each(Object.entries(proofs))('speaks_the_golden_message_%s', (_name, proof) => proof());

  it('covers_every_golden_message', () => {
    expect(readdirSync(folder).sort()).toEqual(Object.keys(proofs).sort());
  });

  it.each(['random-planet', 'random-asteroid', 'random-spaceship', 'random-body'] as const)(
    '%s_has_no_body',
    (type) => {
      expect(encode({ type })).toEqual({ destination: `/app/${type}`, body: '' });
    },
  );
});

describe('a message that breaks the treaty', () => {
  const body = (change: object) => JSON.stringify([{ ...JSON.parse(golden('bodies.json'))[2], ...change }]);

  it.each([
    ['not_json', '[{'],
    ['not_an_array', '{}'],
    ['an_unknown_kind', body({ kind: 'comet' })],
    ['a_missing_position', body({ position: undefined })],
    ['a_text_for_a_number', body({ mass: '12' })],
    ['an_infinite_number', body({}).replace('"mass":12', '"mass":1e999')],
    ['an_id_of_zero', body({ id: 0 })],
    ['a_half_target', body({ target: { x: 1 } })],
    ['an_asteroid_without_outline', body({ kind: 'asteroid', angle: 0 })],
  ])('%s_is_rejected', (_name, text) => {
    expect(() => decodeFrame(text, headers)).toThrow(/must be/);
  });

  it('a_frame_without_its_tick_is_rejected', () => {
    expect(() => decodeFrame('[]', { ...headers, tick: undefined })).toThrow('header tick must be a number');
  });

  it('a_room_with_an_unknown_edge_is_rejected', () => {
    expect(() => decodeRoom(golden('room.json').replace('walls', 'torus'))).toThrow('was torus');
  });

  const reading = (change: object) => JSON.stringify({ ...JSON.parse(golden('ship.json')), ...change });

  it.each([
    ['without_a_course', reading({ course: null })],
    ['evading_by_halves', reading({ evading: 0.5 })],
    ['with_the_id_of_nobody', reading({ id: 0 })],
    ['with_half_a_threat', reading({ threat: { id: 9, timeToContact: 1 } })],
  ])('a_ship_%s_is_rejected', (_name, text) => {
    expect(() => decodeShip(text)).toThrow(/must be/);
  });

  it.each([
    ['of_an_unknown_type', golden('events.json').replace('"collided"', '"vanished"')],
    ['with_a_comet', golden('events.json').replace('"asteroid"', '"comet"')],
    ['of_no_ship', golden('events.json').replace('"ship": 21', '"ship": "21"')],
  ])('an_event_%s_is_rejected', (_name, text) => {
    expect(() => decodeEvents(text)).toThrow(/must be/);
  });

  it('a_ship_that_wanders_unthreatened_has_neither_target_nor_threat', () => {
    expect(decodeShip(reading({ target: null, threat: null }))).toMatchObject({ target: null, threat: null });
  });

  it('a_scene_that_does_not_ask_for_energy_gives_null', () => {
    const text = golden('diagnostics.json').replace('-125000.5', 'null');
    expect(decodeDiagnostics(text).energy).toBeNull();
  });
});
