// The 3D view without a browser: poses of nodes, positions between states, matrices, the camera, how sharp it is.
import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {test} from "node:test";
import {fileURLToPath} from "node:url";
import {after, kSame, placed, pointAt, shift, stretch, turn} from "../../../runtime/panel/page/view3d/affine.js";
import {amountOf, heatOf, mixPoses, nodeAt, numberOfSymbol, poseByValue, posesOf, sumOf, treeOf} from "../../../runtime/panel/page/view3d/binding.js";
import {overviewOf} from "../../../runtime/panel/page/view3d/overview.js";
import {Pace} from "../../../runtime/panel/page/view3d/pace.js";
import {shapeOf} from "../../../runtime/panel/page/view3d/shapes.js";

const kRoot = join(dirname(fileURLToPath(import.meta.url)), "../../..");
const near = (found, expected, what) => expected.forEach((value, i) => assert.ok(Math.abs(found[i] - value) < 1e-9, (what ?? "") + " " + found + ", expected " + expected));

test("A node has the pose of its device's state, and the model's own pose in a state without one", () => {
  const poses = posesOf({node: "AGV", P1: {move: [0, 0, 0]}, P2: {move: [2, 0, 0], turn: [0, 90, 0]}}, ["P1", "P2", "DOCK"]);
  assert.deepEqual(poses[1], {move: [2, 0, 0], turn: [0, 90, 0]});
  assert.deepEqual(poses[2], {move: [0, 0, 0], turn: [0, 0, 0]});
  assert.equal(posesOf({node: "AGV", color: {by: "x"}}, ["P1"]), null);
  assert.equal(posesOf({node: "AGV", from: [0, 0, 0]}, ["from"]), null);  // a key of the format is no state
});

test("Poses are mixed by the progress of a move", () => {
  const poses = posesOf({P1: {move: [0, 0, 1]}, P2: {move: [2, 0, 1], turn: [0, 270, 0]}}, ["P1", "P2"]);
  assert.deepEqual(mixPoses(poses[0], poses[1], .25), {move: [.5, 0, 1], turn: [0, 67.5, 0]});
  assert.deepEqual(mixPoses(poses[1], poses[0], .25), {move: [1.5, 0, 1], turn: [0, 202.5, 0]});  // back
});

test("A symbol without a number adds nothing", () => {
  assert.deepEqual([null, false, true, "x", 0, 7, "9007199254740993", "2.5"].map(numberOfSymbol), [NaN, NaN, NaN, NaN, 0, 7, 9007199254740992, 2.5]);
});

test("A value moves or turns a node by number * scale + offset, along or about an axis", () => {
  const numbers = {"CRANE.angle": 30, "CRANE.radius": 22, nan: NaN};
  const of = (entry) => poseByValue(entry, (name) => numbers[name]);
  assert.deepEqual(of({turn: {by: "CRANE.angle", axis: "y"}}), {move: [0, 0, 0], turn: [0, 30, 0]});
  assert.deepEqual(of({move: {by: "CRANE.radius", axis: "x", scale: .5, offset: -20}}).move, [-9, 0, 0]);
  assert.deepEqual(of({move: {by: "nan", axis: "z"}, turn: {by: "unknown", axis: "x"}}), {move: [0, 0, 0], turn: [0, 0, 0]});
  assert.equal(amountOf({}, Infinity), 0);
  assert.deepEqual(sumOf({move: [1, 0, 0], turn: [0, 0, 0]}, of({turn: {by: "CRANE.angle", axis: "z"}})), {move: [1, 0, 0], turn: [0, 0, 30]});
});

test("A value colors from blue to red, and stays at the ends", () => {
  const [cold, warm, hot] = [20, 110, 200].map((number) => heatOf({from: 20, to: 200}, number));
  assert.ok(cold[2] > cold[0] && hot[0] > hot[2] && Math.abs(warm[0] - warm[2]) < 1e-9);
  assert.deepEqual(heatOf({from: 20, to: 200}, -5), cold);
  assert.deepEqual(heatOf({from: 20, to: 200}, NaN), cold);
  assert.ok(heatOf({from: 5, to: 5}, 5).every(Number.isFinite));
});

test("A path names a node by its ancestors, which may be left out if that is unique", () => {
  const nodes = [{name: "Cell", children: [1, 2]}, {name: "AGV"}, {name: "Arm", children: [3]}, {name: "Jaw"}, {name: "Jaw"}, {name: "outside"}];
  const tree = treeOf({scenes: [{nodes: [0, 4]}], nodes});
  assert.deepEqual(tree.parents, [null, 0, 0, 2, null, undefined]);
  assert.deepEqual(["AGV", "Cell/AGV", "Arm/Jaw", "Cell/Arm/Jaw"].map((path) => nodeAt(tree, path)), [1, 1, 3, 3]);
  assert.equal(nodeAt(tree, "Jaw"), 4);  // exactly so
  for (const path of ["GV", "/AGV", "Cell/", "X/Cell/AGV", "ell/AGV", "Cell//AGV", "", "outside"]) assert.throws(() => nodeAt(tree, path), /no node/, path);
  const twice = treeOf({scenes: [{nodes: [0, 6]}], nodes: [...nodes, {name: "B", children: [7]}, {name: "AGV"}]});
  assert.throws(() => nodeAt(twice, "AGV"), /2 nodes `AGV`/);
  assert.equal(nodeAt(twice, "B/AGV"), 7);
});

