import type { RoomClient } from './RoomClient';

/** Shows the part of the world that the scene calls worth looking at. */
export function fitRoom({ world, camera }: RoomClient, stage: HTMLElement): void {
  const room = world.room.current();
  if (!room) return;
  // The room may answer before the first picture is drawn, and only drawing measures the stage.
  camera.resize(stage.clientWidth, stage.clientHeight);
  camera.fit(room.view);
}

/** Shows all bodies; in an empty world what the scene calls worth looking at. */
export function fitBodies({ world, camera }: RoomClient): void {
  const { count, x, y, radius } = world.frames.newest;
  const room = world.room.current();
  if (count === 0) {
    if (room) camera.fit(room.view);
    return;
  }
  const bounds = { minX: Infinity, minY: Infinity, maxX: -Infinity, maxY: -Infinity };
  for (let i = 0; i < count; i++) {
    bounds.minX = Math.min(bounds.minX, x[i]! - radius[i]!);
    bounds.minY = Math.min(bounds.minY, y[i]! - radius[i]!);
    bounds.maxX = Math.max(bounds.maxX, x[i]! + radius[i]!);
    bounds.maxY = Math.max(bounds.maxY, y[i]! + radius[i]!);
  }
  if (world.view.current().follow) world.toggleView('follow');
  camera.fit(bounds);
}
