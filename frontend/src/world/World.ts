import type { BodyId, Vec2 } from '../protocol/frame';
import type { Room, ShipReading } from '../protocol/messages';
import { Events } from './Events';
import { FrameBuffer } from './FrameBuffer';
import { SHIP } from './FrameColumns';
import { History } from './History';
import { Notices } from './Notices';
import { Orders } from './Orders';
import { Selection } from './Selection';
import { Trails } from './Trails';
import { FIRST_VIEW, type ViewOptions } from './ViewOptions';
import { Value } from './Watched';

/** Everything the client knows. One object per page; each part is a store that can be followed by itself. */
export class World {
  readonly frames = new FrameBuffer();
  readonly trails = new Trails();
  readonly orders = new Orders();
  readonly notices = new Notices();
  readonly history = new History();
  readonly events = new Events();
  readonly room = new Value<Room | null>(null);
  /** The newest reading of a ship; only {@link mainShip} knows whether it still matters. */
  readonly ship = new Value<ShipReading | null>(null);
  readonly view = new Value<ViewOptions>(FIRST_VIEW);
  /** The body under the pointer, on the stage or in the list. */
  readonly hovered = new Value<BodyId | null>(null);
  /** The keyboard's cross on the stage, in scene units. */
  readonly aim = new Value<Vec2 | null>(null);
  /** Frames per second that the stage really draws. */
  readonly drawnHz = new Value(0);
  /** Bodies to point out on the stage, with performance.now() of the moment they appeared. */
  readonly fresh = new Map<BodyId, number>();
  readonly selection: Selection;

  constructor(tellSelection?: (id: BodyId, selected: boolean) => void) {
    this.selection = new Selection(tellSelection);
  }

  selectedShips(): BodyId[] {
    const { slot, kind } = this.frames.newest;
    return this.selection.ids().filter((id) => kind[slot.get(id) ?? kind.length] === SHIP);
  }

  /** What the ship is doing that was selected last; null until the room has told, and where that is no ship. */
  mainShip(): ShipReading | null {
    const reading = this.ship.current();
    return reading && reading.id === this.selection.main() && this.frames.has(reading.id) ? reading : null;
  }

  toggleView(option: keyof ViewOptions): void {
    const view = this.view.current();
    this.view.set({ ...view, [option]: !view[option] });
  }
}
