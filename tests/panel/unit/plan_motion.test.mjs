// Moves that are diverted: what is shown goes on from where it was.
import assert from "node:assert/strict";
import {test} from "node:test";
import {poseAt} from "../../../runtime/panel/page/motion.js";
import {motionOf} from "../../../runtime/panel/page/plan/motion.js";
import {Store} from "../../../runtime/panel/page/store.js";
import {smallPicture, smallPlant} from "./plant.mjs";

const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, a + " is not " + b);

const kMoving = 1;
const kStates = ["P1", "P2", "P3", "P4", "P5"];

/// A store of a vehicle with five positions that is in the first one, and `at(t, state, target, remaining, whole)`, an event.
const vehicle = (shape = "vehicle") => {
  const [first, ...others] = smallPlant().devices;
  const store = new Store({...smallPlant(), devices: [{...first, shape, states: kStates}, ...others]});
  store.picture(smallPicture());
  const at = (t, state, target, remaining, whole) => store.changes({rev: 1, t, devices: [[0, state, target, state === target ? 0 : kMoving, 0, t, remaining, whole]]});
  return {store, at, amount: (now) => motionOf(store, 0, now).amount, turn: (now) => motionOf(store, 0, now).turn};
};

test("A move that is diverted to a third state goes on from where it was, and ends in its target", () => {
  const {at, amount} = vehicle();
  at(0, 0, 4, 1000, 1000);
  near(amount(500), .5);
  at(500, 0, 1, 400, 400);
  near(amount(500), .5);
  near(amount(700), .375);
  near(amount(900), .25);
  at(700, 0, 2, 100, 100);
  near(amount(700), .375);
  near(amount(800), .5);
  at(800, 2, 2, 0, 0);
  near(amount(800), .5);
  at(900, 2, 0, 100, 100);
  near(amount(950), .25);
});

test("A move that reverses, stops midway and goes on has no jump", () => {
  const {store, at, amount} = vehicle();
  at(0, 0, 4, 1000, 1000);
  at(600, 4, 0, 600, 1000);
  near(amount(600), .6);
  near(amount(900), .3);
  store.changes({rev: 2, t: 900, devices: [[0, 4, 0, 3, 0, 900, 300, 1000]]});
  near(amount(5000), .3);
  at(6000, 4, 0, 300, 1000);
  near(amount(6000), .3);
  near(amount(6300), 0);
});

test("A device that is put into a state, and a plant that jumps, begin there", () => {
  const {store, at, amount} = vehicle();
  at(0, 0, 4, 1000, 1000);
  at(500, 2, 3, 100, 100);
  near(amount(500), .5);
  near(amount(550), .625);
  at(560, 2, 0, 100, 100);
  assert.ok(store.paths[0]);
  store.changes({rev: 3, t: 10, devices: [[0, 2, 4, kMoving, 0, 10, 100, 100]]});
  near(amount(10), .5);
  at(20, 2, 0, 100, 100);
  store.picture(smallPicture());
  assert.equal(store.paths[0], null);
});

test("A turntable that is diverted across its first position does not turn around", () => {
  const {at, turn} = vehicle("turntable");
  at(0, 4, 4, 0, 0);
  at(10, 4, 0, 100, 100);
  near(turn(60), .9);
  at(60, 4, 1, 100, 100);
  near(turn(60), .9);
  near(turn(160), 1.2);
});

test("After any moves what is shown changes with time only, and the path stays short", () => {
  const {store, at, amount} = vehicle();
  for (let i = 0; i < 100; ++i) {
    const before = amount(50 * i);
    at(50 * i, 0, 1 + i % 4, 100, 100);
    if (i > 0) assert.ok(Math.abs(amount(50 * i) - before) < .01, "event " + i);
  }
  assert.ok(store.paths[0].steps.length <= 8);
});

test("A pose may be anything that can be mixed", () => {
  const {store, at} = vehicle();
  const poses = [[0, 0], [1, 0], [0, 1], [1, 1], [2, 2]];
  const mix = (a, b, part) => a.map((value, i) => value + (b[i] - value) * part);
  at(0, 0, 4, 100, 100);
  at(50, 0, 1, 100, 100);
  assert.deepEqual(poseAt(store, 0, 50, (state) => poses[state], mix), [1, 1]);
  assert.deepEqual(poseAt(store, 0, 100, (state) => poses[state], mix), [1, .5]);
});
