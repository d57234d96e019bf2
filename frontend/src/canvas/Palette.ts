/** The colours of the stage. They stand in the design tokens; whoever mounts the canvas hands them in. */
export type Palette = {
  readonly sky: string;
  readonly grid: string;
  readonly wall: string;
  readonly text: string;
  readonly faint: string;
  readonly planet: string;
  readonly planetNight: string;
  readonly planetRim: string;
  readonly rock: string;
  readonly rockRim: string;
  readonly ship: string;
  readonly flame: string;
  readonly select: string;
  readonly order: string;
  readonly threat: string;
  readonly labelFont: string;
};
