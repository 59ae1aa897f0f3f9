// The axes of numbers of the chart, and the styles of its lines. Without elements.
import {ticks} from "./layout.js";

export const kColors = 6;
const kDashes = [[], [7, 4], [2, 3], [9, 3, 2, 3]];

/// The color and the dashes of a line: those that have the same color differ in their dashes.
export const lineStyle = (rank) => ({color: "trend" + rank % kColors, dash: kDashes[Math.floor(rank / kColors) % kDashes.length]});

/// The axes of numbers of the rows, [{ unit, from, to, ticks, rows }] in the order of their first rows: each unit has one, which
/// shows what is in view with room above and below. Without elements.
export const axesOf = (rows, view, until) => {
  const axes = new Map();
  for (const row of rows) {
    const {unit} = row.value;
    if (!axes.has(unit)) axes.set(unit, {unit, from: Infinity, to: -Infinity, rows: []});
    const axis = axes.get(unit);
    axis.rows.push(row);
    const extent = row.data.extent(view.from, Math.min(view.to, until));
    if (extent) [axis.from, axis.to] = [Math.min(axis.from, extent[0]), Math.max(axis.to, extent[1])];
  }
  for (const axis of axes.values()) {
    if (axis.from > axis.to) [axis.from, axis.to] = [0, 1];
    const room = axis.from === axis.to ? Math.max(Math.abs(axis.from) / 10, 1e-3) : (axis.to - axis.from) / 20;
    [axis.from, axis.to] = [axis.from - room, axis.to + room];
    axis.ticks = ticks(axis.from, axis.to, 6);
  }
  return [...axes.values()];
};
