// The chart view: chosen symbols, states and values over the last minutes, as a logic analyzer and a recorder show them.
import {cursorText, drawAxis, drawCursors, drawRows, kAxisHeight, kRowHeight, valueAt} from "./chart_draw.js";
import {exportCsv, exportPng, exportVcd} from "./chart_export.js";
import {listenToChart} from "./chart_input.js";
import {kMostRows} from "./chart_model.js";
import {button, make, setAttribute, setText} from "./dom.js";
import {linkTo} from "./links_to.js";
import {makeSearch} from "./search.js";
import {fitCanvas, onTheme} from "./theme.js";
import {axesOf, kColors} from "./trend_axes.js";
import {drawAxes, drawTrends, kAxisWidth, kTrendHeight} from "./trend_draw.js";

const kLeastSpan = 1e4;   // ns
const kMostSpan = 86400e9;
const kFirstSpan = 20e9;

export class ChartView {
  constructor(app) {
    Object.assign(this, {app, title: "Chart", model: app.chart, view: {from: 0, to: kFirstSpan}, cursors: {A: null, B: null}, active: "A", scaleCount: 0,
      following: app.plant.mode === "live", dirty: true, drawn: 0, width: 0, labels: []});
    this.axis = make("canvas", {"aria-hidden": "true"});
    this.trends = make("canvas", {"aria-hidden": "true"});
    this.canvas = make("canvas", {"aria-hidden": "true"});
    this.scales = make("canvas", {"aria-hidden": "true"});
    this.over = make("canvas", {class: "over", "aria-hidden": "true"});
    this.plot = make("div", {class: "plot", tabindex: 0, role: "application", "aria-label": "Chart. Keys: plus, minus, arrows, a, b, c, f, Home"},
      this.axis, this.trends, this.canvas, this.over);
    this.names = make("ul", {class: "chart-names"});
    this.time = make("p", {class: "chart-time", role: "status"});
    this.wrong = make("p", {class: "wrong", role: "status"});
    this.followButton = button("Follow", () => this.follow(!this.following), {class: "toggle"});
    this.empty = make("p", {class: "empty"}, "Nothing is chosen. Add symbols, devices and values above, or by “Show in chart” in their details.");
    this.element = make("div", {class: "view fills chart-view"}, this.tools(), this.time, this.wrong, this.empty,
      make("div", {class: "chart-grid"}, this.names, make("div", {class: "chart-scales"}, this.scales), this.plot));
    listenToChart(this.plot, this);
    new ResizeObserver(() => this.resize()).observe(this.plot);
    onTheme(() => this.touch());
    this.model.listen((what) => this.modelChanged(what));
  }

  tools() {
    const small = {class: "small"};
    return make("div", {class: "row tools"},
      makeSearch(this.app, {label: this.app.plant.values.length > 0 ? "Add a symbol, device or value" : "Add a symbol or device",
        accepts: (kind, index) => kind === "device" || kind === "symbol" || kind === "value" && this.model.isKnown(kind, index),
        choose: ({kind, name}) => {
          this.model.add(kind, this.app.names.index(kind, name));
          this.model.changed();
        }}),
      button("Zoom in", () => this.zoom(1 / 1.5, this.middle()), small), button("Zoom out", () => this.zoom(1.5, this.middle()), small),
      button("All", () => this.showAll(), small), this.followButton,
      button("Remove cursors", () => this.clearCursors(), small),
      button("Export VCD", () => exportVcd(this.app, this.rows()), small), button("Export CSV", () => exportCsv(this.rows()), small), button("Export PNG", () => exportPng(this.app, this), small));
  }

  middle() { return (this.view.from + this.view.to) / 2; }

  show() {
    this.buildRows();
    this.touch();
  }

  modelChanged(what) {
    if (what === "rows") this.buildRows();
    if (what?.show !== undefined) {
      const half = Math.min(this.view.to - this.view.from, kFirstSpan) / 2;
      this.setView(what.show - half, what.show + half);
      this.setCursor("A", what.show);
    }
    setText(this.wrong, this.model.wrong);
    this.touch();
  }

