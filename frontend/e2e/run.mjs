// Runs the browser tests where there is a Chromium, and says loudly where there is none. No browser is downloaded.
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';

const NAMES = ['chromium', 'chromium-browser', 'google-chrome'];

function findChromium() {
  const named = process.env.APSIS_CHROMIUM;
  if (named) return existsSync(named) ? named : null;
  const folders = (process.env.PATH ?? '').split(delimiter);
  const places = ['/usr/bin/chromium', ...NAMES.flatMap((name) => folders.map((folder) => join(folder, name)))];
  return places.find((place) => existsSync(place)) ?? null;
}

function box(lines) {
  const width = Math.max(...lines.map((line) => line.length));
  const edge = `+${'-'.repeat(width + 2)}+`;
  return [edge, ...lines.map((line) => `| ${line.padEnd(width)} |`), edge].join('\n');
}

const chromium = findChromium();
if (!chromium) {
  console.log(
    box([
      'BROWSER TESTS WERE SKIPPED: there is no Chromium on this machine.',
      '',
      'Install one (Debian: apt-get install chromium), or name one in APSIS_CHROMIUM,',
      'and run again: node e2e/run.mjs',
    ]),
  );
  process.exit(0);
}

const playwright = join(import.meta.dirname, '../node_modules/@playwright/test/cli.js');
const { status } = spawnSync(process.execPath, [playwright, 'test', ...process.argv.slice(2)], {
  cwd: join(import.meta.dirname, '..'),
  env: { ...process.env, APSIS_CHROMIUM: chromium },
  stdio: 'inherit',
});
process.exit(status ?? 1);
