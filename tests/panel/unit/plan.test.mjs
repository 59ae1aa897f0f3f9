// The plan without a browser: its camera, what symbols show, what is under a pointer, and changes of the layout.
import assert from "node:assert/strict";
import {test} from "node:test";
import {Camera} from "../../../runtime/panel/page/plan/camera.js";
import {devicesOf, groupDevices, moveThings, operatorsOf, turnThings, wholePlan} from "../../../runtime/panel/page/plan/change.js";
import {layOut, pointOn, slotOf} from "../../../runtime/panel/page/plan/layout.js";
import {amountOf, levelOf, motionOf, runs, valuesByDevice} from "../../../runtime/panel/page/plan/motion.js";
import {boxOf, describe, nextThing, pick, thingsOf} from "../../../runtime/panel/page/plan/pick.js";
import {Names} from "../../../runtime/panel/page/names.js";
import {Statuses} from "../../../runtime/panel/page/status.js";
import {Store} from "../../../runtime/panel/page/store.js";
import {pictureWithValues, plantWithValues, smallPicture, smallPlant} from "./plant.mjs";
import {inventedPlant} from "./plan_plants.mjs";

const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-6, a + " is not " + b);

test("The camera shows a whole, zooms at a point, and follows as little as possible", () => {
  const camera = Object.assign(new Camera(), {wide: 800, high: 400});
  camera.whole({x: -10, y: -10, w: 80, h: 20});
  assert.equal(camera.scale, 10);
  assert.deepEqual(camera.toScreen([-10, -10]), [0, 70]);
  const before = camera.toPlan([100, 100]);
  camera.zoom(2, [100, 100]);
  camera.toPlan([100, 100]).forEach((at, i) => near(at, before[i]));
  assert.equal(camera.isWhole, false);
  camera.pan(40, 0);
  near(camera.toPlan([140, 100])[0], before[0]);
  assert.equal(camera.follow({x: camera.x + 1, y: camera.y + 1, w: 2, h: 2}), false);
  assert.equal(camera.follow({x: camera.x - 3, y: camera.y, w: 2, h: 2}), true);
  for (let i = 0; i < 60; ++i) camera.step(-1);
  assert.equal(camera.scale, 2);
});

test("Symbols show states by their words, then by their order; during a move what is between", () => {
  const of = (shape, ...states) => ({shape, states});
  assert.deepEqual([0, 1].map((state) => amountOf(of("cylinder", "BACK", "OUT"), state)), [0, 1]);
  assert.deepEqual([0, 1].map((state) => amountOf(of("clamp", "CLOSE", "OPEN"), state)), [1, 0]);
  assert.deepEqual([0, 1].map((state) => amountOf(of("door", "NOT_OPEN", "OPEN"), state)), [0, 1]);
  assert.deepEqual([0, 1].map((state) => amountOf(of("door", "CLOSED1", "OPEN2"), state)), [0, 1]);
  assert.deepEqual([0, 1, 2].map((state) => amountOf(of("vehicle", "P1", "P2", "DOCK"), state)), [0, .5, 1]);
  const store = new Store({...smallPlant(), devices: smallPlant().devices.map((device) => ({...device, shape: "clamp"}))});
  store.picture({...smallPicture(), devices: [[0, 1, 1, 0, 0, 500, 1000], [1, 1, 0, 0, 0, 0, 0]]});
  near(motionOf(store, 0, 0).amount, .5);
  near(motionOf(store, 0, 250).amount, .75);
  assert.equal(motionOf(store, 0, 0).on, false);
});

test("A motor that runs turns, one that stops or moves to another state does not", () => {
  const plant = {...smallPlant(), devices: [{...smallPlant().devices[0], shape: "motor", states: ["NOT_RUN", "RUN"]}, smallPlant().devices[1]]};
  const store = new Store(plant);
  const at = (state, target) => {
    store.picture({...smallPicture(), devices: [[state, target, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0, 0]]});
    return runs(store, 0);
  };
  assert.deepEqual([at(1, 1), at(0, 0), at(0, 1)], [true, false, false]);
});

