import { type Apsis, startApsis } from './apsis';
import { bodyCount, expect, openLive, test } from './test';

let apsis: Apsis;

test.beforeAll(async () => {
  apsis = await startApsis({ scene: 'mortal-field' });
});

test.afterAll(() => apsis.stop());

test('a_room_of_mortal_ships_says_so', async ({ page }) => {
  await openLive(page, apsis.url);
  await expect(page.getByText('Asteroid field, mortal ships')).toBeVisible();
  await page.keyboard.press('n');

  await expect(page.getByText('it is gone')).toBeVisible();
});

// Ships seldom die by themselves: the server's message is sent once more, with a death in it.
test('a_selected_ship_that_is_destroyed_leaves_with_a_sentence', async ({ page }) => {
  let tell: (event: object) => void = () => {};
  await page.routeWebSocket(/physics-engine-websocket/, (client) => {
    const server = client.connectToServer();
    let subscription = '';
    client.onMessage((sent) => {
      const subscribe = `${sent}`.split('\0').find((frame) => frame.includes('destination:/topic/events'));
      if (subscribe) subscription = /\nid:(.*)/.exec(subscribe)![1]!;
      server.send(sent);
    });
    server.onMessage((sent) => client.send(sent));
    tell = (event) => {
      const body = JSON.stringify({ tick: 10, unlisted: 0, events: [event] });
      client.send(`MESSAGE\ndestination:/topic/events\nsubscription:${subscription}\nmessage-id:1\n\n${body}\0`);
    };
  });
  await openLive(page, apsis.url);
  expect(await bodyCount(page)).toBeGreaterThan(10);
  await page.keyboard.press('n');
  const ship = Number((await page.getByRole('heading', { name: /^Ship/ }).textContent())!.replace(/\D/g, ''));

  const other = { id: 1, kind: 'asteroid' };
  tell({ number: 1, tick: 9, time: 0, type: 'destroyed', ship, other, speed: 96.4 });

  await expect(page.getByRole('alert').filter({ hasText: `Ship ${ship} hit Asteroid 1 and is gone` })).toBeVisible();
  await expect(page.getByRole('log', { name: 'Events' })).toContainText('96.40 u/s');
});
