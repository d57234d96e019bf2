import { Client, type IMessage } from '@stomp/stompjs';
import { type ClientMessage, encode } from '../protocol/commands';
import {
  decodeDiagnostics,
  decodeEvents,
  decodeProblem,
  decodeReply,
  decodeRoom,
  decodeShip,
} from '../protocol/decode';
import { decodeFrame } from '../protocol/decodeFrame';
import type { Frame } from '../protocol/frame';
import type { Diagnostics, Problem, Reply, Room, ShipEvents, ShipReading } from '../protocol/messages';
import { backoffMs } from './backoff';
import type { Link } from './link';
import { DelayMeter, RateMeter } from './meters';
import { NewestOnly } from './NewestOnly';
import { type OpenSocket, openSocket, type Transport } from './socket';
import { type StompMessage, splitMessage } from './stompMessage';

const PATH = '/physics-engine-websocket';
const BODIES = '/topic/bodies';
const HEARTBEAT_MS = 10_000;
const CONNECT_TIMEOUT_MS = 5000;
/** After so many refused WebSockets on a page that did load, every second attempt is by SockJS. */
const REFUSED_BEFORE_FALLBACK = 2;

type Arrival = { readonly message: StompMessage; readonly atMs: number };

/** What a room tells its client. */
export type RoomListener = {
  /** The link stands; frames of a possibly new room follow. */
  onConnected(): void;
  onRoom(room: Room): void;
  /** `atMs` is performance.now() of its arrival. */
  onFrame(frame: Frame, atMs: number): void;
  onDiagnostics(diagnostics: Diagnostics): void;
  onEvents(events: ShipEvents): void;
  onShip(ship: ShipReading): void;
  onReply(reply: Reply): void;
  onProblem(problem: Problem): void;
};

/**
 * The link to one room: connects, subscribes, sends, comes back by itself, and says how it is doing.
 *
 * Each attempt has a STOMP client of its own. stompjs can reconnect by itself, but does not tell when it will try again,
 * and the page has to say so.
 */
export class RoomConnection {
  readonly #listener: RoomListener;
  readonly #open: OpenSocket;
  readonly #watchers = new Set<() => void>();
  #link: Link = { state: 'connecting' };
  #client: Client | null = null;
  #attempt = 0;
  #failures = 0;
  #lastGood: Transport | null = null;
  #retry: ReturnType<typeof setTimeout> | undefined;
  #report: ReturnType<typeof setInterval> | undefined;
  #rates = new RateMeter(0);
  #delay = new DelayMeter();
  readonly #frames = new NewestOnly<Arrival>((arrival) => this.#tell(() => this.#frame(arrival)));

  constructor(listener: RoomListener, open: OpenSocket = openSocket) {
    this.#listener = listener;
    this.#open = open;
  }

  /** The same object until something changes, as useSyncExternalStore wants it. */
  readonly link = (): Link => this.#link;

  readonly subscribe = (watcher: () => void): (() => void) => {
    this.#watchers.add(watcher);
    return () => this.#watchers.delete(watcher);
  };

