// The layout of the plan: nothing lies over anything else, lines look like lines, given positions win.
import assert from "node:assert/strict";
import {test} from "node:test";
import {layOut, overlaps, pointOn, rectOf, slotOf} from "../../../runtime/panel/page/plan/layout.js";
import {addDevice, addPlace, addTrack, inventedPlant, lineOf, someNegative, somePositions} from "./plan_plants.mjs";

const kPlants = 400;

const symbolsOf = (placed) => [...placed.devices, ...placed.operators].map(({x, y}) => ({x: x - .5, y: y - .5, w: 1, h: 1}));

const isInside = (inner, outer) => inner.x >= outer.x - 1e-6 && inner.y >= outer.y - 1e-6 && inner.x + inner.w <= outer.x + outer.w + 1e-6 && inner.y + inner.h <= outer.y + outer.h + 1e-6;

/// Pairs that overlap, each as a text.
const clashes = (name, list, other = null) => list.flatMap((a, i) => (other ?? list.slice(i + 1)).filter((b) => overlaps(a, b)).map((b) => name + ": " + JSON.stringify([a, b])));

/// What is wrong with a layout; `isAutomatic`: no position was given.
const faultsOf = (placed, isAutomatic = true) => {
  const symbols = symbolsOf(placed);
  const belts = placed.locations.map(rectOf);
  const frames = placed.frames.map(({x, y, w, h}) => ({x, y, w, h}));
  const faults = [...clashes("frames", frames), ...clashes("symbols", symbols), ...clashes("tracks", belts), ...clashes("symbol and track", symbols, belts)];
  placed.devices.forEach(({frame}, device) => {
    frames.forEach((box, index) => {
      if (index === frame ? !isInside(symbols[device], box) : overlaps(symbols[device], box)) faults.push("device " + device + " and frame " + index);
    });
  });
  for (const box of [...frames, ...belts, ...symbols]) if (!isInside(box, placed.bounds)) faults.push("outside of the bounds: " + JSON.stringify(box));
  if (isAutomatic) faults.push(...placed.joins.filter(({points}) => points.some((point) => !point.every(Number.isFinite))).map(() => "a join without a path"));
  return faults;
};

test("In invented plants no symbol, frame or track lies over another, and a layout is the same each time", () => {
  for (let seed = 1; seed <= kPlants; ++seed) {
    const plant = inventedPlant(seed);
    const placed = layOut(plant, {});
    assert.deepEqual(faultsOf(placed), [], "plant " + seed);
    assert.deepEqual(layOut(plant), placed);
  }
});

test("Given positions win, and nothing that is placed automatically lies over them", () => {
  for (let seed = 1; seed <= kPlants; ++seed) {
    const plant = inventedPlant(seed);
    const plan = somePositions(plant, layOut(plant), seed);
    const placed = layOut(plant, plan);
    const frameOf = new Map(placed.frames.map((frame) => [frame.name, frame]));
    for (const [name, {x, y}] of Object.entries(plan.frames)) assert.deepEqual([frameOf.get(name).x, frameOf.get(name).y], [x, y]);
    plant.devices.forEach(({name}, i) => {
      const given = plan.devices[name];
      if (!given) return;
      const {x, y, turn, frame} = placed.devices[i];
      const origin = frame === null ? {x: 0, y: 0} : placed.frames[frame];
      assert.deepEqual([x, y, turn].map((n) => Math.round(n * 1000)), [origin.x + given.x, origin.y + given.y, given.turn].map((n) => Math.round(n * 1000)));
    });
    plant.locations.forEach(({name}, i) => {
      if (plan.locations[name]) assert.deepEqual({...placed.locations[i], ...plan.locations[name]}, placed.locations[i]);
    });
    const fixed = new Set(plant.devices.flatMap(({name}, i) => plan.devices[name] ? [i] : []));
    const symbols = placed.devices.map(({x, y}) => ({x: x - .5, y: y - .5, w: 1, h: 1}));
    symbols.forEach((a, i) => symbols.forEach((b, j) => {
      if (i < j && !(fixed.has(i) && fixed.has(j))) assert.ok(!overlaps(a, b), "plant " + seed + ": devices " + i + " and " + j);
    }));
  }
});

test("A frame without a given position encloses devices with negative ones, which stay as they are to each other", () => {
  for (let seed = 1; seed <= kPlants; ++seed) {
    const plant = inventedPlant(seed);
    const plan = someNegative(plant, layOut(plant), seed);
    const placed = layOut(plant, plan);
    assert.deepEqual(faultsOf(placed), [], "plant " + seed);
    const first = new Map();
    plant.devices.forEach(({name}, i) => {
      const given = plan.devices[name];
      if (!given) return;
      const {x, y, frame} = placed.devices[i];
      const [dx, dy] = first.get(frame) ?? first.set(frame, [x - given.x, y - given.y]).get(frame);
      assert.ok(Math.abs(x - given.x - dx) + Math.abs(y - given.y - dy) < 1e-6, "plant " + seed + ", " + name);
    });
  }
});

