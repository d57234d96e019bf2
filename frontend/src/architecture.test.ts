import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { describe, expect, it } from 'vitest';

const root = import.meta.dirname;

/** Who may import whom. An area is a folder of src, or one feature. */
const MAY_IMPORT: Readonly<Record<string, readonly string[]>> = {
  protocol: [],
  ui: [],
  connection: ['protocol'],
  world: ['protocol'],
  canvas: ['world', 'protocol'],
  features: ['world', 'protocol', 'ui'],
  app: ['protocol', 'ui', 'connection', 'world', 'canvas', 'features'],
};

/** Why an import from one file to another is against the plan, or null. Paths relative to src, with slashes. */
function offence(from: string, to: string): string | null {
  const [fromArea, toArea] = [areaOf(from), areaOf(to)];
  if (fromArea === toArea) return null;
  const folder = fromArea.split('/')[0]!;
  const allowed = MAY_IMPORT[folder];
  if (!allowed) return `${from}: ${folder} is not in the plan`;
  // One feature does not know another, although both are in `features`.
  const isAllowed =
    allowed.includes(toArea.split('/')[0]!) && !(folder === 'features' && toArea.startsWith('features'));
  return isAllowed ? null : `${from} imports ${to}: ${fromArea} may not know ${toArea}`;
}

function areaOf(path: string): string {
  const [folder, feature] = path.split('/');
  return folder === 'features' ? `features/${feature}` : folder!;
}

function importsOf(source: string): string[] {
  const pattern = /(?:from|import)\s*\(?\s*['"](\.[^'"]*)['"]/g;
  return [...source.matchAll(pattern)].map((match) => match[1]!);
}

function edges(): [string, string][] {
  const files = readdirSync(root, { recursive: true, encoding: 'utf8' }).filter(
    (file) => /\.tsx?$/.test(file) && file.includes('/'),
  );
  return files.flatMap((file) =>
    importsOf(readFileSync(join(root, file), 'utf8')).map((target): [string, string] => [
      file,
      relative(root, join(root, dirname(file), target)),
    ]),
  );
}

describe('the plan', () => {
  it('is_kept_by_every_import', () => {
    expect(edges().length).toBeGreaterThan(100);
    expect(edges().flatMap(([from, to]) => offence(from, to) ?? [])).toEqual([]);
  });

  it.each([
    ['protocol/decode.ts', 'world/World'],
    ['ui/Button.tsx', 'world/World'],
    ['connection/RoomConnection.ts', 'world/World'],
    ['world/World.ts', 'connection/link'],
    ['canvas/Canvas.tsx', 'connection/link'],
    ['canvas/Canvas.tsx', 'ui/Button'],
    ['canvas/Canvas.tsx', 'features/InfoSection/BodyCard'],
    ['features/InfoSection/InfoSection.tsx', 'canvas/Camera'],
    ['features/InfoSection/InfoSection.tsx', 'features/Diagnostics/Figures'],
    ['features/InfoSection/InfoSection.tsx', 'app/App'],
    ['somewhere/new.ts', 'ui/Button'],
  ])('forbids_%s_to_import_%s', (from, to) => {
    expect(offence(from, to)).not.toBeNull();
  });

  it('sees_static_and_lazy_imports', () => {
    const source = `import a from './a';\nimport './b.css';\nconst c = await import('../c/d');\nimport x from 'react';`;
    expect(importsOf(source)).toEqual(['./a', './b.css', '../c/d']);
  });
});
