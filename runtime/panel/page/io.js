// The I/O view: every symbol with its address, its value as the PLC sees it, what drives it, and force.
import {actButton, resultOutput} from "./acts.js";
import {breakable, make, select, setAttribute, setText} from "./dom.js";
import {selecting} from "./router.js";
import {filterSymbols} from "./io_filter.js";
import {SYMBOL} from "./store.js";
import {driverOrDrivenText} from "./symbol_details.js";
import {invertedMark} from "./symbol_marks.js";
import {VirtualList} from "./virtual_list.js";
import {count, cutMiddle, exactInstant, instant, isOn, levels, valueWithBit} from "./words.js";

const kHeight = 34;
const kMostLetters = 44;  // of a name: they fit into two lines
const kPause = 300;  // ms between two applications of a filter that depends on the state
const kColumns = ["Symbol", "Comment", "Address", "Type", "Direction", "Value", "Since", "Driven by", "Link"];
const columnClass = (column) => "io-" + column.toLowerCase().replace(" ", "-");  // narrow lists hide some
const kChecks = [["lately", "changed in the last 10 s"], ["forced", "forced"], ["unlinked", "on no link"], ["malfunction", "malfunction"],
  ["undriven", "no device drives it"]];

export class IoView {
  constructor(app) {
    Object.assign(this, {app, title: "I/O", last: 0, pending: false, indexes: [], rowOf: new Map()});
    this.search = make("input", {type: "search", "aria-label": "Filter by name, address or comment", placeholder: "Name, address or comment", autocomplete: "off",
      oninput: () => this.apply()});
    this.direction = select("Direction", [["", "Events and operations"], ["event", "Events"], ["operation", "Operations"]],
      {onchange: () => this.apply()});
    this.checks = kChecks.map(([key, text]) => {
      const input = make("input", {type: "checkbox", onchange: () => this.apply()});
      return {key, input, element: make("label", {class: "check"}, input, text)};
    });
    this.found = make("span", {class: "soft", role: "status"});
    this.result = resultOutput();
    this.columns = app.plant.symbols.some(({comment}) => comment) ? kColumns : kColumns.filter((column) => column !== "Comment");
    const heads = app.canAct ? [...this.columns, "Force"] : this.columns;
    this.list = new VirtualList({height: kHeight, label: "Symbols",
      head: make("div", {class: "io-row io-head", role: "row"}, heads.map((head) => make("span", {role: "columnheader", class: columnClass(head)}, head))),
      makeRow: () => this.makeRow(), fillRow: (row, at) => this.fillRow(row, at)});
    this.list.element.classList.toggle("io-acts", app.canAct);
    this.list.element.classList.toggle("io-comments", this.columns === kColumns);
    this.element = make("div", {class: "view io-view fills"},
      make("div", {class: "row tools"}, this.search, this.direction, this.checks.map(({element}) => element)),
      make("div", {class: "row result-line"}, this.found, this.result), this.list.element);
  }

  /// `filter` of a route sets one of the checks: "forced", for example.
  show({filter}) {
    if (filter && filter !== this.routed) for (const {key, input} of this.checks) input.checked = key === filter;
    this.routed = filter;
    this.apply();
  }

  filter() {
    return {text: this.search.value, direction: this.direction.value,
      ...Object.fromEntries(this.checks.map(({key, input}) => [key, input.checked]))};
  }

  depends() { return this.checks.some(({key, input}) => input.checked && key !== "unlinked" && key !== "undriven"); }

  apply() {
    this.last = performance.now();
    const indexes = filterSymbols(this.filter(), this.app.store);
    const same = indexes.length === this.indexes.length && indexes.every((index, i) => index === this.indexes[i]);
    if (!same || indexes.length === 0) {
      this.indexes = indexes;
      this.rowOf = new Map(indexes.map((index, row) => [index, row]));
      this.list.setCount(indexes.length);
    } else {
      this.list.refreshAll();
    }
    setText(this.found, indexes.length === this.app.plant.symbols.length ? count(indexes.length, "symbol")
      : indexes.length + " of " + count(this.app.plant.symbols.length, "symbol"));
  }