  /// The values first, in one plot; then the others, one below the other.
  rows() {
    const {plant} = this.app;
    const isValue = ({kind}) => kind === "value";
    const values = this.model.rows.filter(isValue).map((row, rank) => ({...row, name: this.app.names.name("value", row.index), type: "LREAL", rank,
      value: plant.values[row.index]}));
    return [...values, ...this.model.rows.filter((row) => !isValue(row)).map((row) => ({...row, name: this.app.names.name(row.kind, row.index),
      device: plant.devices[row.index], symbol: plant.symbols[row.index], type: row.kind === "symbol" ? plant.symbols[row.index].type : "state"}))];
  }

  values() { return this.rows().filter(({kind}) => kind === "value"); }
  others() { return this.rows().filter(({kind}) => kind !== "value"); }

  buildRows() {
    this.labels = [];
    this.names.replaceChildren(make("li", {class: "chart-head"}, make("span", {class: "grow"}, "Name"), make("span", {}, "A"), make("span", {}, "B")),
      ...this.valueLabels(), ...this.model.rows.filter(({kind}) => kind !== "value").map((row) => this.label(row)));
    this.empty.hidden = this.model.rows.length > 0;
    this.resize(true);
  }

  /// The names of the values as one entry, next to their plot.
  valueLabels() {
    const rows = this.model.rows.filter(({kind}) => kind === "value");
    if (rows.length === 0) return [];
    return [make("li", {class: "chart-values"}, make("ul", {}, rows.map((row, rank) => {
      const label = this.label(row);
      label.firstChild.prepend(make("span", {class: "swatch trend" + rank % kColors + " dash" + Math.floor(rank / kColors) % 4, "aria-hidden": "true"}));
      return label;
    })))];
  }

  label(row) {
    const name = this.app.names.name(row.kind, row.index);
    const link = linkTo(row.kind, name, this.twoLines(row, name));
    link.title = name;
    const values = [make("span", {class: "at-cursor"}), make("span", {class: "at-cursor"})];
    const up = button("↑", () => this.model.moveUp(row), {class: "tiny", "aria-label": "Move up " + name, title: "Move up"});
    this.labels.push(values);
    return make("li", {}, make("span", {class: "grow"}, link), values, make("span", {class: "row-buttons"}, up, button("✕", () => this.model.remove(row), {class: "tiny", "aria-label": "Remove " + name, title: "Remove"})));
  }

  /// What rows have in common is small, what differs is large.
  twoLines({kind, index}, name) {
    if (kind === "value") return [make("span", {class: "cut"}, name)];
    const {plant} = this.app;
    const device = kind === "device" ? plant.devices[index] : plant.devices[plant.symbols[index].device];
    const head = kind === "device" ? name.slice(0, -device.label.length) : device && name.startsWith(device.name + "_") ? device.name + "_" : "";
    return name.endsWith(name.slice(head.length)) && head !== "" ? [make("span", {class: "soft cut"}, head), make("span", {class: "cut"}, name.slice(head.length))]
      : [make("span", {class: "cut"}, name)];
  }

  resize(again = false) {
    const width = this.plot.clientWidth;
    if (width === 0 || (width === this.width && !again)) return;
    this.width = width;
    this.plot.style.height = this.height() + "px";
    this.touch();
  }

  trendHeight() { return this.model.rows.some(({kind}) => kind === "value") ? kTrendHeight : 0; }
  height() { return kAxisHeight + this.trendHeight() + Math.max(this.trendHeight() > 0 ? 0 : 1, this.others().length) * kRowHeight; }

  touch() {
    this.dirty = true;
    this.app.frames.request();
  }

  setView(from, to) {
    const span = Math.max(kLeastSpan, Math.min(kMostSpan, to - from));
    this.view = {from, to: from + span};
    this.following = false;
    this.touch();
  }

