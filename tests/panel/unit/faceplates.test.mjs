// What is held is released, whatever happens; which acts a person's controls send; comments; ranges of set points.
import assert from "node:assert/strict";
import {test} from "node:test";
import {commentOf, commonWords, deviceTitle} from "../../../runtime/panel/page/comments.js";
import {Holds} from "../../../runtime/panel/page/holds.js";
import {Names} from "../../../runtime/panel/page/names.js";
import {operatedSymbols} from "../../../runtime/panel/page/layout.js";
import {contactState, isContact, isSettable, mayOperateContact, otherState, setAct, stateAct, writerText} from "../../../runtime/panel/page/person.js";
import {mayOperate} from "../../../runtime/panel/page/rights.js";
import {spanOf} from "../../../runtime/panel/page/set_point.js";
import {symbolFilter} from "../../../runtime/panel/page/io_filter.js";
import {Store} from "../../../runtime/panel/page/store.js";
import {smallPicture, smallPlant} from "./plant.mjs";

const kHold = {name: "START", on: {set: {START: true}}, off: {set: {START: false}}};
const failing = (status, message = "no") => Object.assign(new Error(message), {status});

/// Holds with a plant that answers as `answers` says, in order, and then with success.
const bench = (answers = []) => {
  const of = {sent: [], notices: [], kept: new Map(), left: []};
  const api = {run: "r1", leave: (...acts) => of.left.push(...acts), acts: async (act) => {
    of.sent.push(act);
    const answer = answers.shift();
    if (answer?.wait) await answer.wait;
    if (answer?.status !== undefined) throw answer;
    return {t: 1};
  }};
  const storage = {getItem: (key) => of.kept.get(key) ?? null, setItem: (key, text) => of.kept.set(key, text), removeItem: (key) => of.kept.delete(key)};
  of.app = {api, lost: false, deniedText: "denied"};
  of.holds = new Holds(of.app, {show: (kind, text, closes = false) => of.notices.push([text, closes])}, storage);
  return of;
};
const soon = () => new Promise((done) => setTimeout(done, 5));

test("What is pressed is on until it is let go", async () => {
  const {holds, sent, kept} = bench();
  const over = holds.begin(kHold, "pointer 1");
  holds.begin(kHold, "key Space");  // a second one has no effect
  await soon();
  assert.equal(holds.phase("START"), "held");
  assert.equal(kept.size, 1);
  holds.endBy("pointer 2");
  await soon();
  assert.deepEqual(sent, [kHold.on]);
  holds.endBy("pointer 1");
  await over;
  assert.deepEqual(sent, [kHold.on, kHold.off]);
  assert.equal(holds.phase("START"), "");
  assert.equal(kept.size, 0);
});

test("A release before the answer follows the answer, so that it cannot come first", async () => {
  let answer;
  const {holds, sent} = bench([{wait: new Promise((done) => { answer = done; })}]);
  const over = holds.begin(kHold, "pointer 1");
  holds.endAll();
  await soon();
  assert.deepEqual(sent, [kHold.on]);
  answer();
  await over;
  assert.deepEqual(sent, [kHold.on, kHold.off]);
});

test("What is pressed again during its release is pressed after it, and a short tap then is not lost", async () => {
  let answer;
  const {holds, sent} = bench([{}, {wait: new Promise((done) => { answer = done; })}]);
  const over = holds.begin(kHold, "pointer 1");
  await soon();
  holds.endAll();
  await soon();
  holds.begin(kHold, "key Space");
  holds.endBy("key Space");
  assert.deepEqual(sent, [kHold.on, kHold.off]);
  answer();
  await over;
  assert.deepEqual(sent, [kHold.on, kHold.off, kHold.on, kHold.off]);
});

test("A press during a release that gets lost is not done later", async () => {
  let answer;
  const {holds, sent} = bench([{}, Object.assign(failing(0), {wait: new Promise((done) => { answer = done; })})]);
  const over = holds.begin(kHold, "pointer 1");
  await soon();
  holds.endAll();
  await soon();
  holds.begin(kHold, "pointer 1");  // the release is under way
  answer();
  await soon();
  holds.begin(kHold, "pointer 1");  // it is stuck
  holds.endAll();
  holds.connected();
  await over;
  await soon();
  assert.deepEqual(sent, [kHold.on, kHold.off, kHold.off]);
});

