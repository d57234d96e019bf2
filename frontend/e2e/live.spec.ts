import { type Apsis, startApsis } from './apsis';
import {
  bodyCount,
  card,
  emptyPoint,
  expect,
  figure,
  find,
  ORDER,
  openLive,
  pixelsOf,
  SELECT,
  stage,
  THREAT,
  test,
} from './test';

let apsis: Apsis;

test.beforeAll(async () => {
  apsis = await startApsis({ scene: 'belt-and-swarm', mayBeShared: true });
});

test.afterAll(() => apsis.stop());

test.beforeEach(({ page }) => openLive(page, apsis.url));

test('the_page_opens_and_bodies_move', async ({ page }) => {
  await expect(page.getByText('Belt and swarm')).toBeVisible();
  expect(await bodyCount(page)).toBeGreaterThan(10);
  const before = await stage(page).screenshot();
  await page.waitForTimeout(500);

  expect(before.equals(await stage(page).screenshot())).toBe(false);
});

test('an_added_asteroid_raises_the_count_and_is_announced', async ({ page }) => {
  const before = await bodyCount(page);
  await page.getByRole('button', { name: 'Add asteroid' }).click();

  await expect(page.getByRole('status').filter({ hasText: /^Added asteroid \d+$/ })).toBeAttached();
  await expect.poll(() => bodyCount(page)).toBeGreaterThan(before);
});

test('a_card_highlights_its_body_and_a_body_its_card', async ({ page }) => {
  await find(page, 'planet');
  // The heaviest one stays about where it is.
  await page.getByRole('button', { name: /Sorted by Speed/ }).click();
  const planet = page
    .getByRole('listitem')
    .getByRole('button', { name: /^Planet/ })
    .first();
  const name = (await planet.getAttribute('aria-label'))!.split(',')[0]!;
  await planet.click();
  await page.getByRole('button', { name: 'Follow' }).click();
  // A followed body is in the middle of the stage, with its ring.
  await expect.poll(() => pixelsOf(page, SELECT, 120)).toBeGreaterThan(20);

  await stage(page).press('Escape');
  await expect(card(page, name)).toHaveAttribute('aria-pressed', 'false');
  const box = (await stage(page).boundingBox())!;
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);

  await expect(card(page, name)).toHaveAttribute('aria-pressed', 'true');
});

test('three_ships_are_sent_to_a_point_get_there_and_stop', async ({ page }) => {
  await find(page, 'ship');
  await page.getByRole('button', { name: /Sorted by Speed/ }).click();
  await page.getByRole('button', { name: /Sorted by Mass/ }).click();
  const ships = page.getByRole('listitem').getByRole('button', { name: /^Ship/ });
  const names: string[] = [];
  for (let i = 0; i < 3; i++) {
    names.push((await ships.nth(i).getAttribute('aria-label'))!.split(',')[0]!);
    await ships.nth(i).click({ modifiers: i === 0 ? [] : ['Shift'] });
  }
  await expect(page.getByRole('heading', { name: '3 ships' })).toBeVisible();

  // Beyond the belt: no ship can stop where rocks sweep through.
  const target = await emptyPoint(page, 0.86, 0.97);
  await page.mouse.click(target.x, target.y);
  await expect(page.getByText(/^Seek /)).toBeVisible();
  expect(await pixelsOf(page, ORDER)).toBeGreaterThan(20);
  const [x, y] = (await figure(page, 'Order')) as [number, number];

  for (const name of names) {
    await card(page, name).click();
    await expect
      .poll(
        async () => {
          const [atX, atY] = (await figure(page, 'Position')) as [number, number];
          return Math.hypot(atX - x, atY - y);
        },
        { timeout: 45_000 },
      )
      .toBeLessThan(60);
    await expect.poll(async () => (await figure(page, 'Speed'))[0], { timeout: 20_000 }).toBeLessThan(8);
  }
});

test('a_ship_tells_what_it_is_about_to_do_and_the_stage_shows_it', async ({ page }) => {
  test.setTimeout(120_000);
  // Threats come and go, and not every ship has one: on to the next until one is told of and drawn.
  await expect(async () => {
    await page.keyboard.press('n');
    await expect(page.getByText(/ clear in /)).toBeVisible({ timeout: 1000 });
    expect(await pixelsOf(page, THREAT)).toBeGreaterThan(20);
  }).toPass({ timeout: 90_000 });

  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await expect.poll(() => pixelsOf(page, THREAT), { timeout: 20_000 }).toBe(0);
});

test('an_arrival_is_listed_and_announced', async ({ page }) => {
  test.setTimeout(120_000);
  // Others may have sent ships in this room: on to the next until one wanders.
  await expect(async () => {
    await page.keyboard.press('n');
    await expect(page.getByText('none, it wanders')).toBeVisible({ timeout: 1000 });
  }).toPass({ timeout: 30_000 });
  await page.keyboard.press('f');
  const ship = await page.getByRole('heading', { name: /^Ship/ }).textContent();
  await page.keyboard.press('t');
  for (let i = 0; i < 12; i++) await stage(page).press('ArrowRight');
  for (let i = 0; i < 12; i++) await stage(page).press('ArrowUp');
  await stage(page).press('Enter');

  const arrived = `${ship} has arrived`;
  await expect(page.getByRole('log', { name: 'Events' })).toContainText(arrived, { timeout: 60_000 });
  await expect(page.getByRole('status').filter({ hasText: arrived })).toBeAttached();
});

test('a_click_outside_the_world_is_refused_and_says_why', async ({ page }) => {
  await find(page, 'ship');
  await page.getByRole('listitem').getByRole('button', { name: /^Ship/ }).first().click();
  for (let i = 0; i < 12; i++) await page.getByRole('button', { name: 'Zoom out' }).click();
  const box = (await stage(page).boundingBox())!;
  await page.mouse.click(box.x + 0.6 * box.width, box.y + 0.97 * box.height);

  await expect(page.getByText(/outside the world/)).toBeVisible();
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await expect(page.getByText(/outside the world/)).toBeHidden();
});

test('a_body_can_be_deleted', async ({ page }) => {
  await find(page, 'asteroid');
  const asteroid = page
    .getByRole('listitem')
    .getByRole('button', { name: /^Asteroid/ })
    .first();
  const name = (await asteroid.getAttribute('aria-label'))!.split(',')[0]!;
  await asteroid.hover();
  await page.getByRole('button', { name: `Delete ${name}`, exact: true }).click();

  await expect(page.getByRole('status').filter({ hasText: `Deleted ${name}` })).toBeAttached();
  await find(page, name);
  await expect(card(page, name)).toHaveCount(0);
});

test('the_view_pans_and_zooms_and_fits_again', async ({ page }) => {
  const box = (await stage(page).boundingBox())!;
  const still = async () => (await page.getByText(/ u$/).last().textContent()) ?? '';
  const before = await still();
  await page.mouse.move(box.x + 400, box.y + 400);
  await page.mouse.wheel(0, -1500);
  await expect.poll(still).not.toBe(before);
  await page.mouse.down();
  await page.mouse.move(box.x + 600, box.y + 450, { steps: 5 });
  await page.mouse.up();
  await page.getByRole('button', { name: 'Fit' }).click();

  await expect.poll(still).not.toBe('');
});

test('there_is_no_horizontal_scroll', async ({ page }) => {
  for (const width of [1440, 1024, 390, 320]) {
    await page.setViewportSize({ width, height: 800 });
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  }
});
