import { type Apsis, startApsis } from './apsis';
import { emptyPoint, expect, openLive, stage, test } from './test';

let apsis: Apsis;

test.beforeAll(async () => {
  apsis = await startApsis({ scene: 'belt-and-swarm', mayBeShared: true });
});

test.afterAll(() => apsis.stop());

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

test('tabs_lead_to_the_list_and_the_figures', async ({ page }) => {
  await openLive(page, apsis.url);
  await page.getByRole('tab', { name: /^Bodies \d+$/ }).tap();
  const first = page.getByRole('listitem').getByRole('button').first();
  await first.tap();
  await page.getByRole('tab', { name: 'Selected 1' }).tap();
  await expect(page.getByRole('button', { name: 'Follow' })).toBeVisible();
  await page.getByRole('tab', { name: 'Diagnostics' }).tap();
  await expect(page.getByText('Energy drift')).toBeVisible();
});

test('the_sheet_folds_away_for_a_larger_stage', async ({ page }) => {
  await openLive(page, apsis.url);
  const before = (await stage(page).boundingBox())!.height;
  await page.getByRole('button', { name: 'Fold the sheet' }).tap();

  await expect.poll(async () => (await stage(page).boundingBox())!.height).toBeGreaterThan(before + 100);
});

test('a_tap_sends_the_selected_ship', async ({ page }) => {
  await openLive(page, apsis.url);
  await page.getByRole('tab', { name: /^Bodies/ }).tap();
  await page.getByRole('searchbox').fill('ship');
  await page.getByRole('listitem').getByRole('button', { name: /^Ship/ }).first().tap();
  await page.getByRole('tab', { name: /^Selected/ }).tap();
  const target = await emptyPoint(page, 0.1, 0.9);
  await page.touchscreen.tap(target.x, target.y);

  await expect(page.getByText(/^Seek /)).toBeVisible();
});

test('what_is_touched_is_44_pixels_large', async ({ page }) => {
  await openLive(page, apsis.url);
  for (const tab of [/^Selected/, /^Bodies/, /^Diagnostics/]) {
    await page.getByRole('tab', { name: tab }).tap();
    for (const target of await page.getByRole('button').or(page.getByRole('tab')).all()) {
      const box = await target.boundingBox();
      if (!box) continue;
      const name = (await target.getAttribute('aria-label')) ?? (await target.textContent());
      expect(Math.round(Math.min(box.width, box.height)), `${name}`).toBeGreaterThanOrEqual(44);
    }
  }
});
