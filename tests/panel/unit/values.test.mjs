// Values: what the page keeps of them, and how it writes them.
import assert from "node:assert/strict";
import {test} from "node:test";
import {Names} from "../../../runtime/panel/page/names.js";
import {levelOf} from "../../../runtime/panel/page/plan/motion.js";
import {Store, VALUE} from "../../../runtime/panel/page/store.js";
import {valuesText} from "../../../runtime/panel/page/tile.js";
import {formulaText, hasRange, isKnown, numberText, partOf, rangeText, shortName, sliderStep, withUnit} from "../../../runtime/panel/page/value_words.js";
import {plantWithValues, pictureWithValues, smallPicture, smallPlant} from "./plant.mjs";

const startedStore = () => {
  const store = new Store(plantWithValues());
  store.picture(pictureWithValues());
  return store;
};

test("A picture sets all values, changes only what they name, and unknown indexes are ignored", () => {
  const store = startedStore();
  let seen = null;
  store.listen((change) => { seen = change; });
  assert.deepEqual([...store.numbers], [4, 20, 40]);
  store.changes({rev: 2, t: 1e9, values: [[1, 21.5, 0], [0, 25, 1], [9, 1, 0]]});
  assert.deepEqual([...store.numbers], [25, 21.5, 40]);
  assert.deepEqual([...store.valueFlags], [VALUE.held, 0, 0]);
  assert.deepEqual(seen.values, [1, 0]);
});

test("A plant whose description has no values has none", () => {
  const store = new Store(smallPlant());
  store.picture(smallPicture());
  assert.equal(store.numbers.length, 0);
  assert.deepEqual(store.valuesOf(0), []);
});

test("A number that is not known, or not yet, is no zero", () => {
  const store = new Store(plantWithValues());
  assert.ok(store.numbers.every(Number.isNaN));
  store.picture({...pictureWithValues(), values: [[4, 0], [null, 0], [40, 0]]});
  assert.deepEqual([...store.numbers], [4, NaN, 40]);
  store.changes({rev: 2, t: 1, values: [[1, 0, 0], [2, null, 0]]});
  assert.deepEqual([...store.numbers], [4, 0, NaN]);
  assert.equal(withUnit(NaN, {unit: "l"}), "-");
  assert.equal(partOf({min: 0, max: 120}, NaN), 0);
  assert.equal(levelOf(store, [2]), null);
  assert.equal(levelOf(store, [1]), 0);
  store.changes({rev: 3, t: 2, values: [[1, null, 0]]});
  assert.equal(levelOf(store, [1]), null);
});

test("Values belong to the device whose name they begin with, and its tile shows the first three", () => {
  const store = startedStore();
  assert.deepEqual([store.valuesOf(0), store.valuesOf(1)], [[1, 2], []]);
  assert.equal(valuesText(store, 0), "load 20 l, double 40");
  assert.equal(valuesText(store, 1), "");
  const many = plantWithValues();
  many.values = Array.from({length: 5}, (_, i) => ({...many.values[1], name: "LINE_S1_CLAMP.v" + i}));
  assert.equal(valuesText(new Store(many), 0), "v0 -, v1 -, v2 -");
});

test("Values are found by name and by unit", () => {
  const names = new Names(plantWithValues());
  assert.deepEqual(names.find("wind"), {kind: "value", index: 0});
  assert.deepEqual(names.search("load", 9).map(({kind, name}) => [kind, name]), [["value", "LINE_S1_CLAMP.load"]]);
  assert.deepEqual(names.search("m/s", 9).map(({name}) => name), ["wind"]);
});

test("Numbers have about four digits, and one length for one size", () => {
  assert.deepEqual([0, 20, -3, 21.98765, 21.9, 0.5, 99.999, 123.456, 1234.56, -0.01234].map(numberText),
    ["0", "20", "-3", "21.99", "21.90", "0.5000", "100.00", "123.5", "1235", "-0.0123"]);
  assert.deepEqual([0.0001234, 12345678.9, 1e9, 1.5e-9].map(numberText), ["1.23e-4", "1.23e+7", "1e+9", "1.5e-9"]);
  assert.equal(withUnit(2.5, {unit: "m"}), "2.500 m");
  assert.equal(withUnit(2.5, {unit: ""}), "2.500");
});

test("A formula is a sentence of its kind", () => {
  assert.equal(formulaText({kind: "integral", formulas: ["2 * A.RUN"]}), "integral of 2 * A.RUN");
  assert.equal(formulaText({kind: "is", formulas: ["a + b"]}), "a + b");
  assert.equal(formulaText({kind: "ramp", formulas: ["x", "1", "2"]}), "ramp toward x, up 1 and down 2 per second");
  assert.equal(formulaText({kind: "ramp", formulas: ["x", "1"]}), "ramp toward x, up 1 per second");
  assert.equal(formulaText({kind: "pid", formulas: ["temp", "set"]}), "pid of temp to set");
  assert.equal(formulaText({kind: "parameter", formulas: []}), "");
});

test("A range has words, a bar and a slider only with both limits", () => {
  assert.deepEqual([{min: 0, max: 120, unit: "l"}, {min: 0, max: null, unit: ""}, {min: null, max: 5, unit: "m"}, {min: null, max: null, unit: "m"}].map(rangeText),
    ["0 to 120 l", "at least 0", "at most 5 m", "no limits"]);
  assert.deepEqual([hasRange({min: 0, max: 1}), hasRange({min: 0, max: null}), hasRange({min: 2, max: 2})], [true, false, false]);
  assert.deepEqual([-5, 0, 30, 120, 500].map((number) => partOf({min: 0, max: 120}, number)), [0, 0, .25, 1, 1]);
  assert.deepEqual([[0, 100], [0, 120], [0, 1], [-60, 5060], [0, 1234.5]].map(([min, max]) => sliderStep({min, max})),
    [1, 1, .01, 10, "any"]);
  const untraced = {trace: null};
  assert.deepEqual([isKnown({mode: "live"}, untraced), isKnown({mode: "recording"}, untraced), isKnown({mode: "recording"}, {trace: 5})], [true, false, true]);
});

test("The name of a value of a device is written without the device", () => {
  assert.equal(shortName({name: "LINE_S1_CLAMP.load"}, {name: "LINE_S1_CLAMP"}), "load");
  assert.equal(shortName({name: "LINE_S1_CLAMP.a.b"}, {name: "LINE_S1_CLAMP"}), "a.b");
  assert.equal(shortName({name: "LINE_S1_CLAMP.load"}, {name: "LINE_S1_CLAMP.FACET"}), "load");
});
