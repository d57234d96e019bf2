import type { IStompSocket } from '@stomp/stompjs';
import type { OpenSocket, Tap, Transport } from './socket';

/** One end of a WebSocket whose other end is a test that speaks STOMP. */
export class FakeSocket implements IStompSocket {
  readonly url = 'ws://test';
  readyState = 0;
  binaryType: 'arraybuffer' = 'arraybuffer';
  onopen: ((event?: unknown) => unknown) | null = null;
  onclose: ((event?: unknown) => unknown) | null = null;
  onerror: ((event?: unknown) => unknown) | null = null;
  onmessage: ((event?: unknown) => unknown) | null = null;
  /** Frames that the client sent, without heart-beats. */
  readonly sent: string[] = [];
  readonly transport: Transport;
  readonly #tap: Tap;

  constructor(transport: Transport, tap: Tap) {
    this.transport = transport;
    this.#tap = tap;
  }

  send(data: string): void {
    if (data.trim() !== '') this.sent.push(data);
  }

  close(): void {
    this.fail();
  }

  /** The server accepts the client. */
  accept(): void {
    this.readyState = 1;
    this.onopen?.({});
    this.receive('CONNECTED\nversion:1.2\n\n\0');
  }

  /** The link breaks, or never came to be. */
  fail(): void {
    if (this.readyState === 3) return;
    this.readyState = 3;
    this.onclose?.({ code: 1006 });
  }

  /** A message of the server to a destination that the client has subscribed to. */
  message(destination: string, body: unknown, headers: Record<string, string | number> = {}): void {
    const extra = Object.entries(headers).map(([key, value]) => `${key}:${value}\n`);
    const subscription = this.subscription(destination);
    const head = `MESSAGE\ndestination:${destination}\nsubscription:${subscription}\nmessage-id:1\n${extra.join('')}`;
    this.receive(`${head}\n${typeof body === 'string' ? body : JSON.stringify(body)}\0`);
  }

  receive(data: string): void {
    if (!this.#tap(data)) this.onmessage?.({ data });
  }

  subscription(destination: string): string | undefined {
    const frame = this.sent.find(
      (text) => text.startsWith('SUBSCRIBE') && text.includes(`destination:${destination}\n`),
    );
    return frame && /^id:(.*)$/m.exec(frame)?.[1];
  }

  /** Bodies of what was sent to a destination. */
  sentTo(destination: string): string[] {
    return this.sent
      .filter((text) => text.startsWith('SEND') && text.includes(`destination:${destination}\n`))
      .map((text) => text.slice(text.indexOf('\n\n') + 2).replace('\0', ''));
  }
}

/** Opens fake sockets and keeps them in order. */
export function fakeSockets(): { sockets: FakeSocket[]; open: OpenSocket } {
  const sockets: FakeSocket[] = [];
  return {
    sockets,
    open: async (_path, transport, tap) => {
      const socket = new FakeSocket(transport, tap);
      sockets.push(socket);
      return socket as IStompSocket;
    },
  };
}
