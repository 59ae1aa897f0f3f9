// Where everything is in the plan, in grid units: computed from line, process, tracks, ends and transfers, and from the positions that a person
// gave. Pure and deterministic, without elements. Time: O(k * (n log n + p)) for n devices, tracks and places, p passes of parts, and k shapes of
// stations that are tried.
import {bareBlock, gridBlock, longBlock, measureLong, stationBlock} from "./blocks.js";
import {shiftInto} from "./cells.js";
import {layered, sizeCost} from "./flow.js";
import {boundsOf, makeInto} from "./geometry.js";
import {putGiven} from "./given.js";
import {joinsOf} from "./joins.js";
import {givenFor, modelOf} from "./model.js";
import {shelves, shelfWidths} from "./pack.js";
import {setBranches, setLengths} from "./tracks.js";
export {overlaps, pointOn, rectOf, slotOf} from "./geometry.js";

const kScreen = 2.1;      // width / height of what a plan should fill: a screen without the head of the page
const kShapes = [.15, .22, .3, .4, .55, .75, 1, 1.3, 1.8, 2.6];  // of the devices of a station
const kMargin = 1;
const kShapeCost = .02;   // of stations that are narrower or wider than
const kUsual = 1.2;
const kRowCost = .04;     // a further shelf is worth it only if the plan gets larger by this part

/// Which tracks run along several stations, and what else belongs to which station: { long: [{ index, stations }], own: by frame, bare }.
const divide = (model) => {
  const {frames, locations} = model;
  const host = frames.map(() => null);
  const own = frames.map(() => []);
  const long = [];
  for (const {index, along, given, location} of locations) {
    if (given || location.kind !== "track" || along.size < 2) continue;
    const free = [...along].filter(([frame]) => host[frame] === null).sort((a, b) => a[1] - b[1] || a[0] - b[0]);
    if (free.length === 0) continue;
    long.push({index, stations: free.map(([frame, at]) => ({frame, at, own: own[frame]}))});
    for (const [frame] of free) host[frame] = index;
  }
  const isLong = new Set(long.map(({index}) => index));
  const bare = [];
  const homes = locations.map(({index, along, given}) => {
    if (given) return "given";
    if (isLong.has(index)) return "long" + index;
    const home = along.size === 1 ? [...along.keys()][0] : null;
    if (home === null) bare.push(index);
    else own[home].push(index);
    return home ?? "bare";
  });
  return {long, own, bare, homes, host};
};

/// Blocks with tracks or places, and grids of devices of stations without.
const makeBlocks = (plant, plan, model, parts, isPlaced, shape) => {
  const {frames, locations} = model;
  const measured = parts.long.map(({stations}) => measureLong(model, stations, shape));
  const unit = Math.max(0, ...measured.map(({needed}, i) => needed / locations[parts.long[i].index].location.length));
  const blocks = parts.long.map(({index}, i) => longBlock(model, index, measured[i], unit));
  const grids = [];
  const givenOf = ({device}) => {
    const given = device === undefined ? undefined : givenFor(plan.devices, plant.devices[device].name);
    return given?.x !== undefined ? [given.x, given.y] : null;
  };
  frames.forEach(({given, things}, frame) => {
    if (given) return;
    if (parts.own[frame].length > 0 && parts.host[frame] === null) blocks.push(stationBlock(model, frame, parts.own[frame], shape));
    else if (parts.host[frame] === null) grids.push(gridBlock(things, frame, shape * 1.6, shiftInto(things.map(givenOf))));
  });
  for (const index of parts.bare) if (locations[index].hangsFrom === null) blocks.push(bareBlock(model, index));
  const loose = model.loose.filter((thing) => !isPlaced(thing));
  if (loose.length > 0) grids.push(gridBlock(loose, null, kScreen, loose.map(() => null)));
  return {blocks, grids, loose};
};

