// The curves of the chart: their axes, styles, values at cursors and differences.
import assert from "node:assert/strict";
import {test} from "node:test";
import {ChartRow, numberOf} from "../../../runtime/panel/page/chart_data.js";
import {cursorTable, cursorText, describeRows, differenceText, valueAt, valueNow} from "../../../runtime/panel/page/chart_rows.js";
import {Names} from "../../../runtime/panel/page/names.js";
import {Store} from "../../../runtime/panel/page/store.js";
import {axesOf, axisTexts, lineStyle} from "../../../runtime/panel/page/trend_axes.js";
import {writeVcd} from "../../../runtime/panel/page/vcd.js";
import {pictureWithValues, plantWithValues} from "./plant.mjs";

const dataOf = (...entries) => {
  const row = new ChartRow();
  row.append(entries);
  return row;
};

/// A plant with values and one symbol that is a number; the rows of all kinds.
const rowsOf = () => {
  const plant = plantWithValues();
  plant.symbols.push({name: "LINE_S1_SCALE_I_WEIGHT", address: "%IW0", type: "INT", direction: "event", device: null, driver: "signal", link: null, list: "a.csv:6", inverted: false});
  const row = (kind, index, ...entries) => ({kind, index, data: dataOf(...entries)});
  const chosen = [row("symbol", 1, [0, false], [1e9, true], [2e9, false]), row("value", 1, [0, 10], [1e9, 20], [2e9, 30]), row("device", 0, [0, 0, 0], [1e9, 0, 1], [2e9, 1, 1]),
    row("symbol", 4, [0, 5], [1e9, 7])];
  return {plant, ...describeRows({plant, names: new Names(plant)}, chosen)};
};

test("Values and symbols that are numbers are curves; bits and states are rows below them", () => {
  const {curves, bands} = rowsOf();
  assert.deepEqual(curves.map(({name, unit, type, rank}) => [name, unit, type, rank]), [["LINE_S1_CLAMP.load", "l", "LREAL", 0], ["LINE_S1_SCALE_I_WEIGHT", "", "INT", 1]]);
  assert.deepEqual(bands.map(({name, type}) => [name, type]), [["LINE_S1_CLAMP_I_CLOSE", "BOOL"], ["LINE_S1_CLAMP", "state"]]);
  assert.deepEqual([curves[0].least, curves[0].most, curves[0].every], [0, 120, 1e8]);
});

test("The value at a cursor is what the line shows there: between two samples on the line, before that the earlier one", () => {
  const data = dataOf([0, 10], [1000, 20]);
  assert.deepEqual([0, 900, 950, 1000, 5000].map((t) => data.numberAt(t, 100)), [10, 10, 15, 20, 20]);
  assert.equal(data.numberAt(-1, 100), undefined);
  assert.equal(data.numberAt(999, 0), 10, "a symbol changes at once");
});

test("The values at the cursors and their differences are a table, with the times in its first row", () => {
  const {curves, bands} = rowsOf();
  const rows = [...curves, ...bands];
  assert.deepEqual(cursorTable(rows, {A: .5e9, B: 2e9}, 3e9), {heads: ["Row", "A", "B", "B − A"], rows: [
    ["Time", "0.5 s", "2 s", "1.5 s"],
    ["LINE_S1_CLAMP.load", "10 l", "30 l", "+20 l"],
    ["LINE_S1_SCALE_I_WEIGHT", "5", "7", "+2"],
    ["LINE_S1_CLAMP_I_CLOSE", "off", "off", "2 changes"],
    ["LINE_S1_CLAMP", "OPEN", "CLOSE", "2 changes"]]});
  assert.deepEqual(cursorTable(rows.slice(0, 1), {A: null, B: 1e9}, 3e9), {heads: ["Row", "B"], rows: [["Time", "1 s"], ["LINE_S1_CLAMP.load", "20 l"]]});
  assert.equal(cursorText({A: 2e9, B: .5e9}), "A 2 s, B 0.5 s, from A to B -1.5 s");
});

test("A difference is from A to B, also if B is earlier", () => {
  const {curves: [load], bands: [bit]} = rowsOf();
  assert.equal(differenceText(load, 2e9, 0, 3e9), "-20 l");
  assert.equal(differenceText(bit, 2e9, 1.5e9, 3e9), "1 change");
});

test("Where nothing is known there is no value and no difference", () => {
  const {curves: [load, weight]} = rowsOf();
  assert.deepEqual([valueAt(load, 2.5e9, 2e9), valueAt(load, -1, 2e9), differenceText(load, 0, 2.5e9, 2e9), differenceText(weight, -1, 1, 2e9)], ["-", "-", "-", "-"]);
});

