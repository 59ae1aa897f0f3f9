// The rows and texts of the utilization view, from an answer of the server. Without elements.
import {duration} from "./words.js";

/// What a device does, in the order of the answer. `shown`: it has a column.
export const ACTIVITIES = [
  {key: "moving", text: "moving"}, {key: "blocked", text: "has a command and does not move"}, {key: "waiting", text: "waits for a command"},
  {key: "commanded", text: "in its commanded state"}, {key: "rest", text: "at rest; no operation moves it"}, {key: "disabled", text: "disabled"},
  {key: "stopped", text: "stopped midway"}, {key: "frozen", text: "frozen in a loop"},
];
/// What a track or place is.
export const OCCUPATIONS = [
  {key: "used", text: "has parts"}, {key: "blocked", text: "a part waits to leave"}, {key: "starved", text: "has no part to work on or to pass on"},
  {key: "empty", text: "has no part; nothing takes parts from there"},
];

export const percent = (share) => (100 * share).toFixed(1) + " %";

const sum = (numbers) => numbers.reduce((all, number) => all + number, 0);
/// The time of a cycle, or nothing without one.
const cycleOf = ([count, least, mean, greatest, last]) => count === 0 ? null : {count, least, mean, greatest, last};
const sharesOf = (times) => {
  const whole = sum(times);
  return times.map((time) => whole === 0 ? 0 : time / whole);
};

/// A row for each device.
export const deviceRows = (plant, answer) => answer.devices.map(([times, malfunction, moves, cycle], index) => ({
  kind: "device", index, name: plant.devices[index].name, shares: sharesOf(times), malfunction: malfunction / Math.max(1, sum(times)), moves, cycle: cycleOf(cycle)}));

/// A row for each station: the mean of its devices.
export const stationRows = (plant, answer) => plant.stations.map(({name}, index) => {
  const of = answer.devices.filter((_, device) => plant.devices[device].station === index);
  return {kind: "station", index, name, devices: of.length, shares: sharesOf(ACTIVITIES.map((_, i) => sum(of.map(([times]) => times[i])))),
    moves: sum(of.map(([, , moves]) => moves)), cycle: null};
}).filter(({devices}) => devices > 0);

/// A row for each track and place.
export const locationRows = (plant, answer) => answer.locations.map(([[used, blocked, empty], starves, came, left, out, cycle], index) => ({
  kind: "location", index, name: plant.locations[index].name, shares: sharesOf([used, blocked, starves ? empty : 0, starves ? 0 : empty]), came, left, out,
  cycle: cycleOf(cycle)}));

/// The columns of numbers: [head, key, value of a row or null, its text].
const share = (head, i) => [head, "share" + i, ({shares}) => shares[i], percent];
const number = (head, key) => [head, key, (row) => row[key], String];
const cycle = (head, key) => [head, "cycle-" + key, (row) => row.cycle ? row.cycle[key] : null, duration];
const kOfDevices = [share("Moving", 0), share("Blocked", 1), share("Waiting", 2), number("Moves", "moves")];
export const COLUMNS = {
  station: [number("Devices", "devices"), ...kOfDevices],
  device: [...kOfDevices, cycle("Cycle", "mean"), cycle("Last", "last")],
  location: [share("Used", 0), share("Blocked", 1), share("Starved", 2), number("Came", "came"), number("Left", "left"), cycle("Cycle", "mean")],
};

/// Rows in the order of a column: by its key, or `name`; without one in the order of the plant. Rows without a value come last.
export const sorted = (rows, columns, key, down) => {
  if (key === "") return rows;
  const value = key === "name" ? ({name}) => name : columns.find(([, of]) => of === key)[2];
  const compare = (a, b) => key === "name" ? a.localeCompare(b, undefined, {numeric: true}) : a - b;
  return [...rows].sort((a, b) => {
    const [x, y] = [value(a), value(b)];
    if (x === null || y === null) return (x === null) - (y === null);
    return down ? compare(y, x) : compare(x, y);
  });
};

/// What a bar shows, for those who do not see it: "moving 12.0 %, waits for a command 88.0 %".
export const sharesText = (kinds, shares) => kinds.map(({text}, i) => [text, shares[i]]).filter(([, of]) => of > 0)
  .map(([text, of]) => text + " " + percent(of)).join(", ") || "nothing is counted yet";

/// The cycle time of the line: of the parts that leave the plant.
export const lineText = ({from, to, exits: [parts, times]}, hasMaterial) => {
  if (!hasMaterial) return "The plant has no material: its line has no cycle time.";
  const of = cycleOf(times);
  const left = parts === 0 ? "No part has left the plant." : parts + (parts === 1 ? " part has" : " parts have") + " left the plant";
  if (parts === 0) return left;
  const perHour = ", " + (parts / (Math.max(1, to - from) / 3.6e12)).toFixed(1) + " an hour.";
  return left + perHour + (of ? " Cycle time of the line: " + duration(of.mean) + " (least " + duration(of.least) + ", greatest " + duration(of.greatest)
    + ", last " + duration(of.last) + ")." : "");
};
