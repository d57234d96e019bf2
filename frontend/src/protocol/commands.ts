import type { BodyId } from './frame';

/** What a client may ask of its room. */
export type ClientMessage =
  | { readonly type: 'random-planet' }
  | { readonly type: 'random-asteroid' }
  | { readonly type: 'random-spaceship' }
  | { readonly type: 'random-body' }
  | { readonly type: 'select-body'; readonly id: BodyId; readonly selected: boolean }
  | { readonly type: 'delete-body'; readonly id: BodyId }
  | { readonly type: 'move-selected-spaceships'; readonly x: number; readonly y: number };

/** The commands that add one body each. */
export type AddCommand = Extract<ClientMessage['type'], `random-${string}`>;

/** A command as STOMP carries it. */
export type Send = { readonly destination: string; readonly body: string };

/** Writes a command for the wire; commands that only add have no body. */
export function encode(message: ClientMessage): Send {
  const { type, ...fields } = message;
  const isEmpty = Object.keys(fields).length === 0;
  return { destination: `/app/${type}`, body: isEmpty ? '' : JSON.stringify(fields) };
}
