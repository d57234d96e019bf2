import { act, render, screen } from '@testing-library/react';
import { expect, it } from 'vitest';
import { World } from '../../world/World';
import { Figures } from './Figures';

const diagnostics = {
  tick: 19260,
  time: 128.4,
  ticksPerSecond: 150,
  tickMillis: { p50: 0.25, p99: 0.75 },
  lateTicks: 2,
  droppedTicks: 0,
  bodies: 248,
  clients: 3,
  energy: null,
  energyDrift: null,
  momentum: { x: 1, y: 0 },
  momentumDrift: 3.5e-13,
};

function figure(label: string): HTMLElement | null {
  return screen.getByText(label).nextElementSibling as HTMLElement | null;
}

it('shows_how_the_room_and_the_link_are_doing', () => {
  const world = new World();
  render(<Figures world={world} link={{ delayMs: 18, bytesPerSecond: 412_000 }} />);
  act(() => world.history.add(diagnostics));

  expect(figure('Bodies')).toHaveTextContent('248');
  expect(figure('Tick')).toHaveTextContent('0.25 ms');
  expect(figure('Momentum drift')).toHaveTextContent('+3.5e−13');
  expect(figure('Delay')).toHaveTextContent('18 ms');
  expect(figure('Stream')).toHaveTextContent('412 kB/s');
});

it('a_scene_without_energy_says_none', () => {
  const world = new World();
  world.history.add(diagnostics);
  render(<Figures world={world} link={null} />);

  expect(figure('Energy drift')).toHaveTextContent('none');
  expect(figure('Delay')).toHaveTextContent('none');
});
