import type { Camera } from './Camera';

/** What a hand on the stage means. Coordinates in pixels of the stage. */
export type Intents = {
  onTap(x: number, y: number, slackPx: number, isAdding: boolean): void;
  onHover(x: number, y: number): void;
  onLeave(): void;
  /** The user moved the picture, so following ends. */
  onPan(): void;
};

const TAP_MOVES_LESS_THAN_PX = 4;
const FINGER_MOVES_LESS_THAN_PX = 10;
const TAP_MS = 300;
const FINGER_TAP_MS = 500;
/** A finger has no Shift: one that rests this long at most adds to the selection. */
const LONG_PRESS_MS = 2000;
const MOUSE_SLACK_PX = 3;
/** With more, there would be no empty space left between 250 bodies on a phone. */
const FINGER_SLACK_PX = 14;
const WHEEL_ZOOM = 0.0015; // share per pixel of scrolling

/**
 * Turns pointers into intents: tap, pan, wheel and pinch. Returns how to stop listening.
 *
 * A tap is short and hardly moves; all else is a drag. Two fingers pan with their middle and zoom with their distance.
 */
export function listenToGestures(host: HTMLElement, camera: Camera, intents: Intents): () => void {
  const fingers = new Map<number, { x: number; y: number }>();
  let start = { x: 0, y: 0, ms: 0 };
  let isDrag = false;

  const at = (event: PointerEvent | WheelEvent) => {
    const box = host.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };

  function down(event: PointerEvent): void {
    if (event.button !== 0) return;
    host.setPointerCapture(event.pointerId);
    // Focus that a script moves away from a text field counts as the keyboard's; a press must not draw its outline.
    host.dataset.pressed = 'true';
    host.focus({ preventScroll: true });
    fingers.set(event.pointerId, at(event));
    isDrag = fingers.size > 1;
    start = { ...at(event), ms: event.timeStamp };
  }

  function move(event: PointerEvent): void {
    const now = at(event);
    const before = fingers.get(event.pointerId);
    if (!before) {
      intents.onHover(now.x, now.y);
      return;
    }
    const limit = event.pointerType === 'mouse' ? TAP_MOVES_LESS_THAN_PX : FINGER_MOVES_LESS_THAN_PX;
    if (!isDrag && Math.hypot(now.x - start.x, now.y - start.y) < limit) return;
    isDrag = true;
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
    if (other) pinch(before, now, other);
    else camera.panBy(now.x - before.x, now.y - before.y);
    intents.onPan();
    fingers.set(event.pointerId, now);
  }

  function pinch(before: Point, now: Point, other: Point): void {
    const factor = distance(now, other) / Math.max(1, distance(before, other));
    camera.panBy((now.x - before.x) / 2, (now.y - before.y) / 2);
    camera.zoomAt((now.x + other.x) / 2, (now.y + other.y) / 2, factor);
  }

  function up(event: PointerEvent): void {
    if (!fingers.delete(event.pointerId) || isDrag) return;
    const isMouse = event.pointerType === 'mouse';
    const heldMs = event.timeStamp - start.ms;
    if (heldMs > (isMouse ? TAP_MS : LONG_PRESS_MS)) return;
    const { x, y } = at(event);
    const isAdding = event.shiftKey || event.ctrlKey || event.metaKey || (!isMouse && heldMs > FINGER_TAP_MS);
    intents.onTap(x, y, isMouse ? MOUSE_SLACK_PX : FINGER_SLACK_PX, isAdding);
  }

  function wheel(event: WheelEvent): void {
    event.preventDefault();
    const { x, y } = at(event);
    const linePx = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    camera.zoomAt(x, y, Math.exp(-event.deltaY * linePx * WHEEL_ZOOM));
  }

  const stop = new AbortController();
  const { signal } = stop;
  host.addEventListener('pointerdown', down, { signal });
  host.addEventListener('pointermove', move, { signal });
  host.addEventListener('pointerup', up, { signal });
  host.addEventListener('pointercancel', (event) => fingers.delete(event.pointerId), { signal });
  host.addEventListener('pointerleave', () => intents.onLeave(), { signal });
  host.addEventListener('keydown', () => delete host.dataset.pressed, { signal });
  host.addEventListener('blur', () => delete host.dataset.pressed, { signal });
  // A long press is ours; so is Ctrl and click on a Mac.
  host.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
  host.addEventListener('wheel', wheel, { passive: false, signal });
  return () => stop.abort();
}

type Point = { readonly x: number; readonly y: number };

function distance(a: Point, b: Point): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}
