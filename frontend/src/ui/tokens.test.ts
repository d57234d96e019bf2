import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';

const source = join(import.meta.dirname, '..');
const css = readFileSync(join(import.meta.dirname, 'tokens.css'), 'utf8');

type Rgb = [number, number, number]; // linear light, 0 to 1

function colour(token: string): Rgb {
  const hex = new RegExp(`--${token}: #([0-9a-f]{6})`).exec(css)![1]!;
  return [0, 2, 4].map((i) => {
    const c = Number.parseInt(hex.slice(i, i + 2), 16) / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  }) as Rgb;
}

function contrast(a: string, b: string): number {
  const luminance = ([r, g, bl]: Rgb) => 0.2126 * r + 0.7152 * g + 0.0722 * bl;
  const [dark, light] = [luminance(colour(a)), luminance(colour(b))].sort((x, y) => x - y) as [number, number];
  return (light + 0.05) / (dark + 0.05);
}

/** CIE Lab under D65. */
function lab([r, g, b]: Rgb): Rgb {
  const f = (t: number) => (t > 216 / 24389 ? Math.cbrt(t) : (t * 24389) / 27 / 116 + 16 / 116);
  const x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
  const y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
  const z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

// Machado, Oliveira, Fernandes 2009, severity 1.0.
const SIGHTS: Record<string, number[][]> = {
  normal: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protan: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deutan: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritan: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};

function seen(token: string, sight: string): Rgb {
  const rgb = colour(token);
  const seenRgb = SIGHTS[sight]!.map((row) => row.reduce((sum, m, i) => sum + m * rgb[i]!, 0));
  return lab(seenRgb.map((c) => Math.min(1, Math.max(0, c))) as Rgb);
}

const deltaE = (a: Rgb, b: Rgb) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

describe('colours', () => {
  const canvas = ['planet', 'rock', 'ship', 'select', 'order', 'threat'];
  const pairs = canvas.flatMap((a, i) => canvas.slice(i + 1).map((b) => [a, b] as const));

  it.each(Object.keys(SIGHTS))('bodies_and_marks_can_be_told_apart_in_%s_sight', (sight) => {
    for (const [a, b] of pairs) {
      expect(deltaE(seen(a, sight), seen(b, sight)), `${a} and ${b}`).toBeGreaterThanOrEqual(25);
    }
  });

  it.each([
    ['text', 'panel'],
    ['dim', 'panel'],
    ['faint', 'panel'],
    ['faint', 'raised'],
    ['text', 'pressed'],
    ['select', 'selected-row'],
    ['text', 'selected-row'],
    ['order', 'panel'],
    ['bad', 'panel'],
    ['threat', 'panel'],
    ['threat', 'sky'],
    ['text', 'bad-surface'],
    ['warn', 'panel'],
    ['text', 'sky'],
    ['dim', 'sky'],
  ])('%s_can_be_read_on_%s', (ink, paper) => {
    expect(contrast(ink, paper)).toBeGreaterThanOrEqual(4.5);
  });

  it('the_edge_of_a_control_can_be_seen', () => {
    expect(contrast('edge', 'panel')).toBeGreaterThanOrEqual(3);
  });
});

describe('style sheets', () => {
  const files = readdirSync(source, { recursive: true, encoding: 'utf8' }).filter((f) => f.endsWith('.module.css'));

  it.each(files)('%s_has_no_colour_and_no_pixel_size_of_its_own', (file) => {
    const rules = readFileSync(join(source, file), 'utf8').replace(/@media[^{]*/g, '');
    expect(rules).not.toMatch(/#[0-9a-f]{3,8}\b|\d+px|rgba?\(|hsla?\(/i);
  });
});
