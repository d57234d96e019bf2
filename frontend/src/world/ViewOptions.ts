/** What the stage shows beside the bodies, and whether it keeps the selection in the middle. This client's own. */
export type ViewOptions = {
  readonly trails: boolean;
  readonly velocity: boolean;
  readonly force: boolean;
  readonly grid: boolean;
  readonly follow: boolean;
};

export const FIRST_VIEW: ViewOptions = { trails: true, velocity: true, force: false, grid: true, follow: false };
