// Tracks and places as boxes of a layout: how long they are drawn, which hang from another, and where they are within a frame.
// Pure functions, without elements.
import {layered} from "./flow.js";

export const kBand = 2;     // the height of a belt with what is next to it: sensors, motors
export const kBelt = .8;    // the width of a belt
const kLeast = 4;           // lengths of belts
const kMost = 20;
const kMedian = 7;          // of belts in one station
const kBranchGap = 2.5;     // between two tracks that hang from a belt
const kPlaceEdge = .5;      // above and below a place, for its sensors and its name
const kMostSlots = 12;      // of a place that are drawn

/// How a place is drawn: its columns and rows of slots.
export const slotsOf = ({holds}) => {
  const count = Math.max(1, Math.min(holds ?? 1, kMostSlots));
  const columns = count <= 3 ? count : Math.ceil(Math.sqrt(count * 1.5));
  return {columns, rows: Math.ceil(count / columns)};
};

/// Grid units for a micrometer, of tracks that are not along several stations.
const unitOf = (tracks) => {
  const lengths = tracks.map(({location}) => location.length).sort((a, b) => a - b);
  return lengths.length === 0 ? 1 : kMedian / lengths[lengths.length >> 1];
};

const clamp = (value, least, most) => Math.max(least, Math.min(most, value));

/// Sets `length`, in grid units, of each track of the model that has no given one.
export const setLengths = ({locations}) => {
  const tracks = locations.filter(({location}) => location.kind === "track");
  const unit = unitOf(tracks.filter(({along}) => along.size < 2));
  for (const track of tracks) {
    track.length = track.given?.length ?? Math.round(2 * clamp(track.location.length * unit, Math.max(kLeast, track.location.sensors.length), kMost)) / 2;
  }
};

/// Sets `branches` of each track: the tracks that it feeds in its middle, that feed none, and that hang from it. Both are in one box.
export const setBranches = ({locations, passes}, boxOf) => {
  const incoming = locations.map(() => []);
  const outgoing = locations.map(() => 0);
  for (const pass of passes) {
    incoming[pass.to].push(pass);
    outgoing[pass.from] += 1;
  }
  for (const track of locations) Object.assign(track, {branches: [], hangsFrom: null});
  for (const child of locations) {
    const [pass] = incoming[child.index];
    if (child.location.kind !== "track" || child.given || incoming[child.index].length !== 1 || outgoing[child.index] > 0 || pass.isEnd || pass.into > 0) continue;
    const parent = locations[pass.from];
    const {length} = parent.location;
    if (parent.given || parent.location.kind !== "track" || boxOf[pass.from] !== boxOf[child.index] || pass.at < .1 * length || pass.at > .95 * length) continue;
    parent.branches.push({child, at: pass.at});
  }
  for (const parent of locations) {
    const {length} = parent.location;
    parent.branches.sort((a, b) => a.at - b.at || a.child.index - b.child.index);
    parent.branches = parent.branches.filter(({at}, i, all) => i === 0 || at - all[i - 1].at >= length * kBranchGap / (1.5 * kMost));
    parent.branches.forEach(({child, at}, i, all) => {
      child.hangsFrom = parent.index;
      if (i > 0) parent.length = Math.max(parent.length, Math.ceil(2 * kBranchGap * length / (at - all[i - 1].at)) / 2);
    });
  }
};

/// The box of a track or place within its surroundings: { w, h, axis, left }.
const boxOf = ({location, length, branches}) => {
  if (location.kind === "place") {
    const {columns, rows} = slotsOf(location);
    return {w: Math.max(columns, 2), h: rows + 2 * kPlaceEdge + .5, axis: rows / 2 + kPlaceEdge, left: 0};
  }
  const xs = branches.map(({at}) => at / location.length * length);
  const left = Math.max(0, 1 - Math.min(...xs, 1));
  return {w: left + Math.max(length, ...xs.map((x) => x + 1)), left, axis: kBand / 2,
    h: kBand + Math.max(0, ...branches.map(({child}) => child.length + .5))};
};

/// The tracks and places of one frame, or one of them with what hangs from it: { w, h, ports, x(index, position), emit(into, out) }. `ports` has the
/// heights at which parts come and go, by location.
export const flowBox = (model, indexes, shape) => {
  const {locations} = model;
  const shown = indexes.filter((index) => locations[index].hangsFrom === null);
  const rank = new Map(shown.map((index, i) => [index, i]));
  const nodes = shown.map((index) => boxOf(locations[index]));
  const edges = model.passes.filter(({from, to}) => rank.has(from) && rank.has(to))
    .map(({from, to}) => ({from: rank.get(from), to: rank.get(to), fy: nodes[rank.get(from)].axis, ty: nodes[rank.get(to)].axis}));
  const {w, h, boxes} = layered(nodes, edges, shape);
  const ports = new Map(shown.map((index, i) => [index, boxes[i].y + nodes[i].axis]));
  shown.forEach((index, i) => locations[index].branches.forEach(({child}) => ports.set(child.index, boxes[i].y + nodes[i].axis)));
  const inBox = (i, x) => boxes[i].mirrored ? boxes[i].x + nodes[i].w - x : boxes[i].x + x;
  const x = (index, position) => {
    const {hangsFrom, location, length} = locations[index];
    if (hangsFrom !== null) return x(hangsFrom, locations[hangsFrom].branches.find(({child}) => child.index === index).at);
    const i = rank.get(index);
    return inBox(i, location.kind === "place" ? nodes[i].w / 2 : nodes[i].left + position / location.length * length);
  };
  const emit = (into, out) => shown.forEach((index, i) => {
    const {location, length, branches} = locations[index];
    const box = into.inside(boxes[i].x, boxes[i].y, nodes[i].w, boxes[i].mirrored);
    if (location.kind === "place") return emitPlace(box, index, location, nodes[i].w, out);
    emitTrack(box, index, nodes[i].left, kBand / 2, length, out);
    for (const {child, at} of branches) {
      const [cx, cy] = box.point(nodes[i].left + at / location.length * length, kBand / 2 + .5);
      out.locations[child.index] = {kind: "track", x: cx, y: cy, length: child.length, turn: 90, width: kBelt};
    }
  });
  return {w, h, ports, x, emit};
};

export const emitTrack = (into, index, x, y, length, out) => {
  const [tx, ty] = into.point(x, y);
  out.locations[index] = {kind: "track", x: tx, y: ty, length, turn: into.mirrored ? 180 : 0, width: kBelt};
};

const emitPlace = (into, index, location, wide, out) => {
  const {columns, rows} = slotsOf(location);
  const [x, y] = into.corner((wide - columns) / 2, kPlaceEdge, columns);
  out.locations[index] = {kind: "place", x, y, w: columns, h: rows, columns};
};
