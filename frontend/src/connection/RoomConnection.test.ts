import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { BodyId } from '../protocol/frame';
import { type FakeSocket, fakeSockets } from './FakeSocket';
import { RoomConnection } from './RoomConnection';

const listener = () => ({
  onConnected: vi.fn(),
  onRoom: vi.fn(),
  onFrame: vi.fn(),
  onDiagnostics: vi.fn(),
  onEvents: vi.fn(),
  onShip: vi.fn(),
  onReply: vi.fn(),
  onProblem: vi.fn(),
});

let room: RoomConnection;
let heard: ReturnType<typeof listener>;
let sockets: FakeSocket[];

beforeEach(() => {
  vi.useFakeTimers();
  const fake = fakeSockets();
  sockets = fake.sockets;
  heard = listener();
  room = new RoomConnection(heard, fake.open);
});

afterEach(() => {
  room.close();
  vi.useRealTimers();
});

const passes = (ms: number) => vi.advanceTimersByTimeAsync(ms);
const newest = () => sockets.at(-1)!;

async function connect(): Promise<void> {
  room.open();
  await passes(1);
  newest().accept();
  await passes(1);
}

const frameHeaders = { tick: 5, time: 0.5, sent: 1000, speed: 1 };

describe('a room that answers', () => {
  it('is_live_and_subscribed_to_everything', async () => {
    await connect();

    expect(room.link().state).toBe('live');
    expect(heard.onConnected).toHaveBeenCalledOnce();
    for (const destination of ['/topic/bodies', '/topic/diagnostics', '/app/room']) {
      expect(newest().subscription(destination)).toBeDefined();
    }
    expect(newest().subscription('/user/queue/errors')).toBeDefined();
    expect(newest().subscription('/user/queue/replies')).toBeDefined();
  });

  it('hands_on_frames_with_their_headers', async () => {
    await connect();
    newest().message('/topic/bodies', [], frameHeaders);
    await passes(20);

    expect(heard.onFrame).toHaveBeenCalledWith({ ...frameHeaders, bodies: [] }, expect.any(Number));
  });

  it('measures_how_many_frames_really_arrive', async () => {
    await connect();
    for (let i = 0; i < 30; i++) newest().message('/topic/bodies', [], frameHeaders);
    await passes(1000);

    expect(room.link()).toMatchObject({ state: 'live', hz: expect.closeTo(30, 0) });
  });

  it('skips_a_message_that_breaks_the_treaty_and_stays_live', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    await connect();
    newest().message('/topic/bodies', '[{"id":"no"}]', frameHeaders);
    await passes(20);

    expect(heard.onFrame).not.toHaveBeenCalled();
    expect(warn).toHaveBeenCalledOnce();
    expect(room.link().state).toBe('live');
  });

  it('sends_commands', async () => {
    await connect();

    expect(room.send({ type: 'delete-body', id: 17 as BodyId })).toBe(true);
    expect(newest().sentTo('/app/delete-body')).toEqual(['{"id":17}']);
  });

  it('tells_why_the_server_ends_the_session', async () => {
    await connect();
    newest().receive('ERROR\nmessage:x\n\n{"code":"MESSAGE_TOO_LARGE","message":"Too large.","field":null}\0');

    expect(heard.onProblem).toHaveBeenCalledWith({ code: 'MESSAGE_TOO_LARGE', message: 'Too large.', field: null });
  });
});

describe('a link that breaks', () => {
  it('shows_offline_while_the_connection_is_down', async () => {
    await connect();
    newest().fail();

    expect(room.link()).toMatchObject({ state: 'disconnected', hadLink: true, retryAtMs: expect.any(Number) });
    expect(room.send({ type: 'random-planet' })).toBe(false);
  });

  it('comes_back_by_itself_within_two_seconds_of_the_server', async () => {
    await connect();
    for (let i = 0; i < 20; i++) {
      newest().fail();
      await passes(1500);
    }
    const before = sockets.length;
    newest().fail();
    await passes(1500);

    expect(sockets.length).toBe(before + 1);
    newest().accept();
    expect(room.link().state).toBe('live');
  });

  it('waits_longer_with_every_failure', async () => {
    await connect();
    newest().fail();
    const first = waitOf();
    await passes(500);
    newest().fail();

    expect(waitOf()).toBeGreaterThan(first);
  });

  it('tries_at_once_when_asked_to', async () => {
    await connect();
    newest().fail();
    room.tryNow();
    await passes(0);

    expect(sockets.length).toBe(2);
    expect(room.link()).toMatchObject({ state: 'disconnected', retryAtMs: null });
  });

  it('ignores_what_comes_late_from_the_old_socket', async () => {
    await connect();
    const old = newest();
    old.fail();
    await passes(2000);
    newest().accept();
    old.message('/topic/bodies', [], frameHeaders);
    await passes(20);

    expect(heard.onFrame).not.toHaveBeenCalled();
    expect(room.link().state).toBe('live');
  });

  it('gives_up_an_attempt_that_nobody_answers', async () => {
    room.open();
    await passes(1);
    await passes(7000);

    expect(sockets.length).toBeGreaterThan(1);
  });

  function waitOf(): number {
    const link = room.link();
    return link.state === 'disconnected' ? link.retryAtMs! - Date.now() : 0;
  }
});

describe('a network without web sockets', () => {
  it('falls_back_to_sockjs_after_two_refusals_and_stays_with_it', async () => {
    room.open();
    await passes(1);
    for (let i = 0; i < 2; i++) {
      newest().fail();
      await passes(1600);
    }
    expect(sockets.map((socket) => socket.transport)).toEqual(['native', 'native', 'sockjs']);

    newest().accept();
    newest().fail();
    await passes(600);
    expect(newest().transport).toBe('sockjs');
  });

  it('never_falls_back_once_a_web_socket_has_worked', async () => {
    await connect();
    for (let i = 0; i < 5; i++) {
      newest().fail();
      await passes(1600);
    }

    expect(new Set(sockets.map((socket) => socket.transport))).toEqual(new Set(['native']));
  });
});

it('a_closed_connection_stays_closed', async () => {
  await connect();
  room.close();
  await passes(20_000);

  expect(sockets.length).toBe(1);
});
