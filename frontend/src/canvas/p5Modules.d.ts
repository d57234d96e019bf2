// p5's parts have no types of their own, and the types of the whole package declare every function as a global.
// These are the members that we use.
declare module 'p5/core' {
  export type Addon = () => void;

  export default class P5 {
    constructor(sketch: (p: P5) => void, host: HTMLElement);
    static registerAddon(addon: Addon): void;
    setup: () => void;
    draw: () => void;
    readonly width: number;
    readonly height: number;
    readonly drawingContext: CanvasRenderingContext2D;
    createCanvas(width: number, height: number): { readonly elt: HTMLCanvasElement };
    resizeCanvas(width: number, height: number, noRedraw?: boolean): void;
    pixelDensity(density: number): void;
    remove(): void;
  }
}

declare module 'p5/accessibility' {
  const addon: import('p5/core').Addon;
  export default addon;
}

declare module 'p5/math' {
  const addon: import('p5/core').Addon;
  export default addon;
}

declare module 'p5/events' {
  const addon: import('p5/core').Addon;
  export default addon;
}
