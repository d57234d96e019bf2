import type { ShipEvent } from '../protocol/messages';
import { bodyName } from './bodyName';

/** "Ship 17 hit Asteroid 9": what happened, in words. */
export function eventText({ type, ship, other }: ShipEvent): string {
  const name = bodyName('ship', ship);
  const what = other ? bodyName(other.kind, other.id) : 'something';
  switch (type) {
    case 'arrived':
      return `${name} has arrived`;
    case 'collided':
      return `${name} hit ${what}`;
    case 'destroyed':
      return `${name} hit ${what} and is gone`;
  }
}
