/** The colours and the font of the stage, as tokens.css has them. A canvas cannot use custom properties by itself. */
export function canvasTokens() {
  const style = getComputedStyle(document.documentElement);
  const token = (name: string) => style.getPropertyValue(name).trim();
  return {
    sky: token('--sky'),
    grid: token('--grid'),
    wall: token('--wall'),
    text: token('--text'),
    faint: token('--faint'),
    planet: token('--planet'),
    planetNight: token('--planet-night'),
    planetRim: token('--planet-rim'),
    rock: token('--rock'),
    rockRim: token('--rock-rim'),
    ship: token('--ship'),
    flame: token('--flame'),
    select: token('--select'),
    order: token('--order'),
    threat: token('--threat'),
    labelFont: token('--label-font'),
  };
}
