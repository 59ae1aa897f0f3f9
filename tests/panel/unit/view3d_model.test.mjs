// The 3D view with three.js, without a browser: nodes of a model that are bound to devices, values, tracks and places; solids; the camera.
import "./three.mjs";
import assert from "node:assert/strict";
import {test} from "node:test";
import {Names} from "../../../runtime/panel/page/names.js";
import {Statuses} from "../../../runtime/panel/page/status.js";
import {Store} from "../../../runtime/panel/page/store.js";
import {pictureWithValues, plantWithValues} from "./plant.mjs";

const {Stage} = await import("../../../runtime/panel/page/view3d/stage.js");
const {reducedMotion} = await import("../../../runtime/panel/page/theme.js");
const {BoxGeometry, Group, Mesh, MeshStandardMaterial, PerspectiveCamera, Raycaster, Vector3} = await import("../../../runtime/panel/page/build/three.module.js");
const {layOut} = await import("../../../runtime/panel/page/plan/layout.js");
const {Boxes} = await import("../../../runtime/panel/page/view3d/boxes.js");
const {kView3dKeys, kView3dLabel, listenToScene} = await import("../../../runtime/panel/page/view3d/keys.js");
const {Model} = await import("../../../runtime/panel/page/view3d/model.js");

/// A cube of 1 m whose middle is `at`.
const cube = (name, at = [0, 0, 0]) => {
  const mesh = new Mesh(new BoxGeometry(1, 1, 1), new MeshStandardMaterial());
  mesh.position.set(...at);
  return Object.assign(mesh, {name});
};

/// A model with the nodes Cell (a group), Arm and Jaw below it, Belt, Empty; { app, model, node(name) }.
const load = (nodes, states = ["OPEN", "CLOSE"]) => {
  const [cell, arm, jaw, belt, empty] = [new Group(), cube("Arm"), cube("Jaw", [0, 1, 0]), cube("Belt", [10, 0, 0]), new Group()];
  arm.add(jaw);
  cell.add(arm, belt, empty);
  empty.position.set(0, 0, 20);
  const names = ["Cell", "Arm", "Jaw", "Belt", "Empty"];
  const plant = {...plantWithValues(), view3d: {nodes}};
  plant.devices = plant.devices.map((device, index) => ({...device, shape: "clamp", states: index === 0 ? states : device.states}));
  const store = new Store(plant);
  const app = {plant, store, names: new Names(plant)};
  app.statuses = new Statuses(store, app.names);
  store.picture(pictureWithValues());
  const model = new Model(app, cell, [cell, arm, jaw, belt, empty], {names, parents: [null, 0, 1, 0, 0]});
  return {app, store, model, node: (name) => [cell, arm, jaw, belt, empty][names.indexOf(name)]};
};

const rounded = (list) => list.map((value) => Math.round(value * 1000) / 1000);
/// What a ray from above hits at x, z.
const hit = (model, x, z) => {
  model.root.updateMatrixWorld(true);
  const [found] = new Raycaster(new Vector3(x, 50, z), new Vector3(0, -1, 0)).intersectObjects(model.targets, true);
  return found ? model.tagOf(found) : null;
};

test("A track and a place have an outline, a name and parts that can be clicked, before parts come and after", () => {
  const {app, store, model} = load({BELT: {node: "Belt", from: [-.5, .5, 0], to: [.5, .5, 0]}, FIXTURE: {node: "Empty", from: [0, 0, 0]}});
  const belt = {kind: "location", index: 0};
  const place = {kind: "location", index: 1};
  const before = [model.outline(belt), model.outline(place)];
  assert.deepEqual([rounded(before[0].center), rounded(before[0].size)], [[10, 0, 0], [1.03, 1.03, 1.03]]);
  assert.deepEqual(rounded(before[1].center), [0, 0, 20]);
  model.draw(0);
  assert.deepEqual([model.outline(belt), model.outline(place)], before);
  for (const {x, y, z} of model.names()) assert.ok([x, y, z].every(Number.isFinite));
  assert.deepEqual(model.names().map(({text}) => text), ["BELT", "FIXTURE"]);
  assert.equal(hit(model, 0, 20).index, 1, "a part on the place");
  store.changes({rev: 2, t: 10, places: [[0, []]], tracks: [[0, 10, [[1, 0, 3000000, 0]], [false], [0]]]});
  model.draw(10);
  assert.equal(hit(model, 0, 20), null, "the part has left");
  assert.equal(hit(model, 10.47, .1).index, 0);
  assert.deepEqual([model.outline(belt), model.outline(place)], before);
  assert.equal(app.plant.locations[0].name, "BELT");
});

