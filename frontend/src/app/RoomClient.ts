import { Camera } from '../canvas/Camera';
import { RoomConnection } from '../connection/RoomConnection';
import { type OpenSocket, openSocket } from '../connection/socket';
import type { AddCommand, ClientMessage } from '../protocol/commands';
import type { BodyId, Frame, Vec2 } from '../protocol/frame';
import type { Problem, Reply, Room, ShipEvents } from '../protocol/messages';
import { formatCoordinate } from '../ui/formatNumber';
import { bodyName, countOf } from '../world/bodyName';
import { eventText } from '../world/eventText';
import { World } from '../world/World';

/** Bursts of up to 100 commands are allowed, and the user may want to do something meanwhile. */
const RESELECT_AT_ONCE = 50;
const RESELECT_EVERY_MS = 1200;

/** So long an event may come after the frame in which its ship is missing. */
const LOST_FOR_MS = 3000;

const KIND_OF_ADD: Readonly<Record<string, string>> = {
  'random-planet': 'Planet',
  'random-asteroid': 'Asteroid',
  'random-spaceship': 'Ship',
};

/** Refusals that can be about an order. */
const ORDER_CODES = new Set(['OUTSIDE_WORLD', 'NO_SHIP_SELECTED', 'INVALID_VALUE', 'TOO_MANY_COMMANDS', 'ROOM_BUSY']);

/** Ties the link to what the client knows: the one place where messages change the world and wishes become messages. */
export class RoomClient {
  readonly camera = new Camera();
  readonly world: World;
  readonly connection: RoomConnection;
  #mustReselect = false;
  #unnamed: BodyId[] = [];
  readonly #lost = new Map<BodyId, number>();
  #deletedNames = new Map<BodyId, string>();

  constructor(open: OpenSocket = openSocket) {
    this.world = new World((id, selected) => this.connection.send({ type: 'select-body', id, selected }));
    this.connection = new RoomConnection(
      {
        onConnected: () => this.#connected(),
        onRoom: (room) => this.#enter(room),
        onFrame: (frame, atMs) => this.#show(frame, atMs),
        onDiagnostics: (diagnostics) => this.world.history.add(diagnostics),
        onEvents: (events) => this.#hear(events),
        onShip: (ship) => this.world.ship.set(ship),
        onReply: (reply) => this.#answer(reply),
        onProblem: (problem) => this.#complain(problem),
      },
      open,
    );
  }

  add(type: AddCommand): void {
    this.#send({ type });
  }

  select(id: BodyId, isAdding: boolean): void {
    const { selection } = this.world;
    if (isAdding) selection.toggle(id);
    else selection.only(id);
  }

  delete(id: BodyId): void {
    this.#deletedNames.set(id, this.#nameOf(id));
    this.#send({ type: 'delete-body', id });
  }

  deleteSelected(): void {
    for (const id of this.world.selection.ids()) this.delete(id);
  }

  /** Sends the selected ships to a point; without ships there is nobody to send. */
  sendShips(point: Vec2): void {
    const ships = this.world.selectedShips();
    if (ships.length === 0) return;
    if (!this.#send({ type: 'move-selected-spaceships', x: point.x, y: point.y })) return;
    this.world.orders.give(point, ships, performance.now());
  }

  #send(message: ClientMessage): boolean {
    const isSent = this.connection.send(message);
    if (!isSent) this.world.notices.problem('There is no connection now. Try again when the page is back.');
    return isSent;
  }

