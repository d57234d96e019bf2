import { test as base, expect, type Locator, type Page } from '@playwright/test';

/** What the browser itself logs when a socket cannot be opened; the page cannot keep it from doing so. */
const REFUSED_SOCKET =
  /WebSocket connection to .* failed|Failed to load resource: .*(502|ERR_EMPTY_RESPONSE|ERR_CONNECTION)/;

type Fixtures = {
  /** Set to true by a test that takes the server away. */
  mayLoseServer: boolean;
  quietConsole: undefined;
};

/** Every test fails on anything in the console. */
export const test = base.extend<Fixtures>({
  mayLoseServer: [false, { option: true }],
  quietConsole: [
    async ({ page, mayLoseServer }, use) => {
      const heard: string[] = [];
      page.on('console', (message) => {
        if (message.type() === 'error' || message.type() === 'warning') heard.push(message.text());
      });
      page.on('pageerror', (error) => heard.push(String(error)));
      await use(undefined);
      expect(heard.filter((text) => !(mayLoseServer && REFUSED_SOCKET.test(text)))).toEqual([]);
    },
    { auto: true },
  ],
});

export { expect };

export async function openLive(page: Page, url: string): Promise<void> {
  await page.goto(url);
  await expect(frames(page)).toBeVisible();
}

/** What the header says of a link that stands; the footer has a figure called Delay as well. */
export const link = (page: Page): Locator => page.getByRole('banner').getByText(/^(Live, \d+ Hz|Delay .* ms)$/);

/** The same, once frames have been counted. */
export const frames = (page: Page): Locator => page.getByRole('banner').getByText(/^(Live, [1-9]\d? Hz|Delay .* ms)$/);

export const stage = (page: Page): Locator => page.getByRole('application');

export const card = (page: Page, name: string | RegExp): Locator =>
  page.getByRole('listitem').getByRole('button', { name: typeof name === 'string' ? new RegExp(`^${name},`) : name });

/** How many bodies the page says there are. */
export async function bodyCount(page: Page): Promise<number> {
  const label = (await stage(page).getAttribute('aria-label')) ?? '';
  return Number(label.replace(/\D/g, ''));
}

export async function find(page: Page, text: string): Promise<void> {
  await page.getByRole('searchbox', { name: 'Find by id or type' }).fill(text);
}

/** A figure of the inspector, as numbers. */
export async function figure(page: Page, label: string): Promise<number[]> {
  const value = page.getByRole('region', { name: 'Selected' }).locator('dt', { hasText: label }).locator('+ dd');
  const text = ((await value.textContent()) ?? '').replaceAll('−', '-').replaceAll('\u2009', '');
  return [...text.matchAll(/-?\d+(?:\.\d+)?(?:e-?\d+)?/g)].map(Number);
}

type Pixels = { readonly data: number[]; readonly width: number; readonly height: number };

/** The picture on the stage, from a copy: reading from the canvas itself would slow it down, and the browser says so. */
function pixels(page: Page): Promise<Pixels> {
  return stage(page)
    .locator('canvas')
    .evaluate((canvas: HTMLCanvasElement) => {
      const { width, height } = canvas;
      const copy = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true })!;
      copy.drawImage(canvas, 0, 0);
      return { data: [...new Uint32Array(copy.getImageData(0, 0, width, height).data.buffer)], width, height };
    });
}

const channels = (pixel: number) => [pixel & 255, (pixel >> 8) & 255, (pixel >> 16) & 255] as const;

/** How many pixels of the stage, within `reach` of its middle, have this colour. Counted where they are: a million take seconds to send. */
export function pixelsOf(page: Page, colour: readonly [number, number, number], reach = 4000): Promise<number> {
  return stage(page)
    .locator('canvas')
    .evaluate(
      (canvas: HTMLCanvasElement, [[red, green, blue], within]) => {
        const { width, height } = canvas;
        const copy = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true })!;
        copy.drawImage(canvas, 0, 0);
        const { data } = copy.getImageData(0, 0, width, height);
        let count = 0;
        for (let i = 0; i < width * height; i++) {
          const isNear =
            Math.abs((i % width) - width / 2) <= within && Math.abs(Math.floor(i / width) - height / 2) <= within;
          const distance = Math.hypot(data[4 * i]! - red, data[4 * i + 1]! - green, data[4 * i + 2]! - blue);
          if (isNear && distance < 20) count++;
        }
        return count;
      },
      [colour, reach] as const,
    );
}

/** A point of the window where the stage shows nothing but sky and grid, away from the controls along its edges. */
export async function emptyPoint(page: Page, from = 0.25, to = 0.75): Promise<{ x: number; y: number }> {
  const box = (await stage(page).boundingBox())!;
  const { data, width, height } = await pixels(page);
  for (let y = Math.round(0.3 * height); y < 0.7 * height; y += 20) {
    for (let x = Math.round(from * width); x < to * width; x += 20) {
      if (isEmpty(data, width, x, y)) return { x: box.x + x, y: box.y + y };
    }
  }
  throw new Error('There is no empty space on the stage.');
}

const FREE_PX = 26;

function isEmpty(data: readonly number[], width: number, x: number, y: number): boolean {
  for (let dy = -FREE_PX; dy <= FREE_PX; dy++) {
    const row = data.slice((y + dy) * width + x - FREE_PX, (y + dy) * width + x + FREE_PX);
    if (row.some((pixel) => Math.max(...channels(pixel)) > 64)) return false;
  }
  return true;
}

export const SELECT = [0xfd, 0xc3, 0x0d] as const;
export const ORDER = [0xed, 0x54, 0xb0] as const;
export const THREAT = [0xff, 0x3b, 0x1f] as const;
