/** A size token in pixels, for what is laid out by script; `fallback` where there is no style sheet, as in unit tests. */
export function tokenPx(name: string, fallback: number): number {
  const px = Number.parseFloat(getComputedStyle(document.documentElement).getPropertyValue(name));
  return Number.isFinite(px) ? px : fallback;
}
