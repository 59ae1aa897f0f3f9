// The operator panel of a station: buttons and selectors that are in no device, and lamps, each with its comment.
import {resultOutput} from "./acts.js";
import {breakable, make, setAttribute, setText} from "./dom.js";
import {symbolHold, symbolSwitch} from "./operate.js";
import {isSettable} from "./person.js";
import {operates} from "./rights.js";
import {selecting} from "./router.js";
import {invertedMark} from "./symbol_marks.js";
import {isOn, value} from "./words.js";

const kMost = 200;  // the I/O view has them all

/// A button, selector or lamp: its comment or name, its state, and its controls if a person can set it.
class Entry {
  constructor(app, index, result) {
    Object.assign(this, {app, index, symbol: app.plant.symbols[index]});
    const {symbol} = this;
    this.lamp = make("span", {class: "lamp", "aria-hidden": "true"});
    this.text = make("span", {class: "soft"});
    const acts = operates(app) && symbol.type === "BOOL" && isSettable(app.plant, symbol) && symbol.direction === "event";
    this.hold = acts ? symbolHold(app, index, result, {class: "small", "aria-label": "Press " + symbol.name}) : null;
    this.change = acts ? symbolSwitch(app, index, result) : null;
    this.element = make("li", {class: "panel-entry"},
      make("div", {class: "row"}, this.lamp, make("a", {href: selecting("symbol", symbol.name), class: "name", title: symbol.name}, symbol.comment ?? breakable(symbol.name)),
        this.text, invertedMark(symbol)),
      acts ? make("div", {class: "row controls"}, this.hold, this.change.element) : null);
    this.update();
  }

  update() {
    const now = this.app.store.values[this.index];
    setText(this.text, value(now, this.symbol));
    setAttribute(this.lamp, "data-on", isOn(this.symbol, now) ? "1" : null);
    this.change?.update();
    this.hold?.refresh();
  }
}

export class OperatorPanel {
  constructor(app, symbols, label) {
    this.app = app;
    const result = resultOutput();
    this.entries = new Map(symbols.slice(0, kMost).map((index) => [index, new Entry(app, index, result)]));
    this.dirty = new Set();
    this.frame = make("section", {class: "frame operator-panel", "aria-label": label}, make("div", {class: "row"}, make("h2", {}, label), operates(app) ? result : null),
      make("ul", {class: "plain"}, [...this.entries.values()].map(({element}) => element)),
      symbols.length > kMost ? make("p", {class: "soft"}, symbols.length - kMost + " more are in the I/O view.") : null);
  }

  close() {}

  change({all, symbols}) {
    if (all) for (const index of this.entries.keys()) this.dirty.add(index);
    else for (const index of symbols) if (this.entries.has(index)) this.dirty.add(index);
  }

  /// Nothing moves on by itself.
  draw() {
    for (const index of this.dirty) this.entries.get(index).update();
    this.dirty.clear();
    return false;
  }
}
