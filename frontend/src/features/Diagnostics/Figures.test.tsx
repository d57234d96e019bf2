import { act, render, screen, within } from '@testing-library/react';
import userEvent from '@testing-library/user-event';
import { expect, it } from 'vitest';
import { World } from '../../world/World';
import { Figures } from './Figures';
import { FigureTable } from './FigureTable';

const link = { delayMs: 18, bytesPerSecond: 412_000 };

const measured = {
  tick: 19260,
  time: 128.4,
  ticksPerSecond: 150,
  tickMillis: { p50: 0.25, p99: 0.75 },
  lateTicks: 2,
  droppedTicks: 0,
  speed: 0.62,
  bodies: 248,
  clients: 3,
  kinetic: 240_000,
  potential: -365_000,
  energy: -125_000,
  energyDrift: 2.5e-6,
  momentum: { x: 1.5, y: -0.25 },
  momentumDrift: 3.5e-13,
  angularMomentum: -8.4e6,
  angularMomentumDrift: -1.5e-12,
  centreOfMassX: 12.5,
  centreOfMassY: -3.25,
  virialRatio: 1.3125,
  gravitySolver: 'direct',
  forceError: null,
};

const unmeasured = {
  ...measured,
  kinetic: null,
  potential: null,
  energy: null,
  energyDrift: null,
  momentum: null,
  momentumDrift: null,
  angularMomentum: null,
  angularMomentumDrift: null,
  centreOfMassX: null,
  centreOfMassY: null,
  virialRatio: null,
  gravitySolver: 'none',
};

function figure(label: string, place = within(document.body)): HTMLElement | null {
  return place.getByText(label, { selector: 'dt' }).nextElementSibling as HTMLElement | null;
}

it('shows_how_the_room_and_the_link_are_doing', () => {
  const world = new World();
  render(<Figures world={world} link={link} />);
  act(() => world.history.add(measured));

  expect(figure('Bodies')).toHaveTextContent('248');
  expect(figure('Tick')).toHaveTextContent('0.25 ms');
  expect(figure('Energy')).toHaveTextContent('−125 000');
  expect(figure('Energy drift')).toHaveTextContent('+2.5e−6');
  expect(figure('Momentum drift')).toHaveTextContent('+3.5e−13');
  expect(figure('Angular drift')).toHaveTextContent('−1.5e−12');
  expect(figure('Virial ratio')).toHaveTextContent('1.31');
  expect(figure('Delay')).toHaveTextContent('18 ms');
});

it('a_button_opens_all_figures_and_escape_closes_them', async () => {
  const user = userEvent.setup();
  const world = new World();
  world.history.add(measured);
  render(<Figures world={world} link={link} />);
  const button = screen.getByRole('button', { name: 'All figures' });
  expect(button).toHaveAttribute('aria-expanded', 'false');
  expect(screen.queryByRole('region', { name: 'All figures' })).toBeNull();

  await user.tab();
  await user.keyboard('{Enter}');

  expect(button).toHaveAttribute('aria-expanded', 'true');
  const table = within(screen.getByRole('region', { name: 'All figures' }));
  expect(figure('Angular momentum', table)).toHaveTextContent('−8 400 000');
  expect(figure('Centre of mass', table)).toHaveTextContent('12.50, −3.25');

  await user.keyboard('{Escape}');

  expect(button).toHaveAttribute('aria-expanded', 'false');
  expect(button).toHaveFocus();
});

it('the_table_has_every_figure_once', () => {
  const world = new World();
  world.history.add(measured);
  render(<FigureTable world={world} link={link} />);

  expect(figure('Kinetic')).toHaveTextContent('240 000');
  expect(figure('Potential')).toHaveTextContent('−365 000');
  expect(figure('Total')).toHaveTextContent('−125 000');
  expect(figure('Momentum')).toHaveTextContent('1.50, −0.250');
  expect(figure('Gravity')).toHaveTextContent('direct');
  expect(figure('Force error')).toHaveTextContent('none');
  expect(figure('Late, dropped')).toHaveTextContent('2, 0');
  expect(figure('Clock')).toHaveTextContent('62 % of real time');
  expect(figure('Stream')).toHaveTextContent('412 kB/s');
  expect(figure('Clients')).toHaveTextContent('3');
});

it('a_scene_without_energy_says_none', () => {
  const world = new World();
  world.history.add(unmeasured);
  render(<Figures world={world} link={null} />);

  expect(figure('Energy')).toHaveTextContent('none');
  expect(figure('Energy drift')).toHaveTextContent('none');
  expect(figure('Angular drift')).toHaveTextContent('none');
  expect(figure('Virial ratio')).toHaveTextContent('none');
  expect(figure('Delay')).toHaveTextContent('none');
});

it('before_the_first_diagnostics_the_table_says_none', () => {
  render(<FigureTable world={new World()} link={null} />);

  expect(figure('Total')).toHaveTextContent('none');
  expect(figure('Gravity')).toHaveTextContent('none');
});
