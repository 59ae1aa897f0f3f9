// Alarms: what the page keeps of them, what it shows first, and the horn.
import assert from "node:assert/strict";
import {test} from "node:test";
import {actText} from "../../../runtime/panel/page/act_words.js";
import {AlarmState, byUrgency} from "../../../runtime/panel/page/alarm_state.js";
import {Horn} from "../../../runtime/panel/page/horn.js";
import {Store} from "../../../runtime/panel/page/store.js";
import {smallPicture, smallPlant} from "./plant.mjs";

const alarm = (name, state, priority = "high", more = {}) => ({name, state, on: state !== "gone", priority, source: "alarm", of: name, text: name, station: 0, came: 1, went: null,
  count: 1, until: null, ...more});

const stateOf = (...list) => {
  const state = new AlarmState();
  state.apply({all: true, horn: true, dropped: 0, list, left: []});
  return state;
};

test("A picture replaces the list, changes only what they name, and what left is removed", () => {
  const store = new Store(smallPlant());
  store.picture({...smallPicture(), alarms: {all: true, horn: false, dropped: 2, list: [alarm("a", "active"), alarm("b", "gone")], left: []}});
  let seen = null;
  store.listen((change) => { seen = change; });
  store.changes({rev: 2, t: 1, alarms: {all: false, horn: true, dropped: 2, list: [alarm("a", "acknowledged"), alarm("c", "active")], left: ["b"]}});
  assert.deepEqual([...store.alarms.byName.values()].map(({name, state}) => name + " " + state), ["a acknowledged", "c active"]);
  assert.ok(seen.keys.has("alarms"));
  assert.deepEqual([store.alarms.horn, store.alarms.dropped], [true, 2]);
  store.changes({rev: 3, t: 1, alarms: {all: true, horn: false, dropped: 0, list: [], left: []}});
  assert.equal(store.alarms.size, 0);
  store.changes({rev: 4, t: 1});
  assert.ok(!seen.keys.has("alarms"));
  store.picture(smallPicture());  // of a server without alarms
  assert.equal(store.alarms.size, 0);
});

test("What waits is counted by priority, and the most urgent comes first, the newest of them", () => {
  const state = stateOf(alarm("a", "active", "low", {came: 9}), alarm("b", "active", "high", {came: 2}), alarm("c", "gone", "high", {came: 3}),
    alarm("d", "acknowledged", "high", {came: 8}), alarm("e", "shelved", "high", {came: 8}), alarm("f", "active", "medium"));
  assert.deepEqual(state.counts, {high: 2, medium: 1, low: 1});
  assert.equal(state.first.name, "c");
  assert.deepEqual([...state.byName.values()].sort(byUrgency).map(({name}) => name).slice(0, 4), ["c", "b", "f", "a"]);
  assert.equal(stateOf(alarm("d", "acknowledged")).first, null);
});

test("A filter shows a station, a priority or a state, and never what is shelved", () => {
  const state = stateOf(alarm("a", "active", "low"), alarm("b", "gone", "high", {station: null}), alarm("c", "acknowledged", "high", {station: 1}), alarm("d", "shelved", "high", {until: 5}),
    alarm("e", "shelved", "high", {until: 2}));
  const names = (filter) => state.filtered(filter).map(({name}) => name);
  assert.deepEqual(names({}), ["b", "a", "c"]);
  assert.deepEqual(names({priority: "high"}), ["b", "c"]);
  assert.deepEqual(names({station: "0"}), ["a"]);
  assert.deepEqual(names({station: "none"}), ["b"]);
  assert.deepEqual(names({state: "unacknowledged"}), ["b", "a"]);
  assert.deepEqual(names({state: "gone"}), ["b"]);
  assert.deepEqual(state.shelved().map(({name}) => name), ["e", "d"]);
});

/// An AudioContext that counts what sounds.
const mockContext = () => {
  const context = {sounding: 0, closed: false, destination: {}, close() { this.closed = true; },
    createGain: () => ({gain: {value: 0}, connect() {}}),
    createOscillator: () => ({frequency: {value: 0}, connect() {}, start() { context.sounding += 1; }, stop() { context.sounding -= 1; }})};
  return context;
};

test("The horn sounds only while the user has switched it on and there is a reason", () => {
  const context = mockContext();
  let made = 0;
  const horn = new Horn(() => {
    made += 1;
    return context;
  });
  horn.update(true);
  assert.deepEqual([made, horn.sounds], [0, false]);
  horn.switch(true);
  assert.equal(context.sounding, 2);
  horn.update(true);
  assert.equal(context.sounding, 2);
  horn.update(false);
  assert.deepEqual([context.sounding, horn.isOn], [0, true]);
  horn.update(true);
  horn.switch(false);
  assert.deepEqual([context.sounding, context.closed, horn.isOn, made], [0, true, false, 1]);
});

test("Acts on alarms have words", () => {
  assert.equal(actText({acknowledge: "all"}), "acknowledged all alarms");
  assert.equal(actText({acknowledge: ["a", "b", "c", "d", "e"]}), "acknowledged a, b, c and 2 more");
  assert.equal(actText({shelve: "a", for: "10min"}), "shelved a, for 10min");
  assert.equal(actText({unshelve: "a"}), "unshelved a");
  assert.equal(actText({silence: true}), "silenced the horn");
});
