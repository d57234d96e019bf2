// Builds the page for Maven with the system's Node: `node build.mjs` installs and builds what has changed, `node build.mjs
// check` runs the formatter, the type checker and the tests.
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, rmSync, statSync } from 'node:fs';
import { join } from 'node:path';

const [major, minor] = process.versions.node.split('.').map(Number);
if (major < 20 || (major === 20 && minor < 19)) {
  console.error(
    `Apsis needs Node 20.19 or newer to build its page: this is ${process.versions.node}. Install a newer one and run the same command again.`,
  );
  process.exit(1);
}

function npm(...args) {
  const result = spawnSync('npm', args, { stdio: 'inherit', shell: process.platform === 'win32' });
  if (result.error) {
    console.error("Apsis needs npm, which comes with Node, and there is no 'npm' on the PATH.");
  }
  if (result.status !== 0) {
    process.exit(result.status ?? 1);
  }
}

function newest(path) {
  const stat = statSync(path, { throwIfNoEntry: false });
  if (!stat) return 0;
  if (!stat.isDirectory()) return stat.mtimeMs;
  return Math.max(...readdirSync(path).map((name) => newest(join(path, name))), 0);
}

const installed = 'node_modules/.package-lock.json';
if (newest('package-lock.json') > newest(installed)) {
  npm('ci', '--no-audit', '--no-fund');
}

if (process.argv[2] === 'check') {
  npm('run', 'check');
} else {
  const sources = ['src', 'public', 'index.html', 'package-lock.json', 'package.json', 'vite.config.ts', 'tsconfig.json'];
  if (Math.max(...sources.map(newest)) > newest('dist/index.html')) {
    if (existsSync('dist')) rmSync('dist', { recursive: true });
    npm('run', 'build');
  }
}
