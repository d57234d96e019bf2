import { type Apsis, startApsis } from './apsis';
import { bodyCount, expect, figure, openLive, stage, test } from './test';

let apsis: Apsis;

test.beforeAll(async () => {
  apsis = await startApsis({ scene: 'belt-and-swarm', mayBeShared: true });
});

test.afterAll(() => apsis.stop());

test('everything_can_be_done_without_a_mouse', async ({ page }) => {
  await openLive(page, apsis.url);
  const { keyboard } = page;

  await test.step('read the shortcuts', async () => {
    await keyboard.press('?');
    await expect(page.getByRole('dialog', { name: 'Keyboard and pointer' })).toBeVisible();
    await keyboard.press('Escape');
    await expect(page.getByRole('dialog')).toBeHidden();
  });

  await test.step('add a ship', async () => {
    const before = await bodyCount(page);
    await keyboard.press('3');
    await expect.poll(() => bodyCount(page)).toBeGreaterThan(before);
  });

  await test.step('select two ships on the stage', async () => {
    await keyboard.press('v');
    await expect(stage(page)).toBeFocused();
    await keyboard.press('n');
    await expect(page.getByRole('heading', { name: /^Ship \d+$/ })).toBeVisible();
    await keyboard.press('Shift+N');
    await expect(page.getByRole('heading', { name: '2 ships' })).toBeVisible();
  });

  await test.step('send them to a point', async () => {
    await keyboard.press('f'); // a ship out of view has taken the view with it
    await keyboard.press('t');
    await expect(page.getByText('Arrows move the cross, Enter sends')).toBeVisible();
    for (let i = 0; i < 8; i++) await keyboard.press('ArrowUp');
    await keyboard.press('Enter');
    await expect(page.getByText(/^Seek /)).toBeVisible();
    const [, y] = await figure(page, 'Order');
    expect(y).toBeGreaterThan(50);
  });

  await test.step('move and zoom the view', async () => {
    for (const key of ['+', '-', 'ArrowLeft', 'f']) await keyboard.press(key);
  });

  await test.step('find a body, and select it in the list', async () => {
    await keyboard.press('/');
    await keyboard.type('planet');
    await keyboard.press('Tab');
    await keyboard.press('Tab');
    await keyboard.press('Enter');
    await expect(page.getByRole('heading', { name: /^Planet \d+$/ })).toBeVisible();
  });

  await test.step('switch what the stage shows', async () => {
    const force = page.getByRole('button', { name: 'Force' });
    await force.focus();
    await keyboard.press('Space');
    await expect(force).toHaveAttribute('aria-pressed', 'true');
  });

  await test.step('delete it, and select nothing', async () => {
    const before = await bodyCount(page);
    await keyboard.press('Delete');
    await expect.poll(() => bodyCount(page)).toBe(before - 1);
    await keyboard.press('n');
    await keyboard.press('Escape');
    await expect(page.getByText('Nothing selected')).toBeVisible();
  });
});

test('keys_typed_into_the_find_box_are_text', async ({ page }) => {
  await openLive(page, apsis.url);
  const before = await bodyCount(page);
  await page.keyboard.press('/');
  await page.keyboard.type('1234');

  await expect(page.getByRole('searchbox')).toHaveValue('1234');
  expect(await bodyCount(page)).toBe(before);
});
