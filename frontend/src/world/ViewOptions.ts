/** What the stage shows beside the bodies, and whether it keeps the selection in the middle. This client's own. */
export type ViewOptions = {
  readonly trails: boolean;
  readonly velocity: boolean;
  readonly force: boolean;
  /** Thrust, course and nearest threat of the ship that was selected last. */
  readonly plan: boolean;
  readonly grid: boolean;
  readonly follow: boolean;
};

export const FIRST_VIEW: ViewOptions = {
  trails: true,
  velocity: true,
  force: false,
  plan: true,
  grid: true,
  follow: false,
};
