// The state that the page keeps of the plant.
import assert from "node:assert/strict";
import {test} from "node:test";
import {Names} from "../../../runtime/panel/page/names.js";
import {rank, Statuses} from "../../../runtime/panel/page/status.js";
import {Store} from "../../../runtime/panel/page/store.js";
import {commandsText, eventsText} from "../../../runtime/panel/page/tile.js";
import {isOn, levels, value, valueWithBit} from "../../../runtime/panel/page/words.js";
import {smallPicture, smallPlant} from "./plant.mjs";

const startedStore = () => {
  const store = new Store(smallPlant());
  store.picture(smallPicture());
  return store;
};

test("A picture sets everything, changes only what they name", () => {
  const store = startedStore();
  store.changes({rev: 2, t: 1e9, devices: [[0, 0, 1, 1, 0, 1e9, 6e8, 6e8]], symbols: [[0, true, 0, 1e9]]});
  assert.equal(store.target[0], 1);
  assert.equal(store.values[0], true);
  assert.equal(store.values[2], true);
  assert.equal(store.state[1], 1);
  assert.equal(store.t, 1e9);
});

test("Listeners get the indexes that changed", () => {
  const store = startedStore();
  let seen = null;
  store.listen((change) => { seen = change; });
  store.changes({rev: 2, t: 1, devices: [[1, 0, 0, 0, 0, 1, 0, 0]], symbols: [[2, false, 0, 1]], tracks: [[0, 1, [], [true], [0]]], places: [[0, []]],
    requirements: [[0, "violated", 1, 1]], clock: store.clock});
  assert.deepEqual([seen.all, seen.devices, seen.symbols, seen.tracks, seen.places, seen.requirements, [...seen.keys]],
    [false, [1], [2], [0], [0], [0], ["clock"]]);
  assert.deepEqual(store.places[0], []);
  assert.deepEqual(store.requirements[0], ["violated", 1, 1]);
  assert.deepEqual(store.tracks[0].stops, [true]);
});

test("Indexes that the plant does not have are ignored", () => {
  const store = startedStore();
  let seen = null;
  store.listen((change) => { seen = change; });
  store.changes({rev: 2, t: 1, devices: [[9, 0, 0, 0, 0, 0, 0, 0]], symbols: [[99, true, 0, 0]]});
  assert.equal(store.values.length, 4);
  assert.deepEqual([seen.devices, seen.symbols], [[], []]);
});

test("The count of forced symbols follows changes and pictures", () => {
  const store = startedStore();
  store.changes({rev: 2, t: 1, symbols: [[0, true, 1, 1], [1, true, 3, 1]]});
  assert.equal(store.forced, 2);
  store.changes({rev: 3, t: 2, symbols: [[0, true, 1, 1], [1, false, 2, 2]]});
  assert.equal(store.forced, 1);
  store.picture(smallPicture());
  assert.equal(store.forced, 0);
});

test("Findings are appended, and those of a picture replace all", () => {
  const store = startedStore();
  const finding = (n) => ({n, t: n, finding: "lost command", of: "LINE_S1_CLAMP", severity: "warning", text: "x"});
  store.changes({rev: 2, t: 1, findings: [finding(0)]});
  store.changes({rev: 3, t: 1, findings: [finding(1)]});
  assert.deepEqual(store.findings.map(({n}) => n), [0, 1]);
  for (let n = 2; n < 1500; ++n) store.changes({rev: n, t: n, findings: [finding(n)]});
  assert.equal(store.findings.length, 1000);
  store.picture(smallPicture());
  assert.equal(store.findings.length, 0);
});

test("A jump of plant time is seen: back, or by an act that resets or restores", () => {
  const store = startedStore();
  const jumped = [];
  store.listen((change) => jumped.push(change.jumped));
  const deed = (act) => ({n: 0, t: 5, by: "hand", act});
  store.changes({rev: 2, t: 10});
  store.changes({rev: 3, t: 5});
  store.changes({rev: 4, t: 90, acts: [deed({restore: "later"})]});
  store.changes({rev: 5, t: 95, acts: [deed({force: {X: true}})]});
  store.picture({...smallPicture(), t: 20});
  assert.deepEqual(jumped, [false, true, true, false, true]);
});

test("A move progresses with plant time, and rests while it is stopped, disabled or frozen", () => {
  const store = startedStore();
  store.changes({rev: 2, t: 1e9, devices: [[0, 0, 1, 1, 0, 1e9, 6e8, 1e9]]});
  assert.deepEqual(store.progress(0, 1e9), {left: 6e8, done: .4});
  assert.deepEqual(store.progress(0, 1.3e9), {left: 3e8, done: .7});
  assert.deepEqual(store.progress(0, 9e9), {left: 0, done: 1});
  for (const flags of [1 | 2, 1 | 4, 1 | 8]) {
    store.changes({rev: 3, t: 1e9, devices: [[0, 0, 1, flags, 0, 1e9, 6e8, 1e9]]});
    assert.equal(store.progress(0, 1.3e9).left, 6e8);
  }
});

