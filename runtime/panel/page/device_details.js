// The details of a device.
import {stateControl, symbolControls} from "./acts.js";
import {button, make} from "./dom.js";
import {stationAddress, symbolLink} from "./links_to.js";
import {lastFindings} from "./finding_list.js";
import {fillMalfunctions} from "./malfunction_section.js";
import {DEVICE, SYMBOL} from "./store.js";
import {operationLabel, stateText} from "./tile.js";
import {fillValuesOf} from "./value_details.js";
import {duration, isOn, value} from "./words.js";

const kActuations = {latched: "latched: a short command is enough", bistable: "bistable: moves to the end while no other command is on",
  held: "held: moves only while commanded", spring: "spring: returns to its rest state without a command"};

/// What is special about the device now, as sentences.
const conditionTexts = (store, index) => {
  const bits = store.flags[index];
  const texts = [];
  if (store.blocked[index]) texts.push("has a command and does not move");
  if (bits & DEVICE.stopped) texts.push("stopped midway");
  if (bits & DEVICE.disabled) texts.push("disabled");
  if (bits & DEVICE.frozen) texts.push("frozen in an instantaneous loop");
  if (bits & DEVICE.malfunction) texts.push("a malfunction acts on it");
  return texts.join("; ");
};

/// A symbol in a list of details: its name, address, value, marks and controls.
export const symbolItem = (pane, index, more, result) => {
  const {app} = pane;
  const {store, plant} = app;
  const symbol = plant.symbols[index];
  const marks = () => (store.symbolFlags[index] & SYMBOL.forced ? "forced" : "") + (store.symbolFlags[index] & SYMBOL.malfunction ? " malfunction" : "");
  const lamp = make("span", {class: "lamp", "aria-hidden": "true"});
  pane.attribute(lamp, "data-on", () => symbol.type === "BOOL" && isOn(symbol, store.values[index]) ? "1" : null);
  return make("li", {class: "symbol-item"},
    make("div", {class: "row"}, lamp, symbolLink(app, index), make("span", {class: "soft"}, symbol.address ?? "-"),
      pane.live(() => value(store.values[index], symbol), "strong"), pane.live(marks, "span", {class: "mark"}), more ? make("span", {class: "soft"}, more) : null),
    symbolControls(app, index, result));
};

const malfunctionNames = (plant, index, name) => [
  ...plant.malfunctions.filter(({devices}) => devices?.includes(index)).map((malfunction) => [malfunction.name, malfunction.name]),
  ...(plant.ordinary?.device ?? []).map((kind) => [name + " " + kind, kind])];

export const fillDevice = (pane, index) => {
  const {app} = pane;
  const {plant, store, clock} = app;
  const device = plant.devices[index];
  const {result} = pane;
  const station = device.station === null ? null : plant.stations[device.station].name;
  const isMove = () => store.target[index] !== store.state[index] && store.whole[index] > 0;
  pane.section("State",
    make("p", {class: "big"}, pane.live(() => stateText(store, index) || "no states")),
    make("p", {}, pane.since(() => store.since[index]), pane.live(() => isMove()
      ? ", " + duration(Math.round(store.progress(index, clock.now()).left / 1e6) * 1e6) + " of " + duration(store.whole[index]) + " left" : "")),
    pane.live(() => conditionTexts(store, index), "p", {class: "condition"}),
    make("p", {class: "soft"}, device.states.length > 0 ? ["States: ", device.states.join(", ")] : null),
    make("p", {class: "soft"}, kActuations[device.actuation] ?? device.actuation, device.rest !== null && device.rest !== undefined
      ? ", rests in " + device.states[device.rest] : ""),
    make("p", {}, station ? make("a", {href: stationAddress(station)}, "Station " + station) : null, " ",
      button("Show in chart", () => app.chart.addDevice(index), {class: "small"})),
    stateControl(app, index, result));
  fillValuesOf(pane, index);
  const list = (items) => make("ul", {class: "plain"}, items);
  if (device.operations.length > 0) {
    pane.section("Operations", list(device.operations.map((operation) => symbolItem(pane, operation.symbol,
      operation.to === null ? "" : "→ " + operationLabel(plant, device, operation), result))));
  }
  if (device.events.length > 0) {
    pane.section("Events", list(device.events.map((symbol) => symbolItem(pane, symbol, "", result))));
  }
  fillMalfunctions(pane, malfunctionNames(plant, index, device.name), result);
  pane.section("Last findings", lastFindings(pane, (of) => app.statuses.deviceOf(of) === index));
};