test("Values are at their device, or at the only one whose label they begin with; a tank has the level of the first with a range", () => {
  const plant = plantWithValues();
  plant.values.push({name: "door.force", unit: "N", min: null, max: null, device: null}, {name: "x.y", unit: "", min: null, max: null, device: null});
  assert.deepEqual([...valuesByDevice(plant)], [[0, [1, 2]], [1, [3]]]);
  const store = new Store(plant);
  store.picture(pictureWithValues());
  near(levelOf(store, [2, 1]), 20 / 120);
  assert.equal(levelOf(store, [2]), null);
  assert.equal(levelOf(store, undefined), null);
});

test("What is under a pointer: devices, sensors of belts, tracks, places, frames; nothing else", () => {
  const plant = smallPlant();
  const placed = layOut(plant);
  const {x, y} = placed.devices[1];
  assert.deepEqual(pick(plant, placed, [x, y]), {kind: "device", index: 1});
  const [sx, sy] = pointOn(placed.locations[0], 300000, 3000000);
  assert.deepEqual(pick(plant, placed, [sx, sy - .65]), {kind: "symbol", index: 3});
  assert.deepEqual(pick(plant, placed, pointOn(placed.locations[0], 2e6, 3e6)), {kind: "location", index: 0});
  assert.deepEqual(pick(plant, placed, slotOf(placed.locations[1], 0)), {kind: "location", index: 1});
  const frame = placed.frames[0];
  assert.deepEqual(pick(plant, placed, [frame.x + .1, frame.y + .1]), {kind: "frame", index: 0});
  assert.equal(pick(plant, placed, [frame.x - 50, frame.y]), null);
});

test("Arrow keys lead from thing to thing, and a screen reader gets name, kind and state", () => {
  const plant = {...smallPlant(), devices: smallPlant().devices.map((device) => ({...device, shape: "clamp"}))};
  const placed = layOut(plant);
  const things = thingsOf(placed);
  assert.deepEqual(nextThing(things, null, "ArrowRight"), things[0]);
  assert.equal(nextThing(things, {kind: "device", index: 0}, "ArrowRight").index, 1);
  assert.equal(nextThing([], null, "ArrowRight"), null);
  const store = new Store(plant);
  const names = new Names(plant);
  store.picture(smallPicture());
  const app = {plant, store, names, statuses: new Statuses(store, names)};
  assert.equal(describe(app, placed, {kind: "device", index: 0}), "LINE_S1_CLAMP, clamp, OPEN, at rest");
  assert.equal(describe(app, placed, {kind: "symbol", index: 2}), "LINE_S1_DOOR_I_SHUT, on");
  assert.equal(describe(app, placed, {kind: "location", index: 0}), "BELT, track, 1 part: 1 raw");
  assert.equal(describe(app, placed, {kind: "frame", index: 0}), "LINE S1, station, 2 devices, at rest");
  for (const {kind, index, at: [x, y]} of things) {
    const box = boxOf(placed, {kind, index});
    assert.ok(x >= box.x && x <= box.x + box.w && y >= box.y && y <= box.y + box.h);
  }
});

const kSeeds = 200;

test("A plan that gives every position has the same layout, in any plant", () => {
  for (let seed = 1; seed <= kSeeds; ++seed) {
    const plant = inventedPlant(seed);
    const placed = layOut(plant);
    const again = layOut(plant, wholePlan(plant, placed));
    assert.deepEqual(again.devices, placed.devices, "plant " + seed);
    assert.deepEqual(again.locations, placed.locations, "plant " + seed);
    assert.deepEqual(again.frames.map(({x, y}) => [x, y]), placed.frames.map(({x, y}) => [x, y]), "plant " + seed);
  }
});

test("While a plan with every position is edited, operated symbols stay in their frames", () => {
  for (let seed = 1; seed <= kSeeds / 4; ++seed) {
    const plant = inventedPlant(seed);
    const placed = layOut(plant);
    const kept = operatorsOf(placed);
    const bySymbol = ({operators}) => [...operators].sort((a, b) => a.symbol - b.symbol).map(({symbol, x, y, frame}) => [symbol, frame, Math.round(x * 1e6), Math.round(y * 1e6)]);
    const plan = wholePlan(plant, placed);
    assert.deepEqual(bySymbol(layOut(plant, plan, kept)), bySymbol(placed), "plant " + seed);
    const moved = layOut(plant, moveThings(plant, placed, plan, [{kind: "frame", index: 0}], 3, -1), kept);
    assert.deepEqual(bySymbol(moved), bySymbol(placed).map(([symbol, frame, x, y]) => [symbol, frame, x + (frame === 0 ? 3e6 : 0), y - (frame === 0 ? 1e6 : 0)]), "plant " + seed);
  }
});

