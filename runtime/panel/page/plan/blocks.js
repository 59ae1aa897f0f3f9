// The blocks of a plan: a long track with the stations that it passes, a station around its tracks and places, or a grid of devices.
// Pure functions, without elements.
import {assignCells, columnsFor, fillCells, kFoot, kHead, kPitch, kSide, widthOf} from "./cells.js";
import {spread} from "./flow.js";
import {emitTrack, flowBox, kBand} from "./tracks.js";

const kFrameGap = 1;
const kMostStretch = 2;  // of a long track, against the sum of its stations

const emitFrame = (into, frame, x, y, w, h, out) => {
  const [fx, fy] = into.corner(x, y, w);
  out.frames[frame] = {x: fx, y: fy, w, h};
};

/// Gives each thing its center.
const emitThings = (into, things, centers, out) => things.forEach((thing, i) => out.put(thing, into.point(...centers[i])));

/// How many rows of devices are above and below the tracks of a station.
const rowsOf = (count, columns) => {
  const rows = Math.ceil(count / columns);
  return {above: Math.ceil(rows / 2), below: Math.floor(rows / 2)};
};

/// The centers of a station's things in the rows above and below what is between `top` and `bottom`; `wishOf(act)` is where a device acts, or null.
const stationCells = (model, things, columns, {above, below}, x, top, bottom, wishOf) => {
  const rows = [];
  for (let i = 0; i < Math.max(above, below); ++i) {
    if (i < above) rows.push(top - (i + .5) * kPitch);
    if (i < below) rows.push(bottom + (i + .5) * kPitch);
  }
  const order = rows.map((_, i) => i).sort((a, b) => rows[a] - rows[b]);
  const wants = things.map(({device}) => device !== undefined && model.acts[device] ? wishOf(model.acts[device]) : null);
  return assignCells(wants, columns, x, rows, order);
};

/// A station around its tracks and places.
export const stationBlock = (model, frame, own, shape) => {
  const {things} = model.frames[frame];
  const flow = flowBox(model, own, 1.6);
  const columns = Math.max(columnsFor(things.length, shape), Math.floor(flow.w / kPitch));
  const rows = rowsOf(things.length, columns);
  const w = Math.max(widthOf(columns), flow.w + 2 * kSide);
  const top = kHead + rows.above * kPitch;
  const h = top + flow.h + rows.below * kPitch + kFoot;
  const left = (w - flow.w) / 2;
  const ports = new Map([...flow.ports].map(([index, y]) => [index, y + top]));
  const emit = (into, out) => {
    emitFrame(into, frame, 0, 0, w, h, out);
    flow.emit(into.inside(left, top, flow.w, false), out);
    const wishOf = ({location, position}) => flow.ports.has(location) ? left + flow.x(location, position) : null;
    emitThings(into, things, stationCells(model, things, columns, rows, (w - columns * kPitch) / 2, top, top + flow.h, wishOf), out);
  };
  return {w, h, axis: top + kBand / 2, ports, emit};
};

/// A track along several stations, { frame, at, own } in order; each station is a frame across the belt.
const longStations = (model, stations, shape) => stations.map(({frame, at, own}) => {
  const {things} = model.frames[frame];
  const flow = own.length > 0 ? flowBox(model, own, 1) : null;
  const columns = Math.max(columnsFor(things.length, shape), Math.floor((flow?.w ?? 0) / kPitch));
  return {frame, at, flow, columns, things, rows: rowsOf(things.length, columns), w: Math.max(widthOf(columns), (flow?.w ?? 0) + 2 * kSide)};
});

/// The widths of all stations of a long track with the gaps between them, and the stations.
export const measureLong = (model, stations, shape) => {
  const shown = longStations(model, stations, shape);
  return {shown, needed: shown.reduce((sum, {w}) => sum + w + kFrameGap, 1)};
};

/// `unit`: grid units for a micrometer.
export const longBlock = (model, index, {shown, needed}, unit) => {
  const {location} = model.locations[index];
  const length = Math.round(2 * Math.max(needed, Math.min(kMostStretch * needed, location.length * unit))) / 2;
  const begins = spread(shown.map(({at, w}) => ({want: at / location.length * length - w / 2, size: w})), kFrameGap).map((x) => Math.round(x * 2) / 2);
  const first = Math.min(0, ...begins);
  const last = Math.max(length, ...begins.map((x, i) => x + shown[i].w));
  const top = kHead + Math.max(...shown.map(({rows}) => rows.above)) * kPitch;
  const bottom = top + kBand;
  const h = bottom + Math.max(...shown.map(({rows, flow}) => rows.below * kPitch + (flow?.h ?? 0))) + kFoot;
  const ports = new Map([[index, top + kBand / 2]]);
  for (const {flow} of shown) for (const [own, y] of flow?.ports ?? []) ports.set(own, y + bottom);
  const xAt = (position) => position / location.length * length - first;
  const emit = (into, out) => {
    emitTrack(into, index, -first, top + kBand / 2, length, out);
    shown.forEach(({frame, flow, columns, things, rows, w}, i) => {
      const x = begins[i] - first;
      const left = x + (w - (flow?.w ?? 0)) / 2;
      emitFrame(into, frame, x, 0, w, h, out);
      flow?.emit(into.inside(left, bottom, flow.w, false), out);
      const wishOf = ({location: at, position}) => at === index ? xAt(position) : flow?.ports.has(at) ? left + flow.x(at, position) : null;
      emitThings(into, things, stationCells(model, things, columns, rows, x + (w - columns * kPitch) / 2, top, bottom + (flow?.h ?? 0), wishOf), out);
    });
  };
  return {w: last - first, h, axis: top + kBand / 2, ports, emit};
};

/// A track or place in no station, with what hangs from it.
export const bareBlock = (model, index) => {
  const flow = flowBox(model, [index], 1.6);
  return {w: flow.w, h: flow.h, axis: flow.ports.get(index), ports: flow.ports, emit: flow.emit};
};

/// Things in rows and columns; `frame`: null for those in none. Things with a center in `given`, relative to the corner, keep it.
export const gridBlock = (things, frame, shape, given, isFree) => {
  const columns = columnsFor(things.length, shape);
  const centers = fillCells(given, columns, kSide, kHead, isFree);
  const w = Math.max(2, ...centers.map(([x]) => x + kPitch / 2)) + kSide;
  const h = Math.max(kHead + kPitch, ...centers.map(([, y]) => y + kPitch / 2)) + kFoot;
  const emit = (into, out) => {
    if (frame !== null) emitFrame(into, frame, 0, 0, w, h, out);
    emitThings(into, things, centers, out);
  };
  return {w, h, emit};
};
