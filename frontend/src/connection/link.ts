/** What the page may honestly say about its link to the room. */
export type Link =
  | { readonly state: 'connecting' }
  | {
      readonly state: 'live';
      /** Frames per second that really arrive. */
      readonly hz: number;
      readonly delayMs: number;
      readonly bytesPerSecond: number;
    }
  | {
      readonly state: 'disconnected';
      /** Whether this page ever had a link; without one there is no last frame to look at. */
      readonly hadLink: boolean;
      /** When the next attempt begins, by Date.now(); null while an attempt is running. */
      readonly retryAtMs: number | null;
    };

/** Above this the link is called slow: orders visibly lag behind the hand. */
export const SLOW_DELAY_MS = 200;