test("What was refused is not released; what may have been done is", async () => {
  const refused = bench([failing(422)]);
  await refused.holds.begin(kHold, "pointer 1");
  assert.deepEqual(refused.sent, [kHold.on]);
  const unknown = bench([failing(0)]);
  await unknown.holds.begin(kHold, "pointer 1");
  assert.deepEqual(unknown.sent, [kHold.on, kHold.off]);
  const lost = bench();
  lost.app.lost = true;
  await lost.holds.begin(kHold, "pointer 1");
  assert.deepEqual(lost.sent, []);
});

test("A lost release is tried until it is done, at once when the connection is back; the page says that it is still pressed", async () => {
  const {holds, sent, notices, kept} = bench([{}, failing(0, "the plant does not answer"), failing(422, "too late")]);
  const begin = performance.now();
  const over = holds.begin(kHold, "pointer 1");
  await soon();
  holds.disconnected();
  await soon();
  assert.equal(holds.phase("START"), "stuck");
  assert.deepEqual(notices, [["START is still pressed: the plant does not answer", false]]);
  assert.equal(kept.size, 1);
  holds.connected();
  await soon();
  assert.equal(sent.length, 3);
  await over;  // a second later
  assert.ok(performance.now() - begin > 900);
  assert.deepEqual(sent.slice(1), [kHold.off, kHold.off, kHold.off]);
  assert.deepEqual(notices[notices.length - 1], ["", false]);
});

test("A release that is denied is not tried again, and its notice stays until it is closed", async () => {
  const {holds, sent, notices} = bench([{}, failing(403, "the panel only shows")]);
  const over = holds.begin(kHold, "pointer 1");
  await soon();
  holds.end("START");
  await over;
  assert.equal(sent.length, 2);
  assert.deepEqual(notices, [["START is still pressed: the panel only shows", true]]);
});

test("A page that is closed sends the release; one that is loaded again releases what it had held, in the same run only", async () => {
  const first = bench([{}, failing(0)]);
  first.holds.begin(kHold, "pointer 1");
  await soon();
  first.holds.farewell();
  assert.deepEqual(first.left, [kHold.off]);
  const again = bench();
  for (const [key, text] of first.kept) again.kept.set(key, text);
  await again.holds.recover();
  assert.deepEqual(again.sent, [kHold.off]);
  assert.equal(again.kept.size, 0);
  const other = bench();
  for (const [key, text] of first.kept) other.kept.set(key, text);
  other.app.api.run = "r2";
  await other.holds.recover();
  assert.deepEqual(other.sent, []);
  first.holds.connected();
});

test("A person sets what nothing else writes, by its meaning", () => {
  const plant = {...smallPlant(), programs: [{name: "cell"}]};
  const [operation, driven, contact] = plant.symbols;
  assert.deepEqual([operation, driven, contact].map((symbol) => isSettable(plant, symbol)), [true, false, true]);
  assert.equal(writerText(plant, {...operation, link: 0}), "written by the PLC over modbus-tcp-server://127.0.0.1:1502");
  assert.equal(writerText(plant, {...operation, link: 0, program: 0}), "written by the program cell");
  assert.equal(isSettable(plant, {...operation, link: 0}), false);
  assert.deepEqual(setAct(operation, true), {set: {LINE_S1_CLAMP_O_CLOSE: true}});
  assert.deepEqual(setAct({...operation, inverted: true}, true), {set: {LINE_S1_CLAMP_O_CLOSE: false}});
});

