import { type Apsis, startApsis } from './apsis';
import { expect, find, frames, link, openLive, test } from './test';

let apsis: Apsis;

test.beforeAll(async () => {
  apsis = await startApsis({ scene: 'belt-and-swarm' });
});

test.afterAll(() => apsis.stop());

test.use({ mayLoseServer: true });

test('the_page_survives_a_restart_of_the_server', async ({ page }) => {
  test.setTimeout(120_000); // a server starts twice, on a machine that may have other work
  await openLive(page, apsis.url);
  await find(page, 'ship');
  await page.getByRole('listitem').getByRole('button', { name: /^Ship/ }).first().click();
  // Not from the card: the list is sorted by speed, and may be another one by the time of the click.
  const name = (await page.getByRole('heading', { name: /^Ship/ }).textContent())!;

  await apsis.kill();
  await expect(page.getByRole('alert').filter({ hasText: 'Connection lost.' })).toBeVisible();
  await expect(page.getByText(/You see the last frame, \d+ s old/)).toBeVisible();
  await expect(page.getByRole('button', { name: 'Add planet' })).toBeDisabled();

  await apsis.start();
  // Within two seconds of the server, without a reload, with the selection.
  await expect(link(page)).toBeVisible({ timeout: 2500 });
  await expect(page.getByText('Connection lost.')).toBeHidden();
  await expect(page.getByRole('heading', { name })).toBeVisible();
  await expect(page.getByRole('button', { name: 'Add planet' })).toBeEnabled();
  await expect(frames(page)).toBeVisible();
});
