// The rows and texts of the utilization view.
import assert from "node:assert/strict";
import {test} from "node:test";
import {ACTIVITIES, COLUMNS, deviceRows, lineText, locationRows, OCCUPATIONS, percent, sharesText, sorted, stationRows} from "../../../runtime/panel/page/utilization_words.js";
import {smallPlant} from "./plant.mjs";

const kNone = [0, 0, 0, 0, 0];
const answer = () => ({from: 1e9, to: 11e9,
  devices: [[[2e9, 3e9, 5e9, 0, 0, 0, 0, 0], 1e9, 4, [2, 4e9, 4.5e9, 5e9, 5e9]], [[0, 0, 0, 0, 1e10, 0, 0, 0], 0, 0, kNone]],
  locations: [[[4e9, 1e9, 5e9], true, 3, 2, 0, kNone], [[0, 0, 1e10], false, 0, 0, 0, kNone]], exits: [0, kNone]});

test("A device has its shares, which add up to the whole, its moves and its cycle", () => {
  const [clamp, door] = deviceRows(smallPlant(), answer());
  assert.deepEqual(clamp.shares, [.2, .3, .5, 0, 0, 0, 0, 0]);
  assert.equal(clamp.malfunction, .1);
  assert.deepEqual([clamp.name, clamp.moves, clamp.cycle.mean, door.cycle], ["LINE_S1_CLAMP", 4, 4.5e9, null]);
  assert.equal(sharesText(ACTIVITIES, clamp.shares), "moving 20.0 %, has a command and does not move 30.0 %, waits for a command 50.0 %");
});

test("A station has the mean of its devices and the sum of their moves; one without devices is left out", () => {
  const plant = smallPlant();
  plant.stations.push({name: "LINE S2"});
  const rows = stationRows(plant, answer());
  assert.deepEqual(rows.map(({name, devices, moves}) => [name, devices, moves]), [["LINE S1", 2, 4]]);
  assert.deepEqual(rows[0].shares, [.1, .15, .25, 0, .5, 0, 0, 0]);
});

test("A location without parts is starved if something takes parts from there, else empty", () => {
  const [belt, fixture] = locationRows(smallPlant(), answer());
  assert.deepEqual(belt.shares, [.4, .1, .5, 0]);
  assert.deepEqual(fixture.shares, [0, 0, 0, 1]);
  assert.equal(sharesText(OCCUPATIONS, belt.shares), "has parts 40.0 %, a part waits to leave 10.0 %, has no part to work on or to pass on 50.0 %");
});

test("Nothing is counted in no time", () => {
  const [row] = deviceRows(smallPlant(), {...answer(), devices: [[[0, 0, 0, 0, 0, 0, 0, 0], 0, 0, kNone], [[0, 0, 0, 0, 0, 0, 0, 0], 0, 0, kNone]]});
  assert.equal(percent(row.shares[0]), "0.0 %");
  assert.equal(sharesText(ACTIVITIES, row.shares), "nothing is counted yet");
});

test("Rows are sorted by a column; those without a value come last, and without a column the order is that of the plant", () => {
  const rows = deviceRows(smallPlant(), answer());
  const order = (key, down) => sorted(rows, COLUMNS.device, key, down).map(({index}) => index);
  assert.deepEqual(order("", false), [0, 1]);
  assert.deepEqual(order("share0", false), [1, 0]);
  assert.deepEqual(order("share0", true), [0, 1]);
  assert.deepEqual([order("cycle-mean", false), order("cycle-mean", true)], [[0, 1], [0, 1]]);
  assert.deepEqual([order("name", false), order("name", true)], [[0, 1], [1, 0]]);
});

test("The cycle time of the line is that of the parts that leave it", () => {
  assert.equal(lineText(answer(), false), "The plant has no material: its line has no cycle time.");
  assert.equal(lineText(answer(), true), "No part has left the plant.");
  assert.equal(lineText({...answer(), exits: [1, kNone]}, true), "1 part has left the plant, 360.0 an hour.");
  assert.equal(lineText({...answer(), exits: [3, [2, 4e9, 5e9, 6e9, 6e9]]}, true),
    "3 parts have left the plant, 1080.0 an hour. Cycle time of the line: 5 s (least 4 s, greatest 6 s, last 6 s).");
});
