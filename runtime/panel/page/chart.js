// The chart view: chosen symbols, states and values over the last minutes, as a logic analyzer and a recorder show them.
import {CursorTable} from "./chart_cursors.js";
import {bandHeight, drawAxis, drawCursors, drawRows, kAxisHeight} from "./chart_draw.js";
import {exportCsv, exportVcd} from "./chart_export.js";
import {listenToChart} from "./chart_input.js";
import {ChartLegend} from "./chart_legend.js";
import {kMostRows} from "./chart_model.js";
import {exportPng} from "./chart_png.js";
import {cursorText, describeRows} from "./chart_rows.js";
import {button, make, setAttribute, setText} from "./dom.js";
import {makeSearch} from "./search.js";
import {fitCanvas, onTheme} from "./theme.js";
import {axesOf, kMostAxes} from "./trend_axes.js";
import {drawAxes, drawTrends, kAxisWidth} from "./trend_draw.js";

const kLeastSpan = 1e4;   // ns
const kMostSpan = 86400e9;
const kFirstSpan = 20e9;
const kTrendHeight = 260;  // pixels for the curves on a narrow page, and their limits on a wide one
const kLeastHigh = 160;
const kMostHigh = 420;
const kNarrow = 560;  // pixels: without room for names next to the plot, they are in it
const kHint = "Click: cursor A, Shift + click: cursor B. Wheel: zoom. Drag: earlier and later. At most " + kMostRows + " rows.";

