// The layout that all see: it follows the revisions of the stream.
import assert from "node:assert/strict";
import {test} from "node:test";
import {LayoutState} from "../../../runtime/panel/page/plan/layout_state.js";
import {smallPlant} from "./plant.mjs";

const pause = (time = 0) => new Promise((done) => setTimeout(done, time));
const planAt = (x) => ({frames: {"LINE S1": {x, y: 0}}});
const kAll = {all: true, keys: new Set()};
const kLayout = {all: false, keys: new Set(["layout"])};

/// A layout whose requests are answered by hand: each has answer(revision, x) and fail().
const byHand = (again = 1e6) => {
  const requests = [];
  const layout = () => new Promise((done, fail) => requests.push({answer: async (revision, x) => (done({revision, plan: planAt(x)}), pause()), fail: async () => (fail(new Error("lost")), pause())}));
  const app = {plant: smallPlant(), store: {layout: 1}, api: {layout}};
  const state = new LayoutState(app, again);
  return {requests, app, state, x: () => state.placed.frames[0].x};
};

test("A new revision in the stream loads the layout, once", async () => {
  const plant = smallPlant();
  const asked = [];
  const app = {plant, store: {layout: 1}, api: {layout: async () => (asked.push(app.store.layout), {revision: app.store.layout, plan: {frames: {"LINE S1": {x: 10 * app.store.layout, y: 0}}}})}};
  const layout = new LayoutState(app);
  let calls = 0;
  const end = layout.listen(() => ++calls);
  const change = (keys) => layout.change({all: false, keys: new Set(keys)});
  change(["clock"]);
  assert.deepEqual(asked, []);
  layout.change({all: true, keys: new Set()});
  change(["layout"]);
  await new Promise((done) => setTimeout(done));
  assert.deepEqual([asked, calls, layout.placed.frames[0].x], [[1], 1, 10]);
  app.store.layout = 2;
  change(["layout"]);
  await new Promise((done) => setTimeout(done));
  assert.deepEqual([calls, layout.placed.frames[0].x], [2, 20]);
  const recording = new LayoutState({...app, store: {layout: null}});
  recording.change({all: true, keys: new Set()});
  await new Promise((done) => setTimeout(done));
  recording.change({all: true, keys: new Set()});
  assert.equal(asked.length, 3);
  end();
  layout.set({});
  assert.equal(calls, 2);
});

test("A revision that comes while another is loaded is loaded next; one request at a time", async () => {
  const {requests, app, state, x} = byHand();
  state.change(kAll);
  app.store.layout = 2;
  state.change(kLayout);
  assert.equal(requests.length, 1);
  await requests[0].answer(1, 10);
  assert.deepEqual([requests.length, x()], [2, 10]);
  await requests[1].answer(2, 20);
  assert.deepEqual([requests.length, x(), state.revision], [2, 20, 2]);
});

test("The revision is that of the answer: a newer one is not loaded twice, an older one is dropped", async () => {
  const {requests, app, state, x} = byHand();
  state.change(kAll);
  const late = state.load();
  await requests[0].answer(3, 30);
  await requests[1].answer(2, 20);
  assert.equal(await late, true);
  assert.deepEqual([x(), state.revision], [30, 3]);
  app.store.layout = 3;
  state.change(kLayout);
  assert.equal(requests.length, 2);
});

test("A layout that did not come is asked for again after a while, and an answer that is too old, too", async () => {
  const {requests, state, x} = byHand(5);
  state.change(kAll);
  await requests[0].fail();
  assert.equal(requests.length, 1);
  await pause(50);
  assert.equal(requests.length, 2);
  await requests[1].answer(0, 5);
  assert.equal(requests.length, 2);
  await pause(50);
  assert.equal(requests.length, 3);
  await requests[2].answer(1, 10);
  await pause(50);
  assert.deepEqual([requests.length, x()], [3, 10]);
});