test("A contact is put into a state, or by its events if a trainee may operate only these", () => {
  const plant = smallPlant();
  const [clamp, door] = plant.devices;
  assert.deepEqual([clamp, door].map((device) => isContact(plant, device)), [false, true]);
  assert.deepEqual([otherState(door, 0), otherState({states: ["A", "B", "C"]}, 0)], [1, -1]);
  const store = new Store(plant);
  store.picture(smallPicture());
  const appOf = (rights) => {
    const app = {plant, store, rights, canAct: rights === "all"};
    return Object.assign(app, {may: (kind, index) => mayOperate(app, kind, index)});
  };
  assert.deepEqual(stateAct(appOf("all"), 1, "SHUT"), {state: {LINE_S1_DOOR: "SHUT"}});
  assert.equal(mayOperateContact(appOf("all"), 1), true);
  const trainee = appOf("allowed");
  store.allowed = {symbols: [], devices: [1], values: [], locations: []};
  assert.deepEqual(stateAct(trainee, 1, "SHUT"), {state: {LINE_S1_DOOR: "SHUT"}});
  store.allowed = {symbols: door.events, devices: [], values: [], locations: []};
  assert.equal(mayOperateContact(trainee, 1), true);
  assert.deepEqual(stateAct(trainee, 1, "SHUT"), {set: {LINE_S1_DOOR_I_SHUT: true}});
  assert.deepEqual(stateAct(trainee, 1, "NOT_SHUT"), {set: {LINE_S1_DOOR_I_SHUT: false}});
  assert.equal(contactState(trainee, 1), 1);
  store.changes({rev: 2, t: 1, symbols: [[2, false, 0, 1]]});
  assert.equal(contactState(trainee, 1), 0);
  assert.equal(store.state[1], 1);  // its state itself stays
  store.allowed = {symbols: [], devices: [], values: [], locations: []};
  assert.equal(mayOperateContact(trainee, 1), false);
  assert.equal(mayOperateContact(appOf("none"), 1), false);
});

test("The comment of a device is what those of its symbols have in common", () => {
  assert.equal(commonWords(["Clamp 1: close", "Clamp 1: open", undefined]), "Clamp 1");
  assert.equal(commonWords(["Clamp 1 close"]), "Clamp 1 close");
  assert.equal(commonWords(["Clamp 12", "Clamp 1"]), "Clamp");
  assert.equal(commonWords(["up", "down"]), "");
  assert.equal(commonWords([]), "");
  const plant = smallPlant();
  plant.symbols[0].comment = "Clamp 1 close";
  plant.symbols[1].comment = "Clamp 1 is closed";
  assert.equal(commentOf(plant, "device", 0), "Clamp 1");
  assert.equal(commentOf(plant, "symbol", 2), "");
  assert.equal(deviceTitle(plant, plant.devices[0]), "LINE_S1_CLAMP\nO_CLOSE: Clamp 1 close\nI_CLOSE: Clamp 1 is closed");
  assert.equal(deviceTitle(plant, plant.devices[1]), "LINE_S1_DOOR");
});

test("Search and the filter of the I/O view find comments", () => {
  const plant = smallPlant();
  plant.symbols[2].comment = "Safety door, hall 3";
  const names = new Names(plant);
  assert.deepEqual(names.search("hall safety", 9).map(({kind, name}) => [kind, name]), [["device", "LINE_S1_DOOR"], ["symbol", "LINE_S1_DOOR_I_SHUT"]]);
  const accepts = symbolFilter({text: "hall"}, new Store(plant));
  assert.deepEqual([0, 1, 2, 3].filter((index) => accepts(index)), [2]);
});

test("Symbols in no device belong to the device with whose name theirs begin; buttons to their station", () => {
  const plant = smallPlant();
  const loose = (name, more = {}) => plant.symbols.push({...plant.symbols[3], name, ...more}) - 1;
  const speed = loose("LINE_S1_CLAMP_O_SPEED");
  const button = loose("LINE_S1_PB_I_START", {operator: true});
  const other = loose("HALL_LIGHT", {operator: true});
  loose("LINE_S1_CLAMPED_I_X");
  const names = new Names(plant);
  assert.deepEqual(names.looseSymbolsOf(0), [speed]);
  assert.deepEqual(names.looseSymbolsOf(1), []);
  assert.deepEqual([...operatedSymbols(plant)], [[0, [button]], [null, [other]]]);
});

test("A slider of a set point has a range that its number and its type allow", () => {
  assert.deepEqual(spanOf(0, "INT"), {min: 0, max: 100, step: 1});
  assert.deepEqual(spanOf(1500, "INT"), {min: 0, max: 2000, step: 2});
  assert.deepEqual(spanOf(-7, "INT"), {min: -100, max: 100, step: 1});
  assert.deepEqual(spanOf(30000, "INT"), {min: 0, max: 32767, step: 33});
  assert.deepEqual(spanOf(5, "WORD"), {min: 0, max: 100, step: 1});
  assert.deepEqual(spanOf(12.5, "REAL"), {min: 0, max: 100, step: .1});
  assert.equal(spanOf(NaN, "REAL"), null);
  assert.equal(spanOf(2 ** 60, "LINT"), null);
});
