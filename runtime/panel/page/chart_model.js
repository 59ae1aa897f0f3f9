// The chosen rows of the chart and their changes, which it asks of the plant.
import {ChartRow} from "./chart_data.js";
import {isCurve} from "./chart_rows.js";

export const kMostRows = 32;
const kKept = 600e9;   // plant time that the page keeps
const kPause = 300;    // ms between two questions
const kMostWithDevice = 8;

export class ChartModel {
  constructor(app) {
    Object.assign(this, {app, rows: [], next: null, nextValue: 0, from: 0, until: 0, wrong: "", busy: false, stale: true, last: 0});
    this.listeners = new Set();
    this.key = "symplant chart " + app.plant.plant;
    this.whole = sessionStorage.getItem(this.key + " whole") === "1";
    this.load();
  }

  listen(listener) { this.listeners.add(listener); }
  publish(what) { for (const listener of this.listeners) listener(what); }

  load() {
    let kept = [];
    try {
      kept = JSON.parse(sessionStorage.getItem(this.key) ?? "[]");
    } catch {
      kept = [];
    }
    for (const [kind, name] of kept) {
      const index = this.app.names.index(kind, name);
      if (index !== null && this.isKnown(kind, index)) this.rows.push({kind, index, data: new ChartRow()});
    }
  }

  save() {
    sessionStorage.setItem(this.key, JSON.stringify(this.rows.map(({kind, index}) => [kind, this.app.names.name(kind, index)])));
  }

  /// `whole`: the axes of numbers show `min` to `max` of the values that have them, else what is in view.
  showWhole(whole) {
    this.whole = whole;
    sessionStorage.setItem(this.key + " whole", whole ? "1" : "0");
    this.publish("axes");
  }

  /// Not a value that no trace shows.
  isKnown(kind, index) { return kind !== "value" || this.app.plant.values[index].trace !== null; }

  has(kind, index) { return this.rows.some((row) => row.kind === kind && row.index === index); }

  add(kind, index) {
    if (this.has(kind, index)) return true;
    if (!this.isKnown(kind, index)) {
      this.wrong = this.app.names.name(kind, index) + " is in no chart, since its `trace` is false";
      return false;
    }
    if (this.rows.length >= kMostRows) {
      this.wrong = "the chart has " + kMostRows + " rows, the most; remove one first";
      return false;
    }
    this.rows.push({kind, index, data: new ChartRow()});
    this.stale = true;
    this.wrong = "";
    return true;
  }

  changed(t) {
    this.save();
    this.publish("rows");
    if (t !== undefined) this.publish({show: t});
  }

  /// A device, and its symbols if they are few. Opens the chart, at the time `t` if it is given.
  addDevice(index, t) {
    const {operations, events} = this.app.plant.devices[index];
    this.add("device", index);
    const symbols = [...operations.map(({symbol}) => symbol), ...events];
    if (symbols.length <= kMostWithDevice && this.rows.length + symbols.length <= kMostRows) {
      for (const symbol of symbols) this.add("symbol", symbol);
    }
    this.app.router.view("chart");
    this.changed(t);
  }

  addSymbol(index, t) {
    this.add("symbol", index);
    this.app.router.view("chart");
    this.changed(t);
  }

  addValue(index) {
    this.add("value", index);
    this.app.router.view("chart");
    this.changed();
  }

  showTime(t) {
    this.app.router.view("chart");
    this.changed(t);
  }

  remove(row) {
    this.rows = this.rows.filter((other) => other !== row);
    this.wrong = "";
    this.next = null;
    this.stale = true;
    this.changed();
  }

  moveUp(row) {
    const at = this.rows.indexOf(row);
    const isLine = ({kind, index}) => isCurve(this.app.plant, kind, index);  // lines have their own plot
    const above = this.rows.slice(0, Math.max(0, at)).findLastIndex((other) => isLine(other) === isLine(row));
    if (above < 0) return;
    this.rows = this.rows.with(at, this.rows[above]).with(above, row);
    this.next = null;  // answers come in the order of the rows
    this.stale = true;
    this.changed();
  }

  /// The plant was set back: what is known may be of a time that has not been yet.
  restart() {
    this.stale = true;
    this.last = 0;
  }

  query() {
    const of = (kind) => this.rows.filter((row) => row.kind === kind).map(({index}) => index).join(",");
    const from = Math.max(0, Math.round(this.app.store.t - kKept));
    const range = this.stale || this.next === null ? "&from=" + (this.app.plant.mode === "recording" ? this.app.plant.begin : from) : "&after=" + this.next + "&after_value=" + this.nextValue;
    return "chart?symbols=" + of("symbol") + "&devices=" + of("device") + (of("value") ? "&values=" + of("value") : "") + range;
  }

  /// Asks for what is new, if it is time.
  async poll(wall = performance.now()) {
    if (this.busy || this.rows.length === 0 || wall - this.last < kPause) return;
    const whole = this.stale || this.next === null;
    if (!whole && (this.app.plant.mode === "recording" || this.until === this.app.store.t)) return;
    this.busy = true;
    this.last = wall;
    const rows = this.rows;
    try {
      const asked = this.query();
      this.stale = false;
      const answer = await this.app.api.get(asked);
      if (rows === this.rows && !(this.stale && !whole)) this.take(answer, whole, rows);
      this.wrong = "";
    } catch (error) {
      this.wrong = error.message;
      this.stale = this.stale || whole;
    }
    this.busy = false;
    this.publish("data");
  }

  take(answer, whole, rows) {
    if (whole) {
      this.from = answer.from;
      for (const {data} of rows) data.clear();
    }
    const fill = (kind, lists) => rows.filter((row) => row.kind === kind).forEach(({data}, i) => data.append(lists[i] ?? []));
    fill("symbol", answer.symbols ?? []);
    fill("device", answer.devices ?? []);
    fill("value", answer.values ?? []);
    this.next = answer.next;
    this.nextValue = answer.next_value ?? 0;
    this.until = answer.to;
    const oldest = answer.to - kKept;
    if (this.app.plant.mode === "recording" || oldest < this.from + 6e10) return;
    this.from = oldest;
    for (const {data} of rows) data.prune(oldest);
  }
}