test("Things move on the grid: a frame takes its devices and tracks along, once", () => {
  const plant = smallPlant();
  const placed = layOut(plant);
  const plan = wholePlan(plant, placed);
  const moved = layOut(plant, moveThings(plant, placed, plan, [{kind: "frame", index: 0}, {kind: "device", index: 0}, {kind: "location", index: 0}], 3, -1));
  placed.devices.forEach(({x, y}, i) => assert.deepEqual([moved.devices[i].x, moved.devices[i].y], [x + 3, y - 1]));
  assert.deepEqual([moved.locations[0].x, moved.locations[0].y], [placed.locations[0].x + 3, placed.locations[0].y - 1]);
  assert.deepEqual(plan, wholePlan(plant, placed), "the plan itself was changed");
  const one = layOut(plant, moveThings(plant, placed, plan, [{kind: "device", index: 1}], 0, .5));
  assert.deepEqual([one.devices[1].y, one.devices[0].y], [placed.devices[1].y + .5, placed.devices[0].y]);
});

test("Things turn by quarters; a place does not", () => {
  const plant = smallPlant();
  let plan = wholePlan(plant, layOut(plant));
  const things = [{kind: "device", index: 0}, {kind: "location", index: 0}, {kind: "location", index: 1}];
  const turns = () => [plan.devices.LINE_S1_CLAMP.turn, plan.locations.BELT.turn, plan.locations.FIXTURE.turn];
  plan = turnThings(plant, plan, things);
  assert.deepEqual(turns(), [90, 90, undefined]);
  for (let i = 0; i < 3; ++i) plan = turnThings(plant, plan, things);
  assert.deepEqual(turns(), [undefined, undefined, undefined]);
});

test("Devices go into a group and back, and stay where they are; a group without devices is gone", () => {
  const plant = smallPlant();
  const placed = layOut(plant);
  const grouped = groupDevices(plant, placed, wholePlan(plant, placed), [1], "Safety");
  const after = layOut(plant, grouped);
  assert.deepEqual(after.frames.map(({name, devices}) => [name, devices]), [["LINE S1", [0]], ["Safety", [1]]]);
  assert.deepEqual([after.devices[1].x, after.devices[1].y], [placed.devices[1].x, placed.devices[1].y]);
  assert.deepEqual(devicesOf(after, [{kind: "frame", index: 1}, {kind: "device", index: 1}]), [1]);
  const back = groupDevices(plant, after, grouped, [1], null);
  assert.deepEqual(Object.keys(back.frames), ["LINE S1"]);
  assert.deepEqual(layOut(plant, back).devices[1], placed.devices[1]);
});

test("Names that all objects have are names like others", () => {
  const plant = smallPlant();
  plant.stations[0].name = "constructor";
  plant.devices[0].name = "toString";
  const {frames, devices} = layOut(plant, {frames: {}, devices: {LINE_S1_DOOR: {x: 3, y: 3, group: "valueOf"}}, locations: {}});
  for (const {x, y} of [...frames, ...devices]) assert.ok(Number.isFinite(x) && Number.isFinite(y));
});

test("A group, a device and a track may have the name __proto__", () => {
  const plant = smallPlant();
  plant.devices[0].name = "__proto__";
  plant.locations[0].name = "__proto__";
  const placed = layOut(plant);
  const grouped = groupDevices(plant, placed, wholePlan(plant, placed), [0], "__proto__");
  const plan = JSON.parse(JSON.stringify(moveThings(plant, placed, grouped, [{kind: "device", index: 0}, {kind: "location", index: 0}], 1, 0)));
  const after = layOut(plant, plan);
  assert.deepEqual(after.frames.map(({name, devices}) => [name, devices]), [["LINE S1", [1]], ["__proto__", [0]]]);
  for (const [now, before] of [[after.devices[0], placed.devices[0]], [after.locations[0], placed.locations[0]]]) assert.deepEqual([now.x, now.y], [before.x + 1, before.y]);
  assert.equal(after.locations[0].length, placed.locations[0].length);
});