test("Parts move with their speed from the time of their entry, and not beyond the track", () => {
  const store = startedStore();
  assert.deepEqual(store.partsOn(0, 2e9), [[1, 0, 1300000, 400000]]);
  assert.equal(store.partsOn(0, 60e9)[0][2], 3000000);
  assert.equal(store.partsOn(0, -1e9)[0][2], 500000);
});

test("A device shows its most urgent status, and its station counts them", () => {
  const store = startedStore();
  const statuses = new Statuses(store, new Names(store.plant));
  const changed = (event) => {
    let found = null;
    const end = store.listen((change) => { found = statuses.update(change); });
    store.changes(event);
    end();
    return [...found];
  };
  statuses.update({all: true, devices: [], symbols: [], keys: new Set()});
  assert.deepEqual([...statuses.of], [rank.waits, rank.contact]);
  assert.deepEqual(changed({rev: 2, t: 1, devices: [[0, 0, 1, 1, 0, 1, 5, 5]]}), [0]);
  assert.equal(statuses.of[0], rank.moving);
  assert.equal(statuses.stations[0][rank.moving], 1);
  assert.equal(statuses.worst(statuses.stations[0]), rank.moving);
  changed({rev: 3, t: 2, devices: [[0, 1, 1, 0, 0, 2, 0, 0]]});
  assert.equal(statuses.of[0], rank.waits);
  assert.deepEqual(changed({rev: 3, t: 2, symbols: [[0, true, 0, 2]]}), [0]);
  assert.equal(statuses.of[0], rank.commanded);
  changed({rev: 3, t: 2, devices: [[0, 0, 0, 4, 1, 1, 0, 0]]});
  assert.equal(statuses.of[0], rank.blocked);
  changed({rev: 4, t: 3, findings: [{n: 0, t: 3, finding: "x", of: "LINE_S1_DOOR_I_SHUT", severity: "warning", text: "x"}]});
  assert.deepEqual([...statuses.of], [rank.blocked, rank.finding]);
  assert.deepEqual(changed({rev: 5, t: 70e9}), [1]);
  assert.deepEqual([...statuses.of], [rank.blocked, rank.contact]);
});

test("An inverted symbol is shown by its meaning, and its bit only where it is asked for", () => {
  const plain = {type: "BOOL", inverted: false};
  const inverted = {type: "BOOL", inverted: true};
  assert.deepEqual([true, false].map((bit) => value(bit, plain)), ["on", "off"]);
  assert.deepEqual([true, false].map((bit) => value(bit, inverted)), ["off", "on"]);
  assert.deepEqual([true, false].map((bit) => valueWithBit(bit, inverted)), ["off (bit 1)", "on (bit 0)"]);
  assert.deepEqual([true, 5].map((of) => valueWithBit(of, plain)), ["on", "5"]);
  assert.equal(value(5, {type: "INT", inverted: false}), "5");
  assert.deepEqual([isOn(plain, true), isOn(inverted, true), isOn(inverted, false), isOn(plain, 0), isOn(plain, 3)], [true, false, true, false, true]);
  assert.deepEqual(levels(plain), [["on", true], ["off", false]]);
  assert.deepEqual(levels(inverted), [["on", false], ["off", true]]);
});

test("A tile and a status use the meaning of inverted symbols", () => {
  const plant = smallPlant();
  plant.symbols[0].inverted = plant.symbols[1].inverted = true;
  const store = new Store(plant);
  store.picture(smallPicture());
  const [device] = plant.devices;
  assert.equal(commandsText(store, device), "▸CLOSE");
  assert.equal(eventsText(store, device), "■");
  const statuses = new Statuses(store, new Names(plant));
  statuses.update({all: true, symbols: [], devices: [], keys: new Set()});
  store.changes({rev: 2, t: 1, devices: [[0, 1, 1, 0, 0, 1, 0, 0]], symbols: [[1, true, 0, 1]]});
  statuses.update({all: true, symbols: [], devices: [], keys: new Set()});
  assert.equal(statuses.of[0], rank.commanded);
  assert.equal(eventsText(store, device), "□");
  store.changes({rev: 3, t: 2, symbols: [[0, true, 0, 2]]});
  statuses.update({all: true, symbols: [], devices: [], keys: new Set()});
  assert.equal(statuses.of[0], rank.waits);
  assert.equal(commandsText(store, device), "");
});
