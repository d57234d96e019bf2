import { type Apsis, startApsis } from './apsis';
import { bodyCount, expect, link, test } from './test';

let apsis: Apsis;

test.beforeAll(async () => {
  apsis = await startApsis({ scene: 'belt-and-swarm', refuseWebSockets: true });
});

test.afterAll(() => apsis.stop());

test.use({ mayLoseServer: true });

test('a_network_without_web_sockets_gets_sockjs', async ({ page }) => {
  await page.goto(apsis.url);
  await expect(link(page)).toBeVisible({ timeout: 20_000 });
  await expect.poll(() => bodyCount(page)).toBeGreaterThan(10);

  const before = await bodyCount(page);
  await page.getByRole('button', { name: 'Add asteroid' }).click();
  await expect.poll(() => bodyCount(page)).toBeGreaterThan(before);
});