  open(): void {
    window.addEventListener('online', this.tryNow);
    document.addEventListener('visibilitychange', this.#seen);
    // A task later, because StrictMode opens, closes and opens again.
    this.#retry = setTimeout(() => void this.#connect(), 0);
  }

  close(): void {
    window.removeEventListener('online', this.tryNow);
    document.removeEventListener('visibilitychange', this.#seen);
    this.#drop();
  }

  /** Sends a command; false when there is no link to send it over. */
  send(message: ClientMessage): boolean {
    if (this.#link.state !== 'live' || !this.#client?.connected) return false;
    this.#client.publish(encode(message));
    return true;
  }

  /** Ends the waiting, if we wait. */
  readonly tryNow = (): void => {
    if (this.#link.state === 'disconnected' && this.#link.retryAtMs !== null) void this.#connect();
  };

  readonly #seen = (): void => {
    if (document.visibilityState === 'visible') this.tryNow();
  };

  async #connect(): Promise<void> {
    this.#drop();
    const attempt = this.#attempt;
    if (this.#link.state === 'disconnected') this.#become({ ...this.#link, retryAtMs: null });
    const transport = this.#transport();
    try {
      const socket = await this.#open(PATH, transport, (data) => attempt === this.#attempt && this.#tap(data));
      if (attempt !== this.#attempt) return socket.close();
      this.#client = this.#clientFor(attempt, transport, () => socket);
      this.#client.activate();
    } catch {
      // The fallback itself could not be loaded, because the server is away.
      this.#lost(attempt);
    }
  }

  #clientFor(attempt: number, transport: Transport, webSocketFactory: Client['webSocketFactory'] & object): Client {
    return new Client({
      webSocketFactory,
      reconnectDelay: 0,
      connectionTimeout: CONNECT_TIMEOUT_MS,
      heartbeatIncoming: HEARTBEAT_MS,
      heartbeatOutgoing: HEARTBEAT_MS,
      discardWebsocketOnCommFailure: true,
      onConnect: () => attempt === this.#attempt && this.#connected(attempt, transport),
      onWebSocketClose: () => this.#lost(attempt),
      onStompError: (frame) => this.#tell(() => this.#listener.onProblem(decodeProblem(frame.body))),
    });
  }

  #transport(): Transport {
    if (this.#lastGood) return this.#lastGood;
    return this.#failures >= REFUSED_BEFORE_FALLBACK && this.#failures % 2 === 0 ? 'sockjs' : 'native';
  }

  #connected(attempt: number, transport: Transport): void {
    const client = this.#client!;
    const askedMs = performance.now();
    this.#lastGood = transport;
    this.#failures = 0;
    this.#rates = new RateMeter(performance.now());
    this.#delay = new DelayMeter();
    this.#listener.onConnected();
    const hear = (destination: string, deliver: (message: IMessage) => void) =>
      client.subscribe(destination, (message) => {
        if (attempt === this.#attempt) this.#tell(() => deliver(message));
      });
    hear('/user/queue/errors', ({ body }) => this.#listener.onProblem(decodeProblem(body)));
    hear('/user/queue/replies', ({ body }) => this.#listener.onReply(decodeReply(body)));
    hear('/app/room', ({ body }) => {
      this.#delay.roundTrip(performance.now() - askedMs);
      this.#listener.onRoom(decodeRoom(body));
    });
    hear('/topic/diagnostics', ({ body }) => this.#listener.onDiagnostics(decodeDiagnostics(body)));
    hear('/topic/events', ({ body }) => this.#listener.onEvents(decodeEvents(body)));
    hear('/user/queue/ship', ({ body }) => this.#listener.onShip(decodeShip(body)));
    hear(BODIES, (message) => this.#arrived(message));
    this.#become({ state: 'live', hz: 0, delayMs: 0, bytesPerSecond: 0 });
    this.#report = setInterval(() => this.#measure(), 1000);
  }

  #tap(data: unknown): boolean {
    // SockJS hands in the size alone.
    this.#rates.countBytes(typeof data === 'number' ? data : sizeOf(data));
    const message = splitMessage(data, BODIES);
    if (message) this.#arrived(message);
    return message !== null;
  }

  #arrived(message: StompMessage): void {
    this.#rates.countFrame();
    this.#delay.arrived(Date.now(), Number(message.headers.sent));
    this.#frames.put({ message, atMs: performance.now() });
  }

  #frame({ message, atMs }: Arrival): void {
    this.#listener.onFrame(decodeFrame(message.body, message.headers), atMs);
  }

  /** A message that breaks the treaty is reported and skipped; the link stays. */
  #tell(deliver: () => void): void {
    try {
      deliver();
    } catch (error) {
      console.warn('A message from the server was skipped:', error);
    }
  }

  #measure(): void {
    const { hz, bytesPerSecond } = this.#rates.take(performance.now());
    this.#become({ state: 'live', hz, delayMs: this.#delay.delayMs(), bytesPerSecond });
  }

  #lost(attempt: number): void {
    if (attempt !== this.#attempt) return;
    this.#drop();
    this.#failures++;
    const waitMs = backoffMs(this.#failures, document.visibilityState === 'hidden', Math.random());
    this.#retry = setTimeout(() => void this.#connect(), waitMs);
    this.#become({ state: 'disconnected', hadLink: this.#lastGood !== null, retryAtMs: Date.now() + waitMs });
  }

  /** Ends the running attempt; whatever still comes from it is ignored by its number. */
  #drop(): void {
    this.#attempt++;
    clearTimeout(this.#retry);
    clearInterval(this.#report);
    this.#frames.drop();
    void this.#client?.deactivate({ force: true });
    this.#client = null;
  }

  #become(link: Link): void {
    this.#link = link;
    for (const watcher of this.#watchers) watcher();
  }
}

function sizeOf(data: unknown): number {
  if (typeof data === 'string') return data.length;
  return data instanceof ArrayBuffer ? data.byteLength : 0;
}