test("A line of stations that pass parts on runs from left to right, its belts at one height", () => {
  const {frames, locations, joins} = layOut(lineOf(3, 4));
  assert.ok(frames[0].x + frames[0].w <= frames[1].x && frames[1].x + frames[1].w <= frames[2].x);
  assert.deepEqual(locations.map(({y, turn}) => [y, turn]), Array(3).fill([locations[0].y, 0]));
  for (const {from, to, points} of joins) {
    assert.equal(points.length, 2);
    assert.deepEqual(points[0], pointOn(locations[from], 3e6, 3e6));
    assert.deepEqual(points[1], pointOn(locations[to], 0, 3e6));
  }
});

test("A long line is folded to the shape of a screen, every second row to the left, and a loop closes", () => {
  const {bounds, locations} = layOut(lineOf(40, 9));
  assert.ok(bounds.w / bounds.h > .9 && bounds.w / bounds.h < 3, bounds.w + " x " + bounds.h);
  assert.deepEqual(new Set(locations.map(({turn}) => turn)), new Set([0, 180]));
  const loop = layOut(lineOf(12, 9, true));
  const back = loop.joins.find(({from, to}) => from === 11 && to === 0);
  const length = back.points.slice(1).reduce((sum, [x, y], i) => sum + Math.abs(x - back.points[i][0]) + Math.abs(y - back.points[i][1]), 0);
  assert.ok(length < loop.bounds.w / 2, "the way back is " + length + " of " + loop.bounds.w);
});

test("A track along stations is as long as they need, and each is where its sensor is, in order", () => {
  const plant = lineOf(0, 0);
  plant.stations = Array.from({length: 5}, (_, i) => ({name: "L S" + i, line: "L", process: "S" + i}));
  addTrack(plant, [0, 1, 2, 3, 4], 50e6);
  for (let station = 0; station < 5; ++station) for (let i = 0; i < 6; ++i) addDevice(plant, station, "D" + i);
  const {frames, locations: [belt], devices} = layOut(plant);
  frames.forEach((frame, i) => {
    assert.ok(frame.y < belt.y && belt.y < frame.y + frame.h);
    if (i > 0) assert.ok(frames[i - 1].x + frames[i - 1].w < frame.x);
  });
  assert.ok(devices.some(({y}) => y < belt.y) && devices.some(({y}) => y > belt.y));
});

test("Tracks in proportion; those that are fed in the middle of a belt hang from there, and what pushes is opposite", () => {
  const plant = lineOf(1, 0);
  plant.locations[0].length = 4e6;
  const chutes = [addTrack(plant, [0], 1e6), addTrack(plant, [0], 1e6)];
  plant.transfers = chutes.map((to, i) => ({name: "push " + (i + 1), from: {location: 0, at: (2 + i) * 1e6}, to: {location: to}}));
  const push = addDevice(plant, 0, "PUSH1");
  addPlace(plant, null, 3);
  plant.locations[0].ends = [{to: 3}];
  const {locations, devices, frames} = layOut(plant);
  assert.deepEqual(locations.slice(0, 3).map(({turn}) => turn), [0, 90, 90]);
  assert.equal(locations[1].length, locations[2].length);
  assert.ok(locations[0].length > 2 * locations[1].length);
  assert.equal(locations[1].x, pointOn(locations[0], 2e6, 4e6)[0]);
  assert.ok(Math.abs(devices[push].x - locations[1].x) <= 1 && devices[push].y < locations[0].y);
  assert.ok(isInside(rectOf(locations[3]), frames[0]), "a place at the end of the only station's belt is in its frame");
  assert.deepEqual(slotOf(locations[3], 0), [locations[3].x + .5, locations[3].y + .5]);
  assert.deepEqual(slotOf(locations[3], 9), slotOf(locations[3], 2));
});

test("Groups are frames, and devices of a station that are in one are not in the station's frame", () => {
  const plant = lineOf(1, 3);
  const {frames, devices} = layOut(plant, {devices: {L_S0_D1: {x: 2, y: 2, group: "Safety"}}, frames: {Safety: {x: 30, y: 5}}});
  assert.deepEqual(frames.map(({name, station, devices}) => [name, station, devices]), [["L S0", 0, [0, 2]], ["Safety", null, [1]]]);
  assert.deepEqual([devices[1].x, devices[1].y, devices[1].frame], [32, 7, 1]);
});