  makeRow() {
    const {app} = this;
    const cells = Object.fromEntries(this.columns.slice(1).map((column) => [column, make("span", {role: "cell", class: columnClass(column)})]));
    const link = make("a", {class: "name"});
    const row = {first: link, cells, forced: false};
    const symbol = () => app.plant.symbols[this.indexes[row.index]];
    const force = (label, level) => actButton(app, this.result, label, () => ({force: {[symbol().name]: levels(symbol())[level][1]}}), {class: "small", tabindex: -1});
    row.buttons = !app.canAct ? [] : [force("on", 0), force("off", 1),
      actButton(app, this.result, "release", () => ({release: [symbol().name]}), {class: "small", tabindex: -1}, () => row.forced)];
    row.more = make("a", {tabindex: -1}, "force ...");
    row.acts = app.canAct ? make("span", {role: "cell", class: "row io-force"}, row.buttons.slice(0, 2), row.more, row.buttons[2]) : null;
    row.element = make("div", {class: "io-row", role: "row"}, make("span", {role: "cell", class: "io-symbol"}, link), Object.values(cells), row.acts);
    return row;
  }

  fillRow(row, at) {
    const {store, plant} = this.app;
    const index = this.indexes[at];
    const symbol = plant.symbols[index];
    if (row.shown !== index) this.fillFixed(row, symbol);
    row.shown = index;
    const {Value: shown, Since: since} = row.cells;
    const flags = store.symbolFlags[index];
    const isForced = (flags & SYMBOL.forced) !== 0;
    setText(shown, valueWithBit(store.values[index], symbol) + (isForced ? ", forced" : "") + (flags & SYMBOL.malfunction ? ", malfunction" : ""));
    shown.classList.toggle("is-on", symbol.type === "BOOL" && isOn(symbol, store.values[index]));
    setText(since, instant(store.symbolSince[index]));
    since.title = exactInstant(store.symbolSince[index]);
    row.element.classList.toggle("forced", isForced);
    row.forced = isForced;
    row.buttons[2]?.refresh();
  }

  fillFixed(row, symbol) {
    const {Comment: comment, Address: address, Type: type, Direction: direction, "Driven by": driver, Link: link} = row.cells;
    if (comment) {
      setText(comment, symbol.comment ?? "");
      setAttribute(comment, "title", symbol.comment ?? null);
    }
    row.first.replaceChildren(make("span", {}, breakable(cutMiddle(symbol.name, kMostLetters))));
    row.first.href = selecting("symbol", symbol.name);
    row.element.title = symbol.name;
    setText(address, symbol.address ?? "-");
    type.replaceChildren(symbol.type, " ", ...[invertedMark(symbol)].filter(Boolean));
    setText(direction, symbol.direction);
    setText(driver, driverOrDrivenText(symbol));
    driver.title = driver.textContent;
    setText(link, symbol.link === null ? "-" : this.app.plant.links[symbol.link].controller || this.app.plant.links[symbol.link].name);
    row.more.hidden = symbol.type === "BOOL";
    row.more.href = selecting("symbol", symbol.name);
    row.more.setAttribute("aria-label", "Force " + symbol.name + " in its details");
    row.buttons.forEach((element, i) => {
      element.hidden = i < 2 && symbol.type !== "BOOL";
      element.setAttribute("aria-label", (i < 2 ? "Force " + levels(symbol)[i][0] : "Release") + ": " + symbol.name);
    });
  }

  change(change) {
    if (change.all || (this.depends() && (change.symbols.length > 0 || performance.now() - this.last > 1000))) this.pending = true;
    if (change.all) this.list.refreshAll();
    for (const index of change.symbols) {
      const row = this.rowOf.get(index);
      if (row !== undefined) this.list.refresh(row);
    }
    if (this.pending) this.app.frames.request();
  }

  frame() {
    if (!this.pending) return false;
    if (performance.now() - this.last < kPause) return true;
    this.pending = false;
    this.apply();
    return false;
  }
}
