import accessibility from 'p5/accessibility';
import P5 from 'p5/core';
import events from 'p5/events';
import math from 'p5/math';
import { type RefObject, useEffect, useRef } from 'react';

// The core alone throws on start: these three belong to it. 127 kB gzip where the whole of p5 has 344.
for (const addon of [accessibility, math, events]) P5.registerAddon(addon);

/** What is drawn: `setup` once, `draw` with every animation frame. */
export type Sketch = (p: P5, host: HTMLElement) => { setup: () => void; draw: () => void };

const MAX_DENSITY = 2;

/**
 * Runs one p5 sketch inside an element.
 *
 * p5 starts asynchronously, and `remove()` does nothing before it has started; a plain effect therefore leaves a second
 * canvas under StrictMode, and a loop that survives unmounting. So the start waits for one task, and a dead sketch does
 * not draw. Mount it once per page, with a sketch that never changes.
 */
export function useP5(sketch: Sketch): RefObject<HTMLDivElement | null> {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = host.current!;
    let p: P5 | undefined;
    let isDead = false;
    const timer = setTimeout(() => {
      p = new P5((q) => {
        const { setup, draw } = sketch(q, element);
        q.setup = () => {
          if (isDead) return;
          q.pixelDensity(Math.min(devicePixelRatio, MAX_DENSITY));
          setup();
        };
        q.draw = () => {
          if (!isDead) draw();
        };
      }, element);
    }, 0);
    const resized = new ResizeObserver(() => {
      const { clientWidth, clientHeight } = element;
      if (!p?.drawingContext || !clientWidth || !clientHeight) return;
      if (p.width === clientWidth && p.height === clientHeight) return;
      p.pixelDensity(Math.min(devicePixelRatio, MAX_DENSITY));
      p.resizeCanvas(clientWidth, clientHeight, true);
    });
    resized.observe(element);
    return () => {
      isDead = true;
      clearTimeout(timer);
      resized.disconnect();
      p?.remove();
    };
  }, [sketch]);
  return host;
}
