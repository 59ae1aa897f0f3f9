// Points and rectangles of a layout, in grid units. Pure functions, without elements.
import {kPitch} from "./cells.js";

/// [x, y] of a position in micrometers on a track; `length` is that of the track in micrometers.
export const pointOn = ({x, y, length: drawn, turn}, at, length) => {
  const along = at / length * drawn;
  return [x + [1, 0, -1, 0][turn / 90] * along, y + [0, 1, 0, -1][turn / 90] * along];
};

/// [x, y] of the middle of slot i of a place; further parts are in the last one.
export const slotOf = ({x, y, w, h, columns}, i) => {
  const at = Math.min(i, columns * h - 1);
  return [x + (at % columns + .5) * w / columns, y + Math.floor(at / columns) + .5];
};

/// The rectangle of a track or place.
export const rectOf = (placed) => {
  if (placed.kind === "place") return {x: placed.x, y: placed.y, w: placed.w, h: placed.h + 1};
  const {x, y, length, turn, width} = placed;
  const half = width / 2;
  return [{x, y: y - half, w: length, h: width}, {x: x - half, y, w: width, h: length}, {x: x - length, y: y - half, w: length, h: width},
    {x: x - half, y: y - length, w: width, h: length}][turn / 90];
};

export const overlaps = (a, b) => a.x < b.x + b.w - 1e-6 && b.x < a.x + a.w - 1e-6 && a.y < b.y + b.h - 1e-6 && b.y < a.y + a.h - 1e-6;

/// The rectangle around all that is placed; null if nothing is.
export const boundsOf = (out) => {
  const rects = [...out.frames.filter((frame) => frame), ...out.locations.filter((placed) => placed).map(rectOf),
    ...[...out.devices, ...out.operators].filter((at) => at).map(({x, y}) => ({x: x - kPitch / 2, y: y - kPitch / 2, w: kPitch, h: kPitch}))];
  if (rects.length === 0) return null;
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const {x, y, w, h} of rects) [left, top, right, bottom] = [Math.min(left, x), Math.min(top, y), Math.max(right, x + w), Math.max(bottom, y + h)];
  return {x: left, y: top, w: right - left, h: bottom - top};
};

/// From coordinates in a box to those of the plan; `mirrored`: x runs to the left.
export const makeInto = (sign, at, top) => ({
  mirrored: sign < 0,
  point: (x, y) => [at + sign * x, top + y],
  corner: (x, y, w) => [sign > 0 ? at + x : at - x - w, top + y],
  inside: (x, y, w, mirrored) => makeInto(mirrored ? -sign : sign, at + sign * (mirrored ? x + w : x), top + y),
});
