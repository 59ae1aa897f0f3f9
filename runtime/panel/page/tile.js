// A device as a tile: its state, the progress of its move, its commands and events, and what hinders it.
import {deviceTitle, symbolsOf} from "./comments.js";
import {make, setText, setAttribute} from "./dom.js";
import {isContact} from "./person.js";
import {operates} from "./rights.js";
import {selecting} from "./router.js";
import {rank, STATUSES} from "./status.js";
import {DEVICE, SYMBOL} from "./store.js";
import {invertedMarkOf} from "./symbol_marks.js";
import {TileActs} from "./tile_acts.js";
import {isKnown, shortName, withUnit} from "./value_words.js";
import {isOn, value} from "./words.js";

const kMostEvents = 10;
const kMostValues = 3;
const kMalfunction = STATUSES[rank.malfunction];

/// "CLOSE" for an operation that commands the state CLOSE, else the last level of its symbol.
export const operationLabel = (plant, device, {symbol, to}) =>
  to !== null ? device.states[to] : plant.symbols[symbol].name.split(/[_.]/).pop();

/// "P1", or "P1 → P2" during a move.
export const stateText = (store, index) => {
  const {states} = store.plant.devices[index];
  if (states.length === 0) return "";
  const state = states[store.state[index]] ?? "?";
  const isMove = store.target[index] !== store.state[index] && store.target[index] >= 0;
  return isMove ? state + " → " + (states[store.target[index]] ?? "?") : state;
};

/// The operations that are on: "▸CLOSE", of a number "SPEED=5".
export const commandsText = (store, device) => {
  const {plant, values} = store;
  const texts = [];
  for (const operation of device.operations) {
    const symbol = plant.symbols[operation.symbol];
    const now = values[operation.symbol];
    if (!isOn(symbol, now)) continue;
    const label = operationLabel(plant, device, operation);
    texts.push(typeof now !== "boolean" ? label + "=" + value(now, symbol) : "▸" + label);
  }
  return texts.join(" ");
};

/// The events that are on and off: "■□".
export const eventsText = (store, device) => {
  let text = "";
  for (const index of device.events.slice(0, kMostEvents)) {
    const symbol = store.plant.symbols[index];
    if (symbol.type === "BOOL") text += isOn(symbol, store.values[index]) ? "■" : "□";
  }
  return text;
};

/// The first values of the device: "load 20.4 l".
export const valuesText = (store, index) => store.valuesOf(index).filter((at) => isKnown(store.plant, store.plant.values[at])).slice(0, kMostValues).map((at) =>
  shortName(store.plant.values[at], store.plant.devices[index]) + " " + withUnit(store.numbers[at], store.plant.values[at])).join(", ");

const isForced = (store, device) => device.events.some((symbol) => store.symbolFlags[symbol] & SYMBOL.forced)
  || device.operations.some(({symbol}) => store.symbolFlags[symbol] & SYMBOL.forced);

export class Tile {
  constructor(app, index) {
    Object.assign(this, {app, index, device: app.plant.devices[index], status: -1});
    this.letter = make("span", {class: "letter", "aria-hidden": "true"});
    this.broken = make("span", {class: "letter s-malfunction", "aria-hidden": "true", title: kMalfunction.text, hidden: true}, kMalfunction.letter);
    this.word = make("span", {class: "hidden-text"});
    this.state = make("span", {class: "state"});
    this.values = make("span", {class: "numbers"});
    this.forced = make("span", {class: "forced-mark", hidden: true, title: "a symbol is forced"}, "F");
    this.fill = make("span", {class: "fill"});
    this.bar = make("span", {class: "bar", "aria-hidden": "true"}, this.fill);
    this.commands = make("span", {class: "commands"});
    this.events = make("span", {class: "events", "aria-hidden": "true"});
    const comment = app.names.commentOf(this.device);
    this.element = make("a", {class: "tile", href: selecting("device", this.device.name), title: deviceTitle(app.plant, this.device), tabindex: -1,
      "data-device": this.device.name},
      make("span", {class: "top"}, make("span", {class: "label"}, this.device.label), this.forced, this.broken, this.letter, this.word),
      comment ? make("span", {class: "comment cut"}, comment) : null,
      make("span", {class: "state-line"}, this.state, this.values), this.bar, make("span", {class: "low"}, this.commands,
        make("span", {class: "inputs"}, invertedMarkOf(this.bits()), this.events)));
    this.acts = operates(app) && isContact(app.plant, this.device) ? new TileActs(app, index, this.element) : null;
    /// What is in the grid: the tile, with its buttons if it has any.
    this.box = this.acts ? this.acts.element : this.element;
    this.update();
  }

  /// The BOOL symbols of the device, with the last levels of their names.
  bits() {
    return symbolsOf(this.device).map((index) => this.app.plant.symbols[index]).filter(({type}) => type === "BOOL")
      .map((symbol) => [symbol.name.split(/[_.]/).slice(-2).join("_"), symbol]);
  }

  /// After a change of the device or one of its symbols.
  update() {
    const {store, statuses} = this.app;
    const status = statuses.of[this.index];
    const {key, letter, text} = STATUSES[status];
    // A finding is the more urgent status, and often the effect of a malfunction: both are shown.
    const isBroken = status !== rank.malfunction && (store.flags[this.index] & DEVICE.malfunction) !== 0;
    if (status !== this.status) {
      this.status = status;
      this.element.className = "tile s-" + key;
      setText(this.letter, letter);
      this.letter.title = text;
    }
    this.broken.hidden = !isBroken;
    setText(this.word, ", " + text + ", " + (isBroken ? kMalfunction.text + ", " : ""));
    setText(this.state, stateText(store, this.index));
    this.updateValues();
    setText(this.commands, commandsText(store, this.device));
    setText(this.events, eventsText(store, this.device));
    this.forced.hidden = !isForced(store, this.device);
    this.moving = store.moves(this.index);
    const isMove = store.target[this.index] !== store.state[this.index];
    this.bar.classList.toggle("shown", isMove && store.whole[this.index] > 0);
    this.acts?.update();
    this.draw(this.app.clock.now());
  }

  /// After a change of one of the device's values.
  updateValues() {
    const text = valuesText(this.app.store, this.index);
    setText(this.values, text);
    setAttribute(this.values, "title", text || null);
  }

  /// 0: Tab stops at the tile and its buttons; -1: it does not.
  setTab(tabIndex) {
    this.element.tabIndex = tabIndex;
    this.acts?.setTab(tabIndex);
  }

  select(selected) { setAttribute(this.element, "aria-current", selected ? "true" : null); }

  /// Draws the progress at plant time `now`; returns whether it goes on.
  draw(now) {
    const {done, left} = this.app.store.progress(this.index, now);
    if (done !== this.done) this.fill.style.transform = "scaleX(" + done.toFixed(4) + ")";
    this.done = done;
    return this.moving && left > 0;
  }
}