test("A device and a track on one node keep both names, and parts keep their colors", () => {
  const {model} = load({BELT: {node: "Belt", from: [-.5, .5, 0], to: [.5, .5, 0]}, LINE_S1_CLAMP: {node: "Belt"}});
  assert.deepEqual(model.names().map(({device, text}) => device ?? text), [0, "BELT"]);
  const {node} = model.bound[0];
  assert.equal(node.meshes.length, 1, "not the parts");
  model.draw(0);
  assert.equal(hit(model, 10.4, .4).kind, "device");
  const [part] = new Raycaster(new Vector3(9.6, 50, 0), new Vector3(0, -1, 0)).intersectObjects(model.targets, true);
  assert.equal(model.tagOf(part).kind, "location", "a part is of its track");
  assert.ok(model.outline({kind: "device", index: 0}) && model.outline({kind: "location", index: 0}));
});

test("The outline of a node follows what moves below it", () => {
  const {store, model} = load({LINE_S1_CLAMP: {node: "Arm", CLOSE: {move: [5, 0, 0]}}, LINE_S1_DOOR: {node: "Jaw", NOT_SHUT: {move: [0, 3, 0]}}});
  model.draw(0);
  assert.deepEqual(rounded(model.outline({kind: "device", index: 0}).center), [0, .5, 0]);
  store.changes({rev: 2, t: 10, devices: [[0, 1, 1, 0, 0, 10, 0, 0], [1, 0, 0, 0, 0, 10, 0, 0]]});
  model.draw(10);
  assert.deepEqual(rounded(model.outline({kind: "device", index: 0}).center), [5, 2, 0]);
  assert.deepEqual(rounded(model.outline({kind: "device", index: 1}).center), [5, 4, 0]);
});

test("Two entries that move one node add up, and a value without a number adds nothing", () => {
  const {store, model, node} = load({LINE_S1_CLAMP: {node: "Arm", CLOSE: {move: [5, 0, 0]}}, wind: {node: "Arm", move: {by: "wind", axis: "x", offset: 1}, turn: {by: "wind", axis: "y"}}});
  model.draw(0);
  assert.deepEqual(node("Arm").position.toArray(), [5, 0, 0]);
  assert.ok(Math.abs(node("Arm").rotation.y - 4 * Math.PI / 180) < 1e-9);
  store.changes({rev: 2, t: 10, devices: [[0, 1, 1, 0, 0, 10, 0, 0]], values: [[0, null, 0]]});
  assert.equal(model.draw(10), true);
  assert.deepEqual(node("Arm").position.toArray(), [5, 0, 0]);
  assert.equal(node("Arm").rotation.y, 0);
  store.changes({rev: 3, t: 20, values: [[0, -1, 0]]});
  model.draw(20);
  assert.deepEqual(node("Arm").position.toArray(), [5, 0, 0]);
  assert.equal(model.draw(20), false);
});

test("A node whose device is diverted to a third state goes on from where it was", () => {
  const {store, model, node} = load({LINE_S1_CLAMP: {node: "Arm", OPEN: {move: [0, 0, 0]}, CLOSE: {move: [4, 0, 0]}, AWAY: {move: [0, 8, 0]}}}, ["OPEN", "CLOSE", "AWAY"]);
  const at = (now) => {
    model.draw(now);
    return rounded(node("Arm").position.toArray());
  };
  store.changes({rev: 2, t: 0, devices: [[0, 0, 1, 1, 0, 0, 100, 100]]});
  assert.deepEqual(at(50), [2, 0, 0]);
  store.changes({rev: 3, t: 50, devices: [[0, 0, 2, 1, 0, 50, 100, 100]]});
  assert.deepEqual(at(50), [2, 0, 0]);
  assert.deepEqual(at(100), [1, 4, 0]);
  assert.deepEqual(at(150), [0, 8, 0]);
});

