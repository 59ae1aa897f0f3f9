// Where things are in the line view, the ticks of axes, and words.
import assert from "node:assert/strict";
import {test} from "node:test";
import {actText} from "../../../runtime/panel/page/act_words.js";
import {speedText} from "../../../runtime/panel/page/control.js";
import {filterSymbols} from "../../../runtime/panel/page/io_filter.js";
import {groupDevices, neighbor, placeMarks, placeNames, placeTiles, stationsOf, ticks} from "../../../runtime/panel/page/layout.js";
import {Names} from "../../../runtime/panel/page/names.js";
import {Store} from "../../../runtime/panel/page/store.js";
import {clockText, count, cutMiddle, duration, exactInstant, instant, length, readValue, withRoundTimes} from "../../../runtime/panel/page/words.js";
import {smallPicture, smallPlant} from "./plant.mjs";

test("Tiles fill rows; those with a view are at their place, and no other is there", () => {
  assert.deepEqual(placeTiles([undefined, undefined, undefined], 2), {cells: [[0, 0], [1, 0], [0, 1]], columns: 2, rows: 2});
  assert.deepEqual(placeTiles([{x: 0, y: 0}, undefined, undefined], 2).cells, [[0, 0], [1, 0], [0, 1]]);
  const {cells, columns, rows} = placeTiles([{x: 3, y: 1.5}, undefined], 2);
  assert.deepEqual([cells, columns, rows], [[[3, 1.5], [0, 0]], 4, 3]);
  assert.deepEqual(placeTiles([], 3), {cells: [], columns: 1, rows: 0});
});

test("Arrow keys lead to the nearest tile in their direction", () => {
  const {cells} = placeTiles(Array(5).fill(undefined), 3);
  assert.deepEqual([neighbor(cells, 0, "ArrowRight"), neighbor(cells, 0, "ArrowDown"), neighbor(cells, 4, "ArrowUp"), neighbor(cells, 0, "ArrowLeft")], [1, 3, 1, 0]);
});

test("A track belongs to the stations of its sensors; devices are grouped by station", () => {
  const plant = smallPlant();
  assert.deepEqual(stationsOf(plant.locations[0], plant), [0]);
  assert.deepEqual(stationsOf(plant.locations[1], plant), []);
  plant.devices[1].station = null;
  assert.deepEqual(groupDevices(plant), [{station: 0, devices: [0]}, {station: null, devices: [1]}]);
});

test("Ticks are round numbers within the range", () => {
  assert.deepEqual(ticks(0, 10, 5), [0, 2, 4, 6, 8, 10]);
  assert.deepEqual(ticks(3, 17, 3), [5, 10, 15]);
  assert.deepEqual(ticks(5, 5, 3), []);
});

test("Times, lengths and counts are readable", () => {
  assert.deepEqual([0, 850e6, 12.3e9, 185e9, 7500e9, 1500].map(duration), ["0 ns", "850 ms", "12.3 s", "3 min 5 s", "2 h 5 min", "1.5 us"]);
  assert.equal(instant(12340000000), "12.34 s");
  assert.equal(clockText(3723.4e9), "1:02:03.4");
  assert.deepEqual([0, 300000, 1500000].map(length), ["0", "300 mm", "1.5 m"]);
  assert.deepEqual([count(1, "part"), count(2, "part")], ["1 part", "2 parts"]);
});

test("Values are read by the symbol's type; large integers stay texts", () => {
  assert.deepEqual(readValue("ON", "BOOL"), {value: true});
  assert.deepEqual(readValue("0", "BOOL"), {value: false});
  assert.deepEqual(readValue(" 12 ", "INT"), {value: 12});
  assert.deepEqual(readValue("18446744073709551615", "ULINT"), {value: "18446744073709551615"});
  assert.deepEqual(readValue("16#FF", "WORD"), {value: "16#FF"});
  assert.deepEqual(readValue("1.5e3", "REAL"), {value: 1500});
  assert.ok(readValue("much", "INT").error);
  assert.ok(readValue("", "INT").error);
  assert.ok(readValue("2", "BOOL").error);
});

test("Symbols are filtered by all words, direction, force, link and driver", () => {
  const store = new Store(smallPlant());
  store.picture(smallPicture());
  const found = (filter) => filterSymbols({text: "", direction: "", ...filter}, store);
  assert.deepEqual(found({}), [0, 1, 2, 3]);
  assert.deepEqual(found({text: "clamp close"}), [0, 1]);
  assert.deepEqual(found({text: "x1"}), [2]);
  assert.deepEqual(found({direction: "operation"}), [0]);
  assert.deepEqual(found({unlinked: true}), [0]);
  assert.deepEqual(found({undriven: true}), [2]);
  store.changes({rev: 2, t: 20e9, symbols: [[1, true, 1, 19e9], [2, true, 2, 1e9]]});
  assert.deepEqual(found({forced: true}), [1]);
  assert.deepEqual(found({malfunction: true}), [2]);
  assert.deepEqual(found({lately: true}), [1]);
});

