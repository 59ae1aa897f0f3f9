// The things of a plan: which is under a pointer, which has the focus, and what a screen reader says of it. Without elements.
import {neighbor} from "../layout.js";
import {cellOf} from "./cells.js";
import {pointOn, rectOf} from "./geometry.js";
import {STATUSES} from "../status.js";
import {stateText} from "../tile.js";
import {countsByKind} from "../place.js";
import {count, value} from "../words.js";

const kReach = .6;    // grid units around the middle of a symbol
const kSensor = .45;
const kName = .5;     // below the top of a frame: its name

const isIn = ({x, y, w, h}, [px, py]) => px >= x && px <= x + w && py >= y && py <= y + h;

/// The sensor of a track at a point, or undefined.
const sensorAt = (plant, placed, index, [px, py]) => {
  const location = plant.locations[index];
  const [dx, dy] = [[0, -1], [1, 0], [0, 1], [-1, 0]][placed.turn / 90];
  return location.sensors.find(({at}) => {
    const [x, y] = pointOn(placed, at, location.length);
    return Math.hypot(px - x - dx * .65, py - y - dy * .65) < kSensor;
  });
};

/// What is at a point of the plan: { kind, index }, `kind` device, symbol, location or frame; null.
export const pick = (plant, placed, point) => {
  const near = ({x, y}) => Math.abs(x - point[0]) <= kReach && point[1] >= y - kReach && point[1] <= y + 1.2;
  const device = placed.devices.findLastIndex(near);
  if (device >= 0) return {kind: "device", index: device};
  const operator = placed.operators.find(near);
  if (operator) return {kind: "symbol", index: operator.symbol};
  for (let index = placed.locations.length - 1; index >= 0; --index) {
    const location = placed.locations[index];
    const sensor = location.kind === "track" ? sensorAt(plant, location, index, point) : undefined;
    if (sensor) return {kind: "symbol", index: sensor.symbol};
    if (isIn(rectOf(location), point)) return {kind: "location", index};
  }
  const frame = placed.frames.findLastIndex((box) => isIn(box, point));
  return frame >= 0 ? {kind: "frame", index: frame} : null;
};

/// All things that can have the focus, each with the middle of its symbol.
export const thingsOf = (placed) => [
  ...placed.devices.map(({x, y}, index) => ({kind: "device", index, at: [x, y]})),
  ...placed.operators.map(({symbol, x, y}) => ({kind: "symbol", index: symbol, at: [x, y]})),
  ...placed.locations.map((location, index) => {
    const {x, y, w, h} = rectOf(location);
    return {kind: "location", index, at: [x + w / 2, y + h / 2]};
  }),
  ...placed.frames.map(({x, y, w}, index) => ({kind: "frame", index, at: [x + w / 2, y + kName]}))];

/// The rectangle of a thing.
export const boxOf = (placed, {kind, index}) => {
  if (kind === "frame") return placed.frames[index];
  if (kind === "location") return rectOf(placed.locations[index]);
  const at = kind === "device" ? placed.devices[index] : placed.operators.find(({symbol}) => symbol === index);
  return at ? cellOf(at) : null;
};

/// The thing to which an arrow key leads; the first thing without a focus.
export const nextThing = (things, focused, key) => {
  const from = focused ? things.findIndex(({kind, index}) => kind === focused.kind && index === focused.index) : -1;
  if (from < 0) return things[0] ?? null;
  return things[neighbor(things.map(({at}) => at), from, key)];
};

/// What a screen reader says: name, kind, state.
export const describe = ({plant, store, statuses}, placed, {kind, index}) => {
  if (kind === "device") {
    const device = plant.devices[index];
    return [device.name, device.shape, stateText(store, index), STATUSES[statuses.of[index]].text].filter((text) => text !== "").join(", ");
  }
  if (kind === "symbol") return plant.symbols[index].name + ", " + value(store.values[index], plant.symbols[index]);
  if (kind === "frame") {
    const {name, station, devices} = placed.frames[index];
    const worst = devices.reduce((most, device) => Math.max(most, statuses.of[device]), 0);
    return [name, station === null ? "group" : "station", count(devices.length, "device"), STATUSES[worst].text].join(", ");
  }
  const location = plant.locations[index];
  const at = store.rankOfLocation[index];
  const parts = (location.kind === "track" ? store.tracks[at]?.parts : store.places[at]) ?? [];
  return location.name + ", " + location.kind + ", " + count(parts.length, "part") + (parts.length > 0 ? ": " + countsByKind(parts, plant.part_kinds) : "");
};

/// The name by which a thing is selected.
export const nameOf = ({names}, placed, {kind, index}) => kind === "frame" ? placed.frames[index].name : names.name(kind, index);
