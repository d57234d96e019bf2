import type { ShortcutAction } from '../features/Shortcuts/shortcuts';
import type { BodyId } from '../protocol/frame';
import { bodyName } from '../world/bodyName';
import type { RoomClient } from './RoomClient';

const PAN_PX = 60;
const AIM_PX = 24;
const ZOOM = 1.3;
const KIND_ORDER = [1, 2, 0]; // planet, asteroid, ship: ships come first

/** What only the page can do. */
export type Page = { focusStage: () => void; focusFind: () => void; openHelp: () => void; fit: () => void };

/** What each key of the table does. */
export function actionsOf(client: RoomClient, page: Page): Record<ShortcutAction, () => void> {
  const { world, camera } = client;

  function step(direction: 1 | -1, isAdding: boolean): void {
    const id = neighbour(client, direction);
    if (id === undefined) return;
    if (isAdding) world.selection.add(id);
    else world.selection.only(id);
    bringIntoView(client, id);
    const { newest } = world.frames;
    world.notices.announce(`${bodyName(newest.kindAt(newest.slot.get(id)!), id)} selected`);
  }

  function arrow(dx: number, dy: number): void {
    const aim = world.aim.current();
    if (!aim) {
      camera.panBy(-dx * PAN_PX, dy * PAN_PX);
      if (world.view.current().follow) world.toggleView('follow');
      return;
    }
    const unit = AIM_PX / camera.pixelsPerUnit;
    world.aim.set({ x: aim.x + dx * unit, y: aim.y + dy * unit });
  }

  function aim(): void {
    if (world.selectedShips().length === 0) {
      world.notices.problem('Select a ship first, then choose where to send it.');
      return;
    }
    page.focusStage();
    world.aim.set({ x: camera.x, y: camera.y });
  }

  function send(): void {
    const point = world.aim.current();
    if (!point) return;
    client.sendShips(point);
    world.aim.set(null);
  }

  function clear(): void {
    if (world.aim.current()) world.aim.set(null);
    else world.selection.clear();
  }

  return {
    'add-planet': () => client.add('random-planet'),
    'add-asteroid': () => client.add('random-asteroid'),
    'add-ship': () => client.add('random-spaceship'),
    'add-random': () => client.add('random-body'),
    'select-tool': () => {
      world.aim.set(null);
      page.focusStage();
    },
    find: page.focusFind,
    'next-body': () => step(1, false),
    'previous-body': () => step(-1, false),
    'add-next-body': () => step(1, true),
    'add-previous-body': () => step(-1, true),
    delete: () => client.deleteSelected(),
    clear,
    aim,
    send,
    left: () => arrow(-1, 0),
    right: () => arrow(1, 0),
    up: () => arrow(0, 1),
    down: () => arrow(0, -1),
    'zoom-in': () => camera.zoom(ZOOM),
    'zoom-out': () => camera.zoom(1 / ZOOM),
    fit: page.fit,
    help: page.openHelp,
  };
}

function neighbour({ world }: RoomClient, direction: 1 | -1): BodyId | undefined {
  const { newest } = world.frames;
  const rank = (id: BodyId) => KIND_ORDER[newest.kind[newest.slot.get(id)!]!]!;
  const ids = [...newest.slot.keys()].sort((a, b) => rank(a) - rank(b) || a - b);
  const main = world.selection.main();
  const at = main === undefined ? -1 : ids.indexOf(main);
  if (at < 0) return ids.at(direction === 1 ? 0 : -1);
  return ids[(at + direction + ids.length) % ids.length];
}

/** Moves the view only if the body is outside it. */
function bringIntoView({ world, camera }: RoomClient, id: BodyId): void {
  const slot = world.frames.newest.slot.get(id)!;
  const { x, y } = world.frames.at;
  const [screenX, screenY] = [camera.toScreenX(x[slot]!), camera.toScreenY(y[slot]!)];
  const isInView = screenX > 0 && screenY > 0 && screenX < camera.width && screenY < camera.height;
  if (!isInView) camera.lookAt(x[slot]!, y[slot]!);
}
