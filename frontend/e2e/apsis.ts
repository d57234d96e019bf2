import { type ChildProcess, spawn } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { servePage } from './pageServer';

const READY_WITHIN_MS = 60_000;

/** A running server with its page before it. */
export type Apsis = {
  /** Where the page is. */
  readonly url: string;
  /** Ends the server like a crash; the page stays where it is. */
  kill(): Promise<void>;
  /** Starts it again on the same port. */
  start(): Promise<void>;
  stop(): Promise<void>;
};

type Options = {
  readonly scene: string;
  readonly refuseWebSockets?: boolean;
  /** A page that already runs, named in APSIS_URL, will do; it must show this scene. */
  readonly mayBeShared?: boolean;
};

/**
 * Starts the server on a free port with a scene. Where its jar holds no page, or web sockets are to be refused, the built
 * page in dist is served in front of it.
 */
export async function startApsis({ scene, refuseWebSockets = false, mayBeShared = false }: Options): Promise<Apsis> {
  const nothing = () => Promise.resolve();
  if (mayBeShared && process.env.APSIS_URL) {
    return { url: process.env.APSIS_URL, kill: nothing, start: nothing, stop: nothing };
  }
  const port = await freePort();
  let server: ChildProcess | undefined;

  async function start(): Promise<void> {
    server = spawn(
      process.env.APSIS_JAVA ?? 'java',
      ['-jar', serverJar(), `--server.port=${port}`, `--apsis.scene=${scene}`],
      {
        stdio: ['ignore', 'ignore', 'inherit'],
      },
    );
    await untilUp(port, server);
  }

  async function kill(): Promise<void> {
    if (!server || server.exitCode !== null || server.signalCode !== null) return;
    const gone = new Promise((resolve) => server?.once('exit', resolve));
    server.kill('SIGKILL');
    await gone;
  }

  await start();
  const own = `http://localhost:${port}/`;
  const hasPage = (await fetch(own)).ok;
  const front = hasPage && !refuseWebSockets ? null : await servePage({ serverPort: port, refuseWebSockets });
  return {
    url: front?.url ?? own,
    kill,
    start,
    stop: async () => {
      await kill();
      await front?.close();
    },
  };
}

function serverJar(): string {
  const named = process.env.APSIS_SERVER_JAR;
  if (named) return named;
  const folder = join(import.meta.dirname, '../../backend/server/target');
  const jar = readdirSync(folder).find(
    (name) => /^apsis-server-.*\.jar$/.test(name) && !/plain|sources|original/.test(name),
  );
  if (!jar) throw new Error(`There is no server jar in ${folder}. Build the backend, or name one in APSIS_SERVER_JAR.`);
  return join(folder, jar);
}

async function untilUp(port: number, server: ChildProcess): Promise<void> {
  const deadline = Date.now() + READY_WITHIN_MS;
  while (Date.now() < deadline) {
    if (server.exitCode !== null) throw new Error(`The server ended with ${server.exitCode} before it was ready.`);
    const health = await fetch(`http://localhost:${port}/actuator/health`).catch(() => null);
    if (health?.ok && ((await health.json()) as { status: string }).status === 'UP') return;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error(`The server was not ready within ${READY_WITHIN_MS} ms.`);
}

function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const probe = createServer().listen(0, () => {
      const { port } = probe.address() as { port: number };
      probe.close(() => resolve(port));
    });
  });
}