test("The legend shows the present values of all kinds of rows", () => {
  const {plant, curves, bands} = rowsOf();
  const store = new Store(plant);
  const picture = pictureWithValues();
  picture.symbols.push([1234, 0, 0]);
  store.picture(picture);
  assert.deepEqual([...curves, ...bands].map((row) => valueNow(store, row)), ["20 l", "1234", "off", "OPEN"]);
});

test("Numbers that come as texts are drawn; what is not finite is a gap and does not count for the axis", () => {
  assert.deepEqual(["9007199254740993", "-inf", "inf", 3].map(numberOf), [9007199254740992, -Infinity, Infinity, 3]);
  assert.ok(Number.isNaN(numberOf("nan")));
  const data = dataOf([0, 1], [10, "nan"], [20, 5]);
  assert.deepEqual(data.extent(0, 30), [1, 5]);
  assert.deepEqual(data.line(0, 30, 30, 30, 0), [[0, 1], [10, 1], [10, NaN], [20, NaN], [20, 5], [30, 5]]);
  assert.equal(dataOf([0, "nan"], [1, "inf"]).extent(0, 9), null);
});

const curve = (name, unit, least, most, symbol, ...entries) => ({name, unit, least, most, symbol, type: symbol ? "INT" : "LREAL", data: dataOf(...entries)});

test("With whole ranges an axis is from min to max of its values, and what is in view where there is no limit", () => {
  const view = {from: 0, to: 100};
  const ends = (rows) => axesOf(rows, view, 100, true).map(({from, to}) => [from, to]);
  assert.deepEqual(ends([curve("a", "l", 0, 100, null, [0, 40], [50, 60])]), [[-5, 105]]);
  assert.deepEqual(ends([curve("a", "l", 0, null, null, [0, 40], [50, 60])]), [[-3, 63]]);
  assert.deepEqual(ends([curve("a", "l", 0, 100, null, [0, 40]), curve("b", "l", null, null, null, [0, 200])]), [[-10, 210]]);
  assert.deepEqual(axesOf([curve("a", "l", 0, 100, null, [0, 40], [50, 60])], view, 100).map(({from, to}) => [from, to]), [[39, 61]]);
});

test("Symbols have their own axes while these are few, and share one for each type if they are many", () => {
  const symbols = (count) => Array.from({length: count}, (_, i) => curve("S" + i, "", null, null, {}, [0, i]));
  const heads = (rows) => axesOf(rows, {from: 0, to: 9}, 9).map(({unit, rows: of}) => unit + " " + of.length);
  assert.deepEqual(heads([curve("a", "l", null, null, null, [0, 1]), ...symbols(3)]), ["l 1", "INT 1", "INT 1", "INT 1"]);
  assert.deepEqual(heads([curve("a", "", null, null, null, [0, 1]), ...symbols(4)]), ["- 1", "INT 4"]);
});

test("Ticks are as exact as their distance, and large and small ones have a common power of ten in the head", () => {
  const texts = (unit, from, to, ticks) => axisTexts({unit, from, to, ticks});
  assert.deepEqual(texts("l", 0, 1, [0, .2, .4]), {head: "l", texts: ["0.0", "0.2", "0.4"]});
  assert.deepEqual(texts("Pa", -1e5, 1.2e6, [0, 5e5, 1e6]), {head: "Pa ×10⁶", texts: ["0.0", "0.5", "1.0"]});
  assert.deepEqual(texts("A", 0, 2e-3, [0, 1e-3, 2e-3]), {head: "A ×10⁻³", texts: ["0", "1", "2"]});
  assert.deepEqual(texts("l", 20, 70, [20, 40, 60]), {head: "l", texts: ["20", "40", "60"]});
});

test("Neighboring lines differ in color and dashes, and all 32 are different", () => {
  const styles = Array.from({length: 32}, (_, rank) => lineStyle(rank));
  assert.equal(new Set(styles.map((style) => JSON.stringify(style))).size, 32);
  styles.slice(1).forEach(({color, dash}, i) => {
    assert.notEqual(color, styles[i].color);
    assert.notDeepEqual(dash, styles[i].dash);
  });
});

test("VCD says the unit of a value in a comment", () => {
  const text = writeVcd("p", [{name: "level", unit: "m³", type: "LREAL", times: [0], values: [1]}, {name: "A", unit: "", type: "BOOL", times: [0], values: [true]}]);
  assert.match(text, /^\$comment level is in m\\xC2\\xB3 \$end$/m);
  assert.equal(text.match(/\$comment/g).length, 1);
});
