import AxeBuilder from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { type Apsis, startApsis } from './apsis';
import { expect, openLive, stage, test } from './test';

const SIZES = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
];

let live: Apsis;
let empty: Apsis;

test.beforeAll(async () => {
  live = await startApsis({ scene: 'belt-and-swarm' });
  empty = await startApsis({ scene: 'empty' });
});

test.afterAll(async () => {
  await live.stop();
  await empty.stop();
});

async function check(page: Page, name: string): Promise<void> {
  await page.evaluate(() => document.fonts.ready);
  await page.screenshot({ path: `target/screenshots/${name}-${page.viewportSize()!.width}.png` });
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' ')}`)).toEqual([]);
}

for (const size of SIZES) {
  test.describe(`at_${size.width}_x_${size.height}`, () => {
    test.use({ viewport: size });

    test('nothing_is_wrong_in_the_live_state', async ({ page }) => {
      await openLive(page, live.url);
      for (const key of ['n', 'Shift+N', 'Shift+N', 'f']) await page.keyboard.press(key);
      const box = (await stage(page).boundingBox())!;
      await page.mouse.click(box.x + 0.78 * box.width, box.y + 0.3 * box.height);
      await page.waitForTimeout(1500);
      await check(page, 'live');
    });

    test('nothing_is_wrong_with_a_ship_that_tells_its_plan', async ({ page }) => {
      await openLive(page, live.url);
      await page.keyboard.press('n');
      await expect(page.getByText(/^(Course|Detour)$/)).toBeVisible();
      await expect(page.getByText(/ at \d+°/).first()).toBeVisible();
      await check(page, 'plan');
    });

    test('nothing_is_wrong_in_the_empty_state', async ({ page }) => {
      await openLive(page, empty.url);
      await expect(page.getByRole('heading', { name: 'No bodies yet' })).toBeVisible();
      await check(page, 'empty');
    });

    test('nothing_is_wrong_in_the_table_of_all_figures', async ({ page }) => {
      await openLive(page, live.url);
      const opener =
        size.width > 700 ? page.getByRole('button', { name: 'All figures' }) : page.getByRole('tab').last();
      await opener.focus();
      await page.keyboard.press('Enter');
      await expect(page.getByText('Angular momentum', { exact: true })).toBeVisible();
      await check(page, 'figures');
    });

    test('nothing_is_wrong_in_the_dialog', async ({ page }) => {
      await openLive(page, live.url);
      await page.getByRole('button', { name: 'Keyboard shortcuts' }).click();
      await check(page, 'dialog');
    });
  });
}

test.describe('without_the_server', () => {
  test.use({ mayLoseServer: true });

  test('nothing_is_wrong_in_the_disconnected_state', async ({ page }) => {
    await openLive(page, live.url);
    for (const key of ['n', 'Shift+N']) await page.keyboard.press(key);
    await live.kill();
    await expect(page.getByRole('alert').filter({ hasText: 'Connection lost.' })).toBeVisible();
    for (const size of SIZES) {
      await page.setViewportSize(size);
      await check(page, 'disconnected');
    }
  });
});
