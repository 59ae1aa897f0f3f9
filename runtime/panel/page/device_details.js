// The faceplate of a device: its state, what a person can do with it, and what it consists of.
import {stateControl} from "./acts.js";
import {contactControls} from "./contact.js";
import {button, make} from "./dom.js";
import {stationAddress, symbolLink} from "./links_to.js";
import {lastFindings} from "./finding_list.js";
import {fillMalfunctions} from "./malfunction_section.js";
import {symbolControls} from "./operate.js";
import {isContact} from "./person.js";
import {operates} from "./rights.js";
import {DEVICE, SYMBOL} from "./store.js";
import {invertedMark} from "./symbol_marks.js";
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

/// A symbol in a list of details: its name, comment, address, value, marks and controls. Without `sets` it can only be forced.
export const symbolItem = (pane, index, more = "", sets = true) => {
  const {app} = pane;
  const {store, plant} = app;
  const symbol = plant.symbols[index];
  const marks = () => (store.symbolFlags[index] & SYMBOL.forced ? "forced" : "") + (store.symbolFlags[index] & SYMBOL.malfunction ? " malfunction" : "");
  const lamp = make("span", {class: "lamp", "aria-hidden": "true"});
  pane.attribute(lamp, "data-on", () => symbol.type === "BOOL" && isOn(symbol, store.values[index]) ? "1" : null);
  return make("li", {class: "symbol-item"},
    make("div", {class: "row"}, lamp, symbolLink(app, index), make("span", {class: "soft"}, symbol.address ?? "-"),
      pane.live(() => value(store.values[index], symbol), "strong"), invertedMark(symbol), pane.live(marks, "span", {class: "mark"}),
      more ? make("span", {class: "soft"}, more) : null),
    symbol.comment ? make("div", {class: "comment"}, symbol.comment) : null,
    symbolControls(pane, index, sets));
};

const malfunctionNames = (plant, index, name) => [
  ...plant.malfunctions.filter(({devices}) => devices?.includes(index)).map((malfunction) => [malfunction.name, malfunction.name]),
  ...(plant.ordinary?.device ?? []).map((kind) => [name + " " + kind, kind])];

/// The state with its progress, and the controls of a person.
const fillState = (pane, index, contact) => {
  const {app} = pane;
  const {plant, store, clock} = app;
  const device = plant.devices[index];
  const isMove = () => store.target[index] !== store.state[index] && store.whole[index] > 0;
  const fill = make("span", {class: "fill"});
  const bar = make("span", {class: "bar", "aria-hidden": "true"}, fill);
  pane.follow(() => {
    bar.classList.toggle("shown", isMove());
    fill.style.transform = "scaleX(" + store.progress(index, clock.now()).done.toFixed(3) + ")";
  });
  const person = contact ? contactControls(app, index, pane.result) : null;
  if (person) pane.follow(person.update);
  return pane.section("State",
    make("p", {class: "big"}, pane.live(() => stateText(store, index) || "no states")), bar,
    make("p", {}, pane.since(() => store.since[index]), pane.live(() => isMove()
      ? ", " + duration(Math.round(store.progress(index, clock.now()).left / 1e6) * 1e6) + " of " + duration(store.whole[index]) + " left" : "")),
    pane.live(() => conditionTexts(store, index), "p", {class: "condition"}),
    person?.element);
};

const fillAbout = (pane, index, contact) => {
  const {app} = pane;
  const device = app.plant.devices[index];
  const station = device.station === null ? null : app.plant.stations[device.station].name;
  const rest = device.rest !== null && device.rest !== undefined ? ", rests in " + device.states[device.rest] : "";
  pane.section("About",
    make("p", {class: "soft"}, device.states.length > 0 ? ["States: ", device.states.join(", ")] : null),
    make("p", {class: "soft"}, contact ? "No operation moves it: a person sets it." : [kActuations[device.actuation] ?? device.actuation, rest]),
    make("p", {}, station ? make("a", {href: stationAddress(station)}, "Station " + station) : null, " ",
      button("Show in chart", () => app.chart.addDevice(index), {class: "small"})),
    operates(app) && !contact && device.states.length > 0 ? stateControl(app, index, pane.result) : null);
};

export const fillDevice = (pane, index) => {
  const {app} = pane;
  const {plant} = app;
  const device = plant.devices[index];
  const contact = isContact(plant, device);
  const list = (title, items) => items.length > 0 ? pane.section(title, make("ul", {class: "plain"}, items)) : null;
  const loose = app.names.looseSymbolsOf(index);
  const ofDirection = (direction) => loose.filter((symbol) => plant.symbols[symbol].direction === direction).map((symbol) => symbolItem(pane, symbol));
  const state = fillState(pane, index, contact);
  const operations = list("Operations", [...device.operations.map((operation) => symbolItem(pane, operation.symbol,
    operation.to === null ? "" : "→ " + operationLabel(plant, device, operation))), ...ofDirection("operation")]);
  const values = fillValuesOf(pane, index);
  pane.beforeWhy = values ?? operations ?? state;
  const isSwitched = contact && device.states.length === 2;  // its states are the better controls
  list("Events", [...device.events.map((symbol) => symbolItem(pane, symbol, "", !isSwitched)), ...ofDirection("event")]);
  fillMalfunctions(pane, malfunctionNames(plant, index, device.name), pane.result);
  fillAbout(pane, index, contact);
  pane.section("Last findings", lastFindings(pane, (of) => app.statuses.deviceOf(of) === index));
};
