import type { IStompSocket } from '@stomp/stompjs';

export type Transport = 'native' | 'sockjs';

/** Sees every message before the STOMP parser does; answers true when it has dealt with it. */
export type Tap = (data: unknown) => boolean;

/** Opens one socket. Replaced in tests. */
export type OpenSocket = (path: string, transport: Transport, tap: Tap) => Promise<IStompSocket>;

const STOMP_VERSIONS = ['v12.stomp', 'v11.stomp', 'v10.stomp'];
const HEARTBEAT_MS = 8000;

export const openSocket: OpenSocket = (path, transport, tap) =>
  transport === 'native' ? Promise.resolve(openNative(path, tap)) : openSockJs(path, tap);

function openNative(path: string, tap: Tap): IStompSocket {
  const url = new URL(path, window.location.href);
  url.protocol = url.protocol === 'https:' ? 'wss:' : 'ws:';
  const socket = new WebSocket(url, STOMP_VERSIONS);
  let beatAtMs = Date.now();
  // Registered before stompjs sets onmessage, therefore called first.
  socket.addEventListener('message', (event) => {
    if (tap(event.data)) event.stopImmediatePropagation();
    // Timers of a hidden tab may run once a minute, messages always run: they keep our heart-beat going.
    if (Date.now() - beatAtMs > HEARTBEAT_MS) {
      beatAtMs = Date.now();
      socket.send('\n');
    }
  });
  return socket as unknown as IStompSocket;
}

/** Loaded only when a WebSocket cannot be opened: 14 kB that almost nobody needs. */
async function openSockJs(path: string, tap: Tap): Promise<IStompSocket> {
  const { default: SockJS } = await import('sockjs-client');
  const transports = ['xhr-streaming', 'xhr-polling'];
  const socket = new SockJS(new URL(path, window.location.href).href, null, { transports });
  // SockJS calls onmessage before listeners, so here the tap only counts.
  socket.addEventListener('message', (event) => tap((event as MessageEvent).data.length));
  return socket as unknown as IStompSocket;
}
