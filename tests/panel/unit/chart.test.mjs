// The changes of a row of the chart, and their export.
import assert from "node:assert/strict";
import {test} from "node:test";
import {ChartRow} from "../../../runtime/panel/page/chart_data.js";
import {writeCsv} from "../../../runtime/panel/page/chart_csv.js";
import {axesOf} from "../../../runtime/panel/page/trend_axes.js";
import {identifier, vcdName, vcdText, writeVcd} from "../../../runtime/panel/page/vcd.js";

const rowOf = (...entries) => {
  const row = new ChartRow();
  row.append(entries);
  return row;
};

test("The value at a time is that of the last change not after it", () => {
  const row = rowOf([0, false], [10, true], [20, false]);
  assert.deepEqual([-1, 0, 9, 10, 19, 20, 99].map((t) => row.at(t)), [undefined, false, false, true, true, false, false]);
});

test("Of several changes at one time the last one counts, and earlier ones are ignored", () => {
  const row = rowOf([0, 1], [5, 2], [5, 3], [4, 9]);
  assert.deepEqual([row.times, row.values], [[0, 5], [1, 3]]);
  row.append([[5, 4], [6, 5]]);
  assert.deepEqual([row.times, row.values], [[0, 5, 6], [1, 4, 5]]);
});

test("Entries of devices keep state and target", () => assert.deepEqual(rowOf([0, 1, 2]).values, [{state: 1, target: 2}]));

test("The changes before and after a time are found", () => {
  const row = rowOf([0, false], [10, true], [20, false]);
  assert.deepEqual([row.neighbor(5, 1), row.neighbor(10, 1), row.neighbor(10, -1), row.neighbor(15, -1), row.neighbor(20, 1)], [10, 20, null, 10, null]);
});

test("Pieces cover the view from the first known change to the end of the data", () => {
  const row = rowOf([0, false], [100, true], [300, false]);
  assert.deepEqual(row.pieces(50, 450, 400, 400), [[0, 50, false, false], [50, 250, true, false], [250, 350, false, false]]);
});

test("Changes closer than a pixel become one dense piece, and their number does not count", () => {
  const row = rowOf(...Array.from({length: 100000}, (_, i) => [i, i % 2 === 0]));
  const pieces = row.pieces(0, 200000, 200000, 100);
  assert.ok(pieces.length < 10, String(pieces.length));
  assert.deepEqual(pieces[0].slice(0, 2), [0, 50]);
  assert.equal(pieces[0][3], true);
  assert.deepEqual(pieces[pieces.length - 1], [50, 100, false, false].map((value, i) => i === 0 ? pieces[pieces.length - 1][0] : value));
});

test("Pieces do not overlap and have no gap", () => {
  let seed = 1;
  const random = () => (seed = seed * 16807 % 2147483647) / 2147483647;
  for (let round = 0; round < 200; ++round) {
    let t = 0;
    const row = rowOf(...Array.from({length: 60}, () => [t += random() < .5 ? 1 : Math.ceil(random() * 50), random() < .5]));
    const from = row.times[0] + random() * 100;
    const pieces = row.pieces(from, from + 400, t + 10, 60 + random() * 100);
    pieces.forEach(([begin, end], i) => {
      assert.ok(end >= begin);
      if (i > 0) assert.ok(Math.abs(begin - pieces[i - 1][1]) < 1.0001, begin + " after " + pieces[i - 1][1]);
    });
  }
});

test("Forgetting keeps the value at the time", () => {
  const row = rowOf(...Array.from({length: 5000}, (_, i) => [i * 10, i]));
  row.prune(40005);
  assert.equal(row.times[0], 40000);
  assert.equal(row.at(40005), 4000);
});

test("VCD has a variable for each row, and all changes in the order of time", () => {
  const text = writeVcd("body shop", [
    {name: "A_I_ON", type: "BOOL", times: [0, 10], values: [false, true]},
    {name: "SPEED", type: "INT", times: [0, 10], values: [-1, "9223372036854775807"]},
    {name: "TEMP", type: "REAL", times: [5], values: [1.5]},
    {name: "CLAMP", type: "state", times: [0, 10], values: ["OPEN", "OPEN->CLOSE"]}]);
  assert.equal(text, ["$timescale 1 ns $end", "$scope module body_shop $end", "$var wire 1 ! A_I_ON $end", "$var integer 64 \" SPEED $end",
    "$var real 64 # TEMP $end", "$var string 1 $ CLAMP $end", "$upscope $end", "$enddefinitions $end", "#0", "0!", "b" + "1".repeat(64) + " \"",
    "sOPEN $", "#5", "r1.5 #", "#10", "1!", "b" + "1".repeat(63) + " \"", "sOPEN->CLOSE $", ""].join("\n"));
});

