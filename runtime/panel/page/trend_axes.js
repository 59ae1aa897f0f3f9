// The axes of numbers of the chart, and the styles of its lines. Without elements.
import {ticks} from "./layout.js";

export const kColors = 6;
export const kDashes = [[], [8, 4], [2, 3], [10, 3, 2, 3], [16, 4], [6, 2, 1, 2, 1, 2]];
const kMostTicks = 6;
export const kMostAxes = 4;
const kLarge = 1e5;   // numbers from here on, and those below kSmall, are written with a common power of ten
const kSmall = 1e-2;

/// The color and the dashes of a line. Neighbors differ in both, and no two of 36 lines are the same.
export const dashOf = (rank) => (rank + Math.floor(rank / kColors)) % kDashes.length;
export const lineStyle = (rank) => ({color: "trend" + rank % kColors, dash: kDashes[dashOf(rank)]});

/// The ends of an axis: what is in view, or with `whole` from `min` to `max` of the values that have them.
const endsOf = (rows, view, until, whole) => {
  let [from, to] = [Infinity, -Infinity];
  for (const {data, least, most} of rows) {
    const isFixed = whole && (least !== null || most !== null);
    const extent = isFixed && least !== null && most !== null ? null : data.extent(view.from, Math.min(view.to, until));
    const bounds = isFixed ? [least ?? extent?.[0] ?? most, most ?? extent?.[1] ?? least] : extent;
    if (bounds) [from, to] = [Math.min(from, bounds[0]), Math.max(to, bounds[1])];
  }
  return from > to ? [0, 1] : [from, to];
};

/// The axis of each row: that of its unit. Symbols have no unit, and numbers of one need not compare with those of another: each has its
/// own axis while there are at most `most`, else those of one type share one.
const keysOf = (rows, most) => {
  const units = new Set(rows.filter(({symbol}) => !symbol).map(({unit}) => unit));
  const symbols = rows.filter(({symbol}) => symbol).length;
  const isShared = units.size + symbols > most;
  return rows.map(({symbol, unit, type, name}) => symbol ? "symbol " + (isShared ? type : name) : "unit " + unit);
};

/// The axes of numbers of curves, [{ unit, from, to, ticks, rows }] in the order of their first rows, with room above and below.
export const axesOf = (rows, view, until, whole = false, most = kMostAxes) => {
  const axes = new Map();
  const keys = keysOf(rows, most);
  rows.forEach((row, i) => {
    if (!axes.has(keys[i])) axes.set(keys[i], {unit: row.symbol ? row.type : row.unit || "-", rows: []});
    axes.get(keys[i]).rows.push(row);
  });
  for (const axis of axes.values()) {
    const [from, to] = endsOf(axis.rows, view, until, whole);
    const room = from === to ? Math.max(Math.abs(from) / 10, 1e-3) : (to - from) / 20;
    [axis.from, axis.to] = [from - room, to + room];
    axis.ticks = ticks(axis.from, axis.to, kMostTicks);
  }
  return [...axes.values()];
};

const superscript = (power) => [...String(power)].map((letter) => letter === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[letter]).join("");

/// How an axis is written: { head, texts }, the unit and a text for each tick, as exact as the distance of two ticks needs. Large and
/// small numbers have a common power of ten, which is in the head: "Pa ×10³".
export const axisTexts = ({unit, from, to, ticks: all}) => {
  const size = Math.max(Math.abs(from), Math.abs(to));
  const power = size >= kLarge || size < kSmall ? 3 * Math.floor(Math.log10(size) / 3 + 1e-9) : 0;
  const step = all.length > 1 ? (all[1] - all[0]) / 10 ** power : 1;
  const digits = Math.max(0, Math.min(9, -Math.floor(Math.log10(step) + 1e-9)));
  return {head: unit + (power === 0 ? "" : " ×10" + superscript(power)), texts: all.map((number) => (number / 10 ** power).toFixed(digits))};
};