test("Names are found by parts, and their kinds are known", () => {
  const names = new Names(smallPlant());
  assert.deepEqual(names.find("BELT"), {kind: "location", index: 0});
  assert.deepEqual(names.find("never both"), {kind: "requirement", index: 0});
  assert.equal(names.find("NOTHING"), null);
  assert.deepEqual(names.search("clamp", 9).map(({kind}) => kind), ["device", "symbol", "symbol"]);
  assert.deepEqual(names.search("x2", 9).map(({name}) => name), ["LINE_S1_PE_I_PART"]);
  assert.deepEqual(names.search("clamp door", 9), []);
  assert.deepEqual(names.search("  ", 9), []);
  assert.deepEqual(names.search("clamp", 1, (kind, index) => kind === "symbol" && index === 1).map(({name}) => name), ["LINE_S1_CLAMP_I_CLOSE"]);
});

const placed = (ats, wide = 40) => {
  const sensors = ats.map((at) => ({at, text: String(at), wide}));
  placeMarks(sensors, (at) => at);
  placeNames(sensors, 200);
  return sensors;
};

test("Names of sensors are written where they overlap no other and do not leave the strip", () => {
  assert.deepEqual(placed([10, 50, 75, 120, 190]).map(({shown}) => shown), ["", "50", "", "120", ""]);
});

test("Sensors at one position are side by side, the names of the outer ones away from each other", () => {
  const marks = (ats) => placed(ats, 20).map(({mark}) => mark);
  assert.deepEqual(marks([100, 100]), [93, 107]);
  assert.deepEqual(marks([100, 40, 100, 100]), [86, 40, 100, 114]);
  assert.deepEqual(marks([100, 106]), [96, 110]);
  assert.deepEqual(marks([100, 114]), [100, 114]);
  const [first, middle, last] = placed([100, 100, 100], 20);
  assert.deepEqual([first.shown, middle.shown, last.shown], ["100", "", "100"]);
  assert.ok(first.left + 20 < 100 - 7 && last.left > 100 + 7);
});

test("Times of the plant are rounded in texts, and names keep their ends", () => {
  assert.equal(instant(10740225793), "10.74 s");
  assert.equal(exactInstant(10740225793), "10.740225793 s");
  assert.equal(withRoundTimes("on since 10.740225793 s, 1.2345 mm, 2.00049 s."), "on since 10.74 s, 1.2345 mm, 2 s.");
  assert.equal(cutMiddle("BODY_UNDER10_CLAMP1_I_CLOSE", 40), "BODY_UNDER10_CLAMP1_I_CLOSE");
  assert.equal(cutMiddle("BODY_UNDER10_CLAMP1_I_CLOSE", 11), "BODY_…CLOSE");
});

test("Acts are words", () => {
  assert.deepEqual([{force: {A_I_X: false}}, {release: "all"}, {set: {A: 3, B: true}}, {state: {D: "OPEN"}}, {start: ["a", "b", "c", "d", "e"]}, {step: "cycle"},
    {put: {at: "BELT@300 mm", kind: "raw"}}, {speed: "max"}, {reset: true}, {other: {a: 1}}].map((act) => actText(act)),
  ["forced A_I_X off", "released all", "set A 3, B on", "put D into OPEN", "started malfunctions `a`, `b`, `c` and 2 more", "ran one cycle", "put `raw` on BELT at 300 mm",
    "set the speed to max", "reset the plant", 'other {"a":1}']);
  assert.equal(actText([{take: "BELT"}, {put: {at: "BELT", kind: "raw"}}]), "took a part from BELT, put `raw` at BELT");
  assert.equal(actText([{take: "BELT@1500.000 mm"}, {start: "eye blind"}, {stop: ["eye blind"]}]),
    "took a part from BELT at 1.5 m, started malfunction `eye blind`, stopped malfunction `eye blind`");
  const symbolNamed = (name) => ({A: {inverted: true}, B: {inverted: false}})[name] ?? null;
  assert.equal(actText([{force: {A: false}}, {set: {B: true, C: true}}], symbolNamed), "forced A on, set B on, C on");
});

test("The speed is the chosen one; the real one is added where it differs", () => {
  assert.equal(speedText({speed: 10, real_speed: 9.7}), "10 x");
  assert.equal(speedText({speed: 100, real_speed: 42.5}), "42.5 of 100 x");
  assert.equal(speedText({speed: 100, real_speed: 1}, true), "100 x");
  assert.equal(speedText({speed: "max", real_speed: 512}), "512 x");
});