/// Groups of blocks that exchange parts, each laid out: { w, h, emit }.
const makeComponents = (model, blocks) => {
  const blockOf = new Map();
  blocks.forEach(({ports}, block) => { for (const index of ports.keys()) blockOf.set(index, block); });
  const edges = model.passes.filter(({from, to}) => blockOf.has(from) && blockOf.has(to) && blockOf.get(from) !== blockOf.get(to))
    .map(({from, to}) => ({from: blockOf.get(from), to: blockOf.get(to), fy: blocks[blockOf.get(from)].ports.get(from), ty: blocks[blockOf.get(to)].ports.get(to)}));
  const root = blocks.map((_, block) => block);
  const find = (block) => {
    while (root[block] !== block) block = root[block] = root[root[block]];
    return block;
  };
  for (const {from, to} of edges) root[Math.max(find(from), find(to))] = Math.min(find(from), find(to));
  const members = new Map();
  blocks.forEach((_, block) => members.set(find(block), [...members.get(find(block)) ?? [], block]));
  const inner = new Map([...members.keys()].map((key) => [key, []]));
  for (const edge of edges) inner.get(find(edge.from)).push(edge);
  return [...members].map(([key, list]) => {
    const rank = new Map(list.map((block, i) => [block, i]));
    const placed = layered(list.map((block) => blocks[block]), inner.get(key).map((edge) => ({...edge, from: rank.get(edge.from), to: rank.get(edge.to)})), kScreen);
    const emit = (into, out) => list.forEach((block, i) => {
      const {x, y, mirrored} = placed.boxes[i];
      blocks[block].emit(into.inside(x, y, blocks[block].w, mirrored), out);
    });
    return {w: placed.w, h: placed.h, joinCost: placed.joinCost, emit};
  });
};

/// The best arrangement of what has no given position. `isPlaced(thing)`: it has one.
const arrange = (plant, plan, model, isPlaced) => {
  const parts = divide(model);
  setLengths(model);
  setBranches(model, parts.homes);
  let best = null;
  let least = Infinity;
  for (const shape of kShapes) {
    const {blocks, grids} = makeBlocks(plant, plan, model, parts, isPlaced, shape);
    const components = makeComponents(model, blocks);
    const boxes = [...components, ...grids];
    const joins = Math.max(0, ...components.map(({joinCost}) => joinCost));
    for (const wide of shelfWidths(boxes)) {
      const placed = shelves(boxes, wide);
      const rows = new Set(placed.at.map(([, y]) => y)).size;
      const cost = (sizeCost(kScreen, placed.w, placed.h) + joins) * (1 + kRowCost * rows + kShapeCost * Math.abs(Math.log(shape / kUsual)));
      if (cost < least - 1e-9) [best, least] = [{boxes, placed}, cost];
    }
  }
  return best;
};

const makeOut = (plant, frames) => {
  const out = {frames: frames.map(() => null), devices: new Array(plant.devices.length), operators: [], locations: new Array(plant.locations.length)};
  const frameOf = new Map(frames.flatMap(({things}, frame) => things.map((thing) => [thing, frame])));
  out.has = ({device, symbol}) => device !== undefined ? out.devices[device] !== undefined : out.operators.some((operator) => operator.symbol === symbol);
  out.put = (thing, [x, y]) => {
    const frame = frameOf.get(thing) ?? null;
    if (thing.device !== undefined) out.devices[thing.device] = {x, y, turn: 0, frame};
    else out.operators.push({symbol: thing.symbol, x, y, frame});
  };
  return out;
};

/// The layout of a plant; see docs/panel-interface.md for `plan`. `kept`: positions of operated symbols, { x, y } by symbol, relative to their frames; they
/// count where the plan gives the position of the frame, and for those in none. Returns { bounds, frames, devices, operators, locations, joins }.
export const layOut = (plant, plan = {}, kept = new Map()) => {
  const model = modelOf(plant, plan);
  const out = makeOut(plant, model.frames);
  setLengths(model);
  putGiven(plant, plan, model, kept, out);
  const fixed = boundsOf(out);
  const {boxes, placed} = arrange(plant, plan, model, out.has) ?? {boxes: []};
  const [x0, y0] = fixed ? [fixed.x, fixed.y + fixed.h + 2] : [0, 0];
  boxes.forEach((box, i) => box.emit(makeInto(1, x0 + placed.at[i][0], y0 + placed.at[i][1]), out));
  plant.devices.forEach(({name}, device) => {
    const turn = givenFor(plan.devices, name)?.turn;
    if (turn !== undefined) out.devices[device].turn = turn;
  });
  const frames = out.frames.map((frame, i) => ({name: model.frames[i].name, station: model.frames[i].station, ...frame,
    devices: model.frames[i].things.flatMap(({device}) => device === undefined ? [] : [device])}));
  const {x, y, w, h} = boundsOf(out) ?? {x: 0, y: 0, w: 10, h: 6};
  return {bounds: {x: x - kMargin, y: y - kMargin, w: w + 2 * kMargin, h: h + 2 * kMargin}, frames, devices: out.devices, operators: out.operators,
    locations: out.locations, joins: joinsOf(plant, out.locations)};
};