  zoom(factor, at) {
    const {from, to} = this.view;
    const span = Math.max(kLeastSpan, Math.min(kMostSpan, (to - from) * factor));
    if (this.following) {
      this.view.from = to - span;
      return this.touch();
    }
    const part = (at - from) / (to - from);
    this.setView(at - part * span, at + (1 - part) * span);
  }

  pan(part) {
    const by = (this.view.to - this.view.from) * part;
    this.setView(this.view.from + by, this.view.to + by);
  }

  follow(on) {
    this.following = on;
    this.touch();
  }

  showAll() {
    const {from, until} = this.model;
    const margin = Math.max(1e6, (until - from) / 50);
    this.setView(from, until + margin);
  }

  setCursor(name, t) {
    this.cursors[name] = Math.max(0, Math.round(t));
    this.active = name;
    this.touch();
  }

  clearCursors() {
    this.cursors = {A: null, B: null};
    this.touch();
  }

  /// To the nearest change of any row.
  stepCursor(by) {
    const t = this.cursors[this.active] ?? Math.round(this.middle());
    // Values change all the time: they count only if there is nothing else.
    const rows = this.others().length > 0 ? this.others() : this.model.rows;
    const found = rows.map(({data}) => data.neighbor(t, by)).filter((time) => time !== null);
    if (found.length === 0) return;
    const next = by > 0 ? Math.min(...found) : Math.max(...found);
    const {from, to} = this.view;
    if (next < from || next > to) this.setView(next - (to - from) / 2, next + (to - from) / 2);
    this.setCursor(this.active, next);
  }

  change(change) {
    if (change.jumped) this.model.restart();
    if (change.keys.has("clock") || change.all) this.touch();
  }

  frame(now) {
    this.model.poll();
    const runs = this.app.clock.runs;
    if (this.following) {
      const span = this.view.to - this.view.from;
      const to = Math.max(now, span * .98) + span * .02;
      if (to !== this.view.to) this.dirty = true;
      this.view = {from: to - span, to};
    }
    if (now !== this.drawn && now >= this.view.from && this.drawn <= this.view.to) this.dirty = true;
    if (this.dirty && this.width > 0) this.draw(now);
    return runs || this.model.stale && this.model.rows.length > 0;
  }

  draw(now) {
    this.dirty = false;
    this.drawn = now;
    const height = this.height();
    const rows = this.rows();
    const known = {from: this.model.from, until: this.model.until};
    const high = this.trendHeight();
    const axes = axesOf(this.values(), this.view, known.until);
    drawAxes(fitCanvas(this.scales, axes.length * kAxisWidth, high), axes, high);
    if (axes.length !== this.scaleCount) {  // the plot became wider or narrower
      this.scaleCount = axes.length;
      this.width = this.plot.clientWidth;
    }
    drawTrends(fitCanvas(this.trends, this.width, high), axes, this.view, known, this.width, high);
    drawAxis(fitCanvas(this.axis, this.width, kAxisHeight), this.view, this.width);
    drawRows(fitCanvas(this.canvas, this.width, height - kAxisHeight - high), this.others(), this.view, known, this.width);
    drawCursors(fitCanvas(this.over, this.width, height), this.cursors, now, this.view, this.width, height);
    setText(this.time, cursorText(this.cursors) || "Click: cursor A, Shift + click: cursor B. Wheel: zoom. Drag: earlier and later. At most " + kMostRows + " rows.");
    this.names.classList.toggle("one-cursor", this.cursors.B === null);
    setAttribute(this.followButton, "aria-pressed", String(this.following));
    rows.forEach((row, i) => {
      if (!this.labels[i]) return;
      const texts = [valueAt(row, this.cursors.A ?? now), this.cursors.B === null ? "" : valueAt(row, this.cursors.B)];
      texts.forEach((text, k) => {
        setText(this.labels[i][k], text);
        setAttribute(this.labels[i][k], "title", text || null);  // a narrow column cuts it
      });
    });
  }
}
