import { readFile } from 'node:fs/promises';
import { createServer, type IncomingMessage, request, type ServerResponse } from 'node:http';
import { connect, type Socket } from 'node:net';
import { extname, join, normalize } from 'node:path';

const DIST = join(import.meta.dirname, '../dist');
const ENDPOINT = '/physics-engine-websocket';

const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.woff2': 'font/woff2',
};

/** As strict as a server should be: the page has to work under it. */
const POLICY =
  "default-src 'self'; style-src 'self' 'unsafe-inline'; connect-src 'self'; img-src 'self' data:; object-src 'none'";

export type PageServer = { readonly url: string; close(): Promise<void> };

type Options = { readonly serverPort: number; readonly refuseWebSockets: boolean };

/**
 * Serves the built page, and hands the endpoint on to the server: the same origin for both, as in production. It goes on
 * when the server dies, as a page that is open does.
 */
export async function servePage({ serverPort, refuseWebSockets }: Options): Promise<PageServer> {
  const sockets = new Set<Socket>();
  const http = createServer((asked, answer) => {
    if (asked.url?.startsWith(ENDPOINT)) forward(asked, answer, serverPort);
    else void serveFile(asked.url ?? '/', answer);
  });
  http.on('connection', (socket) => {
    sockets.add(socket);
    socket.on('close', () => sockets.delete(socket));
  });
  http.on('upgrade', (asked, client: Socket, head) => {
    if (refuseWebSockets) client.end('HTTP/1.1 403 Forbidden\r\nConnection: close\r\n\r\n');
    else tunnel(asked, client, head, serverPort);
  });
  await new Promise<void>((resolve) => http.listen(0, resolve));
  const { port } = http.address() as { port: number };
  return {
    url: `http://localhost:${port}/`,
    close: () =>
      new Promise((resolve) => {
        for (const socket of sockets) socket.destroy();
        http.close(() => resolve());
      }),
  };
}

async function serveFile(url: string, answer: ServerResponse): Promise<void> {
  const path = normalize(new URL(url, 'http://localhost').pathname);
  const file = join(DIST, path === '/' ? 'index.html' : path);
  try {
    const content = await readFile(file);
    answer.writeHead(200, {
      'Content-Type': TYPES[extname(file)] ?? 'application/octet-stream',
      'Content-Security-Policy': POLICY,
    });
    answer.end(content);
  } catch {
    answer.writeHead(404).end();
  }
}

function forward(asked: IncomingMessage, answer: ServerResponse, port: number): void {
  const onward = request({ port, path: asked.url, method: asked.method, headers: asked.headers }, (reply) => {
    answer.writeHead(reply.statusCode ?? 502, reply.headers);
    reply.pipe(answer);
  });
  onward.on('error', () => answer.destroy());
  answer.on('close', () => onward.destroy());
  asked.pipe(onward);
}

function tunnel(asked: IncomingMessage, client: Socket, head: Buffer, port: number): void {
  const server = connect(port, 'localhost', () => {
    const headers: string[] = [];
    for (let i = 0; i < asked.rawHeaders.length; i += 2)
      headers.push(`${asked.rawHeaders[i]}: ${asked.rawHeaders[i + 1]}`);
    server.write(`${asked.method} ${asked.url} HTTP/1.1\r\n${headers.join('\r\n')}\r\n\r\n`);
    server.write(head);
    server.pipe(client).pipe(server);
  });
  const end = () => {
    client.destroy();
    server.destroy();
  };
  server.on('error', end).on('close', end);
  client.on('error', end).on('close', end);
}
