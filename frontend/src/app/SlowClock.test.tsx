import { render, screen } from '@testing-library/react';
import { expect, it } from 'vitest';
import { SlowClock } from './Header';

it('a_clock_that_runs_slower_than_real_time_says_so', () => {
  render(<SlowClock speed={0.62} />);

  const note = screen.getByText('62 % speed');
  expect(note).toBeVisible();
  expect(note).toHaveAttribute('title', expect.stringContaining('62 % of real time'));
});

it('a_clock_that_keeps_up_says_nothing', () => {
  const { container } = render(<SlowClock speed={1} />);

  expect(container).toBeEmptyDOMElement();
});
