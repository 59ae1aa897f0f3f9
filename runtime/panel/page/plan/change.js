// Changes of a plan (what layout.json has): moving, turning, grouping. Pure functions, without elements. A plan is never changed: each returns a new one.
import {rectOf} from "./geometry.js";

const kStep = .5;
const kHead = 1.5;   // from the corner of a new group to its first device

const round = (number) => Math.round(number * 1000) / 1000 + 0;

/// A position on the grid.
export const snap = (number) => Math.round(number / kStep) * kStep;

/// A map by names, which may be any: `__proto__` is one, too.
const named = (map = {}) => {
  const copy = Object.create(null);
  for (const [name, entry] of Object.entries(map)) copy[name] = {...entry};
  return copy;
};

const copyOf = ({frames, devices, locations, ...rest}) => ({...rest, frames: named(frames), devices: named(devices), locations: named(locations)});

const frameAt = (placed, frame) => frame === null ? {x: 0, y: 0} : placed.frames[frame];

/// A plan that gives the position of everything as it is placed, so that nothing else moves when one thing does.
export const wholePlan = (plant, placed, {background} = {}) => {
  const plan = {...(background ? {background} : {}), frames: named(), devices: named(), locations: named()};
  for (const {name, x, y} of placed.frames) plan.frames[name] = {x: round(x), y: round(y)};
  placed.devices.forEach(({x, y, turn, frame}, device) => {
    const {x: fx, y: fy} = frameAt(placed, frame);
    const isGroup = frame !== null && placed.frames[frame].station !== plant.devices[device].station;
    plan.devices[plant.devices[device].name] = {x: round(x - fx), y: round(y - fy), ...(turn ? {turn} : {}), ...(isGroup ? {group: placed.frames[frame].name} : {})};
  });
  placed.locations.forEach(({kind, x, y, length, turn}, location) => {
    plan.locations[plant.locations[location].name] = {x: round(x), y: round(y), ...(kind === "track" ? {length: round(length), ...(turn ? {turn} : {})} : {})};
  });
  return plan;
};

/// Where the symbols are that a person operates, relative to their frames, for layOut(): a plan cannot give it, but during an edit they stay there.
export const operatorsOf = (placed) => new Map(placed.operators.map(({symbol, x, y, frame}) => {
  const corner = frameAt(placed, frame);
  return [symbol, {x: x - corner.x, y: y - corner.y}];
}));

/// The tracks and places that move with a frame: those in it.
const inside = (placed, {x, y, w, h}) => placed.locations.flatMap((location, index) => {
  const rect = rectOf(location);
  return rect.x >= x && rect.y >= y && rect.x + rect.w <= x + w && rect.y + rect.h <= y + h + 1 ? [index] : [];
});

/// Moves things, { kind, index } with kind device, location or frame.
export const moveThings = (plant, placed, plan, things, dx, dy) => {
  const next = copyOf(plan);
  const shift = (entry) => Object.assign(entry, {x: round(entry.x + dx), y: round(entry.y + dy)});
  const frames = new Set(things.filter(({kind}) => kind === "frame").map(({index}) => index));
  const locations = new Set(things.filter(({kind}) => kind === "location").map(({index}) => index));
  for (const frame of frames) {
    shift(next.frames[placed.frames[frame].name]);
    for (const location of inside(placed, placed.frames[frame])) locations.add(location);
  }
  for (const location of locations) shift(next.locations[plant.locations[location].name]);
  for (const {kind, index} of things) if (kind === "device" && !frames.has(placed.devices[index].frame)) shift(next.devices[plant.devices[index].name]);
  return next;
};

/// Turns devices and tracks by a quarter, clockwise; a track about its begin.
export const turnThings = (plant, plan, things) => {
  const next = copyOf(plan);
  for (const {kind, index} of things) {
    const isTrack = kind === "location" && plant.locations[index].kind === "track";
    const entry = kind === "device" ? next.devices[plant.devices[index].name] : isTrack ? next.locations[plant.locations[index].name] : null;
    if (!entry) continue;
    entry.turn = ((entry.turn ?? 0) + 90) % 360;
    if (entry.turn === 0) delete entry.turn;
  }
  return next;
};

/// Without frames of groups that have no device.
const withoutEmpty = (plant, plan) => {
  const used = new Set([...plant.stations.map(({name}) => name), ...Object.values(plan.devices).map(({group}) => group)]);
  for (const name of Object.keys(plan.frames)) if (!used.has(name)) delete plan.frames[name];
  return plan;
};

/// Puts devices into a frame, so that they stay where they are; `name`: null for those of their stations.
export const groupDevices = (plant, placed, plan, devices, name) => {
  const next = copyOf(plan);
  const corner = (list) => ({x: snap(Math.min(...list.map((device) => placed.devices[device].x)) - kHead), y: snap(Math.min(...list.map((device) => placed.devices[device].y)) - kHead)});
  const byFrame = new Map();
  for (const device of devices) {
    const {station} = plant.devices[device];
    const frame = name ?? (station === null ? null : plant.stations[station].name);
    byFrame.set(frame, [...byFrame.get(frame) ?? [], device]);
  }
  for (const [frame, list] of byFrame) {
    if (frame !== null && !Object.hasOwn(next.frames, frame)) next.frames[frame] = corner(list);
    const {x, y} = frame === null ? {x: 0, y: 0} : next.frames[frame];
    for (const device of list) {
      const {station} = plant.devices[device];
      const entry = next.devices[plant.devices[device].name];
      Object.assign(entry, {x: round(placed.devices[device].x - x), y: round(placed.devices[device].y - y)});
      if (frame === null || (station !== null && plant.stations[station].name === frame)) delete entry.group;
      else entry.group = frame;
    }
  }
  return withoutEmpty(plant, next);
};

/// The devices of things: those that are meant, and those in frames of groups.
export const devicesOf = (placed, things) => [...new Set(things.flatMap(({kind, index}) => kind === "device" ? [index] : kind === "frame" ? placed.frames[index].devices : []))];
