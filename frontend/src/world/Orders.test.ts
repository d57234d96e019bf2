import { expect, it } from 'vitest';
import { FrameColumns } from './FrameColumns';
import { Orders } from './Orders';
import { bodyId, frame, ship } from './testFrames';

const target = { x: 612, y: 208 };

function columns(...bodies: Parameters<typeof ship>[3][]): FrameColumns {
  const filled = new FrameColumns();
  filled.fill(frame(0, ...bodies.map((more, i) => ship(i + 1, 0, 0, more))), new FrameColumns());
  return filled;
}

function given(): Orders {
  const orders = new Orders();
  orders.give(target, [bodyId(1)], 0);
  return orders;
}

it('an_order_is_there_at_once_and_not_confirmed', () => {
  expect(given().pending(1)).toMatchObject({ ...target, isConfirmed: false });
});

it('a_reply_confirms_it', () => {
  const orders = given();
  orders.confirm();
  expect(orders.pending(1)?.isConfirmed).toBe(true);
});

it('the_frame_takes_over_once_it_shows_the_target', () => {
  const orders = given();
  orders.seen(columns({}));
  expect(orders.pending(1)).not.toBeNull();

  orders.seen(columns({ target }));
  expect(orders.pending(1)).toBeNull();
});

it('the_target_of_an_older_order_confirms_nothing', () => {
  const orders = given();
  orders.seen(columns({ target: { x: -500, y: 0 } }));
  expect(orders.pending(1)).not.toBeNull();
});

it('a_refusal_takes_the_marker_away', () => {
  const orders = given();
  orders.refuse();
  expect(orders.pending(1)).toBeNull();
});

it('an_order_that_nobody_answers_is_given_up', () => {
  expect(given().pending(10_000)).toBeNull();
});