test("A motor spins while it runs and plant time does, and rests if the system asks for less motion", () => {
  const plant = plantWithValues();
  plant.devices = plant.devices.map((device) => ({...device, shape: "motor", states: ["STOP", "RUN"]}));
  const store = new Store(plant);
  const app = {plant, store, names: new Names(plant), clock: {runs: true}};
  app.statuses = new Statuses(store, app.names);
  store.picture({...pictureWithValues(), tracks: [[0, [], [false], [0]]]});  // the second one runs, nothing else moves
  const boxes = new Boxes(app, layOut(plant, {}));
  const shown = () => boxes.devices[1].movers[0].slot.matrix.join();
  assert.equal(boxes.draw(0), true);
  const first = shown();
  assert.equal(boxes.draw(1e8), true);
  assert.notEqual(shown(), first);
  assert.equal(boxes.draw(8e8), true, "after a whole turn, too");
  app.clock.runs = false;
  assert.equal(boxes.draw(8e8), false);
  app.clock.runs = true;
  assert.equal(boxes.draw(9e8), true, "it goes on");
  reducedMotion.matches = true;
  assert.equal(boxes.draw(9e8), false);
  assert.equal(shown(), first);
  reducedMotion.matches = false;
  assert.equal(boxes.draw(9e8), true);
});

/// A stage without graphics, in an element of a size that can be changed.
const stageOf = (size) => Object.assign(Object.create(Stage.prototype), {canvas: {parentElement: size}, size: [0, 0, 1], sharpness: 1, isWhole: false, flight: null, span: 10, changed() {},
  renderer: {setPixelRatio() {}, setSize() {}}, camera: new PerspectiveCamera(30, 1, .1, 1000), controls: {target: new Vector3(), update() {}},
  content: {slope: 1, bounds: () => ({min: [0, 0, 0], max: [10, 1, 5]})}});

test("A picture that is not shown has no size, and its camera stays finite", () => {
  globalThis.devicePixelRatio = 1;
  const size = {clientWidth: 0, clientHeight: 0};
  const stage = stageOf(size);
  stage.fit();
  stage.showAll(true);
  assert.ok(stage.camera.position.toArray().every(Number.isFinite));
  Object.assign(size, {clientWidth: 800, clientHeight: 200});
  stage.fit();
  assert.equal(stage.camera.aspect, 4);
  const whole = stage.overview().from;
  assert.deepEqual(stage.camera.position.toArray(), whole, "everything, in the size that it has now");
  Object.assign(size, {clientWidth: 800, clientHeight: 0});
  stage.fit();
  assert.equal(stage.camera.aspect, 4);
  stage.camera.position.set(NaN, 0, 0);
  stage.goTo({from: [1, 2, 3], to: [0, 0, 0]});
  assert.deepEqual([stage.flight, stage.camera.position.toArray()], [null, [1, 2, 3]]);
  stage.goTo({from: [4, 5, 6], to: [0, 0, 0]});
  assert.ok(stage.flight, "from a finite one it flies");
});

test("What gets the focus comes into the picture, from the same side", () => {
  const stage = stageOf({clientWidth: 100, clientHeight: 100});
  stage.goTo({from: [0, 10, 10], to: [0, 0, 0]}, true);
  stage.camera.lookAt(0, 0, 0);
  stage.reveal([.5, 0, 0]);
  assert.equal(stage.flight, null);
  stage.reveal([50, 0, 0]);
  assert.deepEqual([stage.flight.position.toArray(), stage.flight.to.toArray()], [[50, 10, 10], [50, 0, 0]]);
});

test("Every key of the 3D view acts, and the picture says all of them", () => {
  const acts = [];
  const canvas = {addEventListener(kind, listener) { this[kind] = listener; }};
  const note = (name) => (...more) => acts.push([name, ...more].join(" "));
  listenToScene(canvas, {stage: {turn: note("turn"), pan: note("pan"), zoom: note("zoom")}, step: note("step"), openFocused: note("open"), goTo: note("go"), setTranslucent: note("see"), isTranslucent: false});
  const press = (key, more = {}) => {
    let taken = false;
    canvas.keydown({key, preventDefault() { taken = true; }, stopPropagation() {}, ...more});
    return taken;
  };
  for (const key of ["[", "]", "Enter", "t", "0", "-", "ArrowUp"]) assert.ok(press(key), key);
  assert.ok(press("]", {ctrlKey: true, altKey: true}), "with AltGr");
  assert.ok(!press("t", {ctrlKey: true}) && !press("Tab"));
  assert.deepEqual(acts, ["step -1", "step 1", "open", "see true", "go ", "zoom 1.25", "pan 0 0.1", "step 1"]);
  for (const [key] of kView3dKeys) assert.ok(kView3dLabel.includes(key), key);
});