test("Ancestors without a name are left out of paths, and a name may have a stroke", () => {
  const tree = treeOf({scenes: [{nodes: [0]}], nodes: [{children: [1]}, {name: "Cell", children: [2]}, {children: [3, 4]}, {name: "Door"}, {name: "A/B", children: [5]}, {}]});
  assert.deepEqual(tree.parents, [null, null, 1, 1, 1, 4]);
  assert.equal(nodeAt(tree, "Cell/Door"), 3);
  assert.equal(nodeAt(tree, "Cell/A/B"), 4);
  assert.throws(() => nodeAt(tree, "Cell//Door"), /no node/);
});

test("Paths of many nodes with long names below each other are compared without being made", () => {
  const name = "n".repeat(1000);
  const nodes = Array.from({length: 20000}, (_, i) => ({name, children: i % 64 < 63 && i < 19999 ? [i + 1] : []}));
  const tree = treeOf({scenes: [{nodes: nodes.flatMap((_, i) => i % 64 === 0 ? [i] : [])}], nodes: nodes.map((node, i) => i === 63 ? {name: "last"} : node)});
  const before = process.memoryUsage().heapUsed;
  assert.equal(nodeAt(tree, name + "/last"), 63);
  assert.ok(process.memoryUsage().heapUsed - before < 1e8);
});

test("The nodes of the examples are in their models", () => {
  for (const [folder, file] of [["cell", "cell.glb"], ["harbour-crane", "crane.glb"]]) {
    const bytes = readFileSync(join(kRoot, "examples", folder, file));
    const tree = treeOf(JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)).toString()));
    const text = readFileSync(join(kRoot, "examples", folder, "plant.json"), "utf8").replace(/\/\/.*$/gm, "");
    for (const {node} of Object.values(JSON.parse(text).view3d.nodes)) nodeAt(tree, node);
  }
});

test("Every shape has a body of whole triangles in its cell, and moves without leaving numbers", () => {
  const [, list] = readFileSync(join(kRoot, "runtime/tables/shape.hpp"), "utf8").match(/kShapeNames\{([^}]*)\}/);
  const names = [...list.matchAll(/"([a-z]+)"/g)].map(([, name]) => name);
  assert.equal(names.length, 19);
  for (const name of [...names, "unknown"]) {
    const {body, movers} = shapeOf(name);
    if (!["device", "unknown"].includes(name)) assert.notEqual(shapeOf(name), shapeOf("device"), name + " has the shape of a plain box");
    for (const {positions, normals} of [body, ...movers.map(({solid}) => solid)]) {
      assert.ok(positions.length > 0 && positions.length % 9 === 0 && positions.length === normals.length, name);
      for (let i = 0; i < positions.length; ++i) assert.ok(Math.abs(positions[i]) <= 1.5 && Number.isFinite(normals[i]), name);
    }
    for (const {at} of movers) for (const p of [0, .5, 1]) assert.ok(at(p).every(Number.isFinite), name);
  }
});

test("Matrices move, turn and place as the plan does", () => {
  near(pointAt(shift(1, 2, 3), 1, 1, 1), [2, 3, 4]);
  near(pointAt(turn("y", 90), 1, 0, 0), [0, 0, -1]);
  near(pointAt(turn("z", 90, [1, 0, 0]), 2, 0, 0), [1, 1, 0]);
  near(pointAt(after(shift(5, 0, 0), stretch(2, 1, 1)), 1, 1, 1), [7, 1, 1]);
  near(after(kSame, kSame), kSame);
  near(pointAt(placed({x: 3, y: 4, turn: 90}), 1, 0, 0), [3, 0, 5], "clockwise in the plan, whose y runs down");
});

test("From the overview each corner is seen, and the picture is filled", () => {
  for (const [box, aspect] of [[{min: [0, 0, 0], max: [40, 1, 10]}, 2], [{min: [-5, -1, -30], max: [5, 50, 30]}, 1.5], [{min: [3, 0, 3], max: [4, 1, 4]}, .5]]) {
    for (const slope of [.6, 1.4]) {
      const {from, to} = overviewOf(box, 30, aspect, slope);
      const length = Math.hypot(...from.map((value, i) => value - to[i]));
      const back = from.map((value, i) => (value - to[i]) / length);
      const up = [0, back[2], -back[1]];
      const seen = [0, 1, 2, 3, 4, 5, 6, 7].map((corner) => {
        const arm = from.map((value, k) => (corner >> k & 1 ? box.max[k] : box.min[k]) - value);
        const depth = -arm.reduce((sum, value, i) => sum + value * back[i], 0);
        const half = Math.tan(Math.PI / 12) * depth;
        return [arm[0] / (half * aspect), arm.reduce((sum, value, i) => sum + value * up[i], 0) / half];
      }).flat();
      const most = Math.max(...seen.map(Math.abs));
      assert.ok(most <= 1 && most > .8, String(most));
    }
  }
});

test("Without a graphics card fewer pixels are drawn while frames are slow, and all of them after a pause", () => {
  const pace = new Pace();
  let wall = 0;
  const frames = (count, each) => {
    let ratio = 1;
    for (let i = 0; i < count; ++i) ratio = pace.ratio(wall += each);
    return ratio;
  };
  assert.equal(frames(100, 33), 1);
  assert.equal(frames(12, 60), .8);
  assert.equal(Math.round(frames(200, 60) * 100), 64);
  assert.equal(frames(1, 300), 1);
  assert.equal(Math.round(frames(1, 33) * 100), 64);
});