  #connected(): void {
    this.world.frames.restart();
    this.world.ship.set(null);
    this.#mustReselect = true;
  }

  #enter(room: Room): void {
    const before = this.world.room.current();
    if (before && (before.room !== room.room || before.scene !== room.scene)) this.#forget();
    this.world.frames.ticksPerSecond(room.tickRate);
    this.world.room.set(room);
  }

  #show(frame: Frame, nowMs: number): void {
    const { frames, selection, trails, orders, hovered, view } = this.world;
    if (frames.accept(frame, nowMs)) this.#forget();
    this.#rememberLost(nowMs);
    selection.keep((id) => frames.has(id));
    if (this.#mustReselect) this.#reselect(selection.ids());
    if (selection.ids().length === 0 && view.current().follow) this.world.toggleView('follow');
    if (!this.world.mainShip()) this.world.ship.set(null);
    const over = hovered.current();
    if (over !== null && !frames.has(over)) hovered.set(null);
    trails.record(frames, selection.ids());
    orders.seen(frames.newest);
    this.#nameNewcomers();
  }

  /** The room began anew: what was drawn and what was asked for belongs to its former life. */
  #forget(): void {
    this.world.trails.clear();
    this.world.orders.refuse();
    this.world.fresh.clear();
    this.world.history.clear();
    this.world.events.clear();
  }

  /** What this client had selected when it went: the event that says why may come after the frame without it. */
  #rememberLost(nowMs: number): void {
    const { frames, selection } = this.world;
    for (const id of selection.ids()) if (!frames.has(id)) this.#lost.set(id, nowMs);
    for (const [id, atMs] of this.#lost) if (nowMs - atMs > LOST_FOR_MS) this.#lost.delete(id);
  }

  /** All events are shown; what happens to one's own ships is said as well, and that one is gone cannot be overlooked. */
  #hear(events: ShipEvents): void {
    for (const event of this.world.events.take(events)) {
      const isOwn = this.world.selection.has(event.ship) || this.#lost.has(event.ship);
      if (isOwn && event.type === 'destroyed') this.world.notices.problem(`${eventText(event)}. It was selected.`);
      else if (isOwn) this.world.notices.announce(eventText(event));
    }
  }

  /** A selection ends with its session; this tells the new one. In portions, for the limit on commands. */
  #reselect(ids: readonly BodyId[]): void {
    this.#mustReselect = false;
    for (const id of ids.slice(0, RESELECT_AT_ONCE)) {
      if (this.world.selection.has(id)) this.connection.send({ type: 'select-body', id, selected: true });
    }
    const rest = ids.slice(RESELECT_AT_ONCE);
    if (rest.length > 0) setTimeout(() => this.#reselect(rest), RESELECT_EVERY_MS);
  }

  #answer({ command, ids }: Reply): void {
    if (command.startsWith('random-')) {
      for (const id of ids) this.world.fresh.set(id, performance.now());
      const kind = KIND_OF_ADD[command];
      if (kind) this.world.notices.announce(`Added ${kind.toLowerCase()} ${ids.join(', ')}`);
      else this.#unnamed.push(...ids);
    } else if (command === 'delete-body') {
      this.world.notices.announce(`Deleted ${ids.map((id) => this.#deletedNames.get(id) ?? id).join(', ')}`);
      for (const id of ids) this.#deletedNames.delete(id);
    } else if (command === 'move-selected-spaceships') {
      this.world.orders.confirm();
      const order = this.world.orders.pending(performance.now());
      const where = order ? ` to ${formatCoordinate(order.x)}, ${formatCoordinate(order.y)}` : '';
      this.world.notices.announce(`${countOf(ids.length, 'ship')} under way${where}`);
    }
  }

  /** Only the next frame tells what kind a random body has. */
  #nameNewcomers(): void {
    const known = this.#unnamed.filter((id) => this.world.frames.has(id));
    if (known.length === 0) return;
    this.#unnamed = this.#unnamed.filter((id) => !known.includes(id));
    this.world.notices.announce(`Added ${known.map((id) => this.#nameOf(id).toLowerCase()).join(', ')}`);
  }

  #complain({ code, message }: Problem): void {
    if (ORDER_CODES.has(code)) this.world.orders.refuse();
    this.world.notices.problem(message);
  }

  #nameOf(id: BodyId): string {
    const { newest } = this.world.frames;
    const slot = newest.slot.get(id);
    return slot === undefined ? `Body ${id}` : bodyName(newest.kindAt(slot), id);
  }
}