test("Names and texts of VCD are printable ASCII", () => {
  assert.equal(vcdName("Tür 1"), "Tu00FCr_1");
  assert.equal(vcdText("zu früh"), "zu\\x20fr\\xC3\\xBCh");
  assert.equal(vcdText("a\\b"), "a\\x5Cb");
  assert.deepEqual([0, 93, 94, 94 * 95].map(identifier), ["!", "~", "!!", "!!!"]);
});

test("The line of a number holds until one period before the next change, and goes on to the end of the data", () => {
  const row = rowOf([0, 1], [10, 2], [50, 6]);
  assert.deepEqual(row.line(0, 100, 80, 100, 10), [[0, 1], [10, 2], [40, 2], [50, 6], [80, 6]]);
  // A change beyond the view: the line comes to it.
  assert.deepEqual(row.line(0, 45, 45, 45, 10), [[0, 1], [10, 2], [40, 2], [50, 6]]);
  assert.deepEqual(row.line(0, 30, 30, 30, 10), [[0, 1], [10, 2], [30, 2]]);
  // The change before the view is its beginning.
  assert.deepEqual(row.line(20, 30, 80, 100, 10), [[-100, 2], [100, 2]]);
  assert.deepEqual(rowOf().line(0, 100, 100, 100, 10), []);
});

test("Of many changes in a pixel the least and the greatest remain, and their number does not count", () => {
  const row = rowOf(...Array.from({length: 100000}, (_, i) => [i, i === 5004 ? -50 : i === 5007 ? 90 : i % 2]));
  const points = row.line(0, 100000, 100000, 100, 1);
  assert.ok(points.length <= 4 * 102, String(points.length));
  const inPixel = points.filter(([x]) => x === 5).map(([, number]) => number);
  assert.ok(inPixel.includes(-50) && inPixel.includes(90), String(inPixel));
});

test("The extent of a number in the view has the value at its beginning", () => {
  const row = rowOf([0, 7], [10, 2], [20, 3], [30, 99]);
  assert.deepEqual([row.extent(0, 25), row.extent(12, 25), row.extent(5, 9), rowOf().extent(0, 9)], [[2, 7], [2, 3], [7, 7], null]);
});

test("Values of one unit share an axis, and each axis shows what is in view", () => {
  const value = (rank, unit, ...entries) => ({rank, unit, symbol: null, least: null, most: null, data: rowOf(...entries)});
  const axes = axesOf([value(0, "l", [0, 10], [50, 30]), value(1, "degC", [0, 200]), value(2, "l", [0, -10], [90, 500])], {from: 0, to: 60}, 100);
  assert.deepEqual(axes.map(({unit, rows}) => [unit, rows.map(({rank}) => rank)]), [["l", [0, 2]], ["degC", [1]]]);
  assert.deepEqual([axes[0].from, axes[0].to], [-12, 32]);
  assert.ok(axes[1].from < 200 && axes[1].to > 200);
  assert.ok(axes[0].ticks.length >= 3 && axes[0].ticks.length <= 12, String(axes[0].ticks));
});

test("An axis without data is from 0 to 1", () => {
  const [axis] = axesOf([{rank: 0, unit: "", symbol: null, least: null, most: null, data: rowOf()}], {from: 0, to: 60}, 0);
  assert.ok(axis.from < 0.01 && axis.to > 0.99);
});

test("CSV has a line for each time of a change, with what all rows are then", () => {
  const text = writeCsv([
    {name: "level", unit: "l", data: rowOf([0, 20], [1e8, 20.5]), text: String},
    {name: "CLAMP", unit: "", data: rowOf([1e8, 0, 1]), text: () => "OPEN → CLOSE"}]);
  assert.equal(text, "time [s],level [l],CLAMP\n0,20,\n0.1,20.5,OPEN → CLOSE\n");
});

test("Texts of CSV are quoted, and none is computed by a spreadsheet", () => {
  const text = writeCsv([{name: "a\"b,c", unit: "", data: rowOf([0, true]), text: () => "=1+1"}, {name: "-x", unit: "", data: rowOf([0, -1]), text: String}]);
  assert.equal(text, "time [s],\"a\"\"b,c\",'-x\n0,'=1+1,-1\n");
});