export class ChartView {
  constructor(app) {
    Object.assign(this, {app, title: "Chart", model: app.chart, view: {from: 0, to: kFirstSpan}, cursors: {A: null, B: null}, active: "A", scaleCount: 0,
      following: app.plant.mode === "live", dirty: true, cursorsDirty: true, drawn: 0, width: 0, high: kTrendHeight, narrow: false, shownRows: {curves: [], bands: []}});
    this.axis = make("canvas", {"aria-hidden": "true"});
    this.trends = make("canvas", {"aria-hidden": "true"});
    this.canvas = make("canvas", {"aria-hidden": "true"});
    this.scales = make("canvas", {"aria-hidden": "true"});
    this.over = make("canvas", {class: "over", "aria-hidden": "true"});
    this.plot = make("div", {class: "plot", tabindex: 0, role: "application", "aria-label": "Chart. Keys: plus, minus, arrows, a, b, c, f, y, Home"},
      this.axis, this.trends, this.canvas, this.over);
    const found = (act) => (row) => act(this.model.rows.find(({kind, index}) => kind === row.kind && index === row.index));
    this.legend = new ChartLegend(app, {moveUp: found((row) => this.model.moveUp(row)), remove: found((row) => this.model.remove(row))});
    this.cursorTable = new CursorTable();
    this.time = make("p", {class: "chart-time", role: "status"});
    this.wrong = make("p", {class: "wrong", role: "status"});
    this.followButton = button("Follow", () => this.follow(!this.following), {class: "toggle"});
    this.wholeButton = button("Whole ranges", () => this.model.showWhole(!this.model.whole),
      {class: "toggle", title: "The axes show min to max of the values that have them, else what is in view"});
    this.empty = make("p", {class: "empty"}, "Nothing is chosen. Add symbols, devices and values above, or by “Show in chart” in their details.");
    this.grid = make("div", {class: "chart-grid"}, this.legend.element, make("div", {class: "chart-scales"}, this.scales), this.plot);
    this.element = make("div", {class: "view fills chart-view"}, this.tools(), this.time, this.wrong, this.empty, this.grid, this.cursorTable.element);
    listenToChart(this.plot, this);
    const size = new ResizeObserver(() => this.resize());
    for (const element of [this.grid, this.plot]) size.observe(element);
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
      button("All", () => this.showAll(), small), this.followButton, this.wholeButton,
      button("Remove cursors", () => this.clearCursors(), small),
      button("Export VCD", () => exportVcd(this.app, this.rows()), small), button("Export CSV", () => exportCsv(this.rows()), small),
      button("Export PNG", () => exportPng(this.app, this), small));
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
    this.cursorsDirty = true;
    this.touch();
  }

  /// All rows, the curves first.
  rows() { return [...this.shownRows.curves, ...this.shownRows.bands]; }

  buildRows() {
    this.shownRows = describeRows(this.app, this.model.rows);
    this.legend.build(this.shownRows);
    this.empty.hidden = this.model.rows.length > 0;
    this.wholeButton.hidden = !this.shownRows.curves.some(({least, most}) => least !== null || most !== null);
    this.cursorsDirty = true;
    this.resize(true);
  }

  /// The curves take the height that the other rows leave.
  resize(again = false) {
    this.narrow = this.grid.clientWidth < kNarrow;
    this.grid.classList.toggle("narrow", this.narrow);
    const width = this.plot.clientWidth;
    const before = this.high;
    this.high = this.narrow ? kTrendHeight : Math.max(kLeastHigh, Math.min(kMostHigh, this.grid.clientHeight - kAxisHeight - this.bandsHeight()));
    if (width === 0 || width === this.width && this.high === before && !again) return;
    this.width = width;
    this.plot.style.height = this.height() + "px";
    this.legend.setHeight(this.trendHeight());
    this.touch();
  }

  bandsHeight() { return Math.max(this.shownRows.curves.length > 0 ? 0 : 1, this.shownRows.bands.length) * bandHeight(this.narrow); }
  trendHeight() { return this.shownRows.curves.length > 0 ? this.high : 0; }
  height() { return kAxisHeight + this.trendHeight() + this.bandsHeight(); }

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
    const {from} = this.model;
    const until = Math.max(this.model.until, this.app.store.t);  // what is not known yet comes soon
    const margin = Math.max(1e6, (until - from) / 50);
    this.setView(from, until + margin);
  }

  setCursor(name, t) {
    this.cursors[name] = Math.max(0, Math.round(t));
    this.active = name;
    this.cursorsDirty = true;
    this.touch();
  }

  clearCursors() {
    this.cursors = {A: null, B: null};
    this.cursorsDirty = true;
    this.touch();
  }

  /// To the nearest change of any row.
  stepCursor(by) {
    const t = this.cursors[this.active] ?? Math.round(this.middle());
    // Curves change all the time: they count only if there is nothing else.
    const rows = this.shownRows.bands.length > 0 ? this.shownRows.bands : this.shownRows.curves;
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

  /// Texts that depend on plant time.
  tick() { this.legend.update(); }

  axes() { return axesOf(this.shownRows.curves, this.view, this.model.until, this.model.whole, this.narrow ? kMostAxes / 2 : kMostAxes); }

  draw(now) {
    this.dirty = false;
    this.drawn = now;
    const {bands} = this.shownRows;
    const {view} = this;
    const height = this.height();
    const known = {from: this.model.from, until: this.model.until};
    const high = this.trendHeight();
    const axes = this.axes();
    drawAxes(fitCanvas(this.scales, axes.length * kAxisWidth, high), axes, high);
    if (axes.length !== this.scaleCount) {  // the plot became wider or narrower
      this.scaleCount = axes.length;
      this.width = this.plot.clientWidth;
    }
    const {width} = this;
    drawTrends(fitCanvas(this.trends, width, high), axes, view, known, width, high);
    drawAxis(fitCanvas(this.axis, width, kAxisHeight), view, width);
    drawRows(fitCanvas(this.canvas, width, height - kAxisHeight - high), bands, view, known, width, this.narrow);
    drawCursors(fitCanvas(this.over, width, height), this.cursors, now, view, width, height);
    setText(this.time, cursorText(this.cursors) || kHint);
    setAttribute(this.followButton, "aria-pressed", String(this.following));
    setAttribute(this.wholeButton, "aria-pressed", String(this.model.whole));
    if (!this.cursorsDirty) return;
    this.cursorsDirty = false;
    this.cursorTable.show(this.rows(), this.cursors, known.until);
  }
}
