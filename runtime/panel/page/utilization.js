// The utilization view: how much of the time stations, devices, tracks and places moved, waited or were blocked, and their cycle times.
import {actButton, resultOutput} from "./acts.js";
import {breakable, button, download, make, setAttribute, setText, table} from "./dom.js";
import {tell} from "./dialog.js";
import {stationAddress} from "./links_to.js";
import {selecting} from "./router.js";
import {ACTIVITIES, COLUMNS, deviceRows, lineText, locationRows, OCCUPATIONS, percent, sharesText, sorted, stationRows} from "./utilization_words.js";
import {VirtualList} from "./virtual_list.js";
import {count, cutMiddle, duration, instant} from "./words.js";

const kHeight = 36;
const kMostLetters = 44;  // of a name: they fit into two lines
const kPause = 2000;  // ms between two questions
const kModes = {
  station: {title: "Stations", head: "Station", kinds: ACTIVITIES, rows: stationRows},
  device: {title: "Devices", head: "Device", kinds: ACTIVITIES, rows: deviceRows},
  location: {title: "Tracks and places", head: "Track or place", kinds: OCCUPATIONS, rows: locationRows},
};

const timeText = (time) => time === 0 ? "0 s" : duration(time);

/// The table of one mode.
class UseTable {
  constructor(app, mode, details) {
    Object.assign(this, {app, mode, details, rows: [], all: [], key: "", down: false, words: []});
    this.of = kModes[mode];
    this.columns = COLUMNS[mode];
    const heads = [this.head(this.of.head, "name"), make("span", {role: "columnheader", class: "use-bar"}, "Shares"),
      ...this.columns.map(([head, key]) => this.head(head, key)), make("span", {role: "columnheader", class: "use-more"}, "Times")];
    this.heads = heads.filter(({dataset}) => dataset.key);
    this.list = new VirtualList({height: kHeight, label: this.of.title + " by utilization",
      head: make("div", {class: "use-row use-" + mode + " io-head", role: "row"}, heads), makeRow: () => this.makeRow(), fillRow: (row, at) => this.fillRow(row, this.rows[at])});
    this.element = this.list.element;
  }

  head(text, key) {
    const element = make("span", {role: "columnheader", class: "use-cell use-" + key, "data-key": key}, button(text, () => this.sort(key), {class: "sort"}));
    return element;
  }

  /// The first press of a head sorts names up and numbers down, the next one the other way, the third one not at all.
  sort(key) {
    const first = key !== "name";
    if (this.key !== key) Object.assign(this, {key, down: first});
    else if (this.down === first) this.down = !first;
    else this.key = "";
    for (const head of this.heads) setAttribute(head, "aria-sort", head.dataset.key !== this.key ? null : this.down ? "descending" : "ascending");
    this.apply();
  }

  makeRow() {
    const row = {first: make("a", {class: "name"})};
    row.pieces = this.of.kinds.map(({key}) => make("span", {class: "use-piece u-" + key}));
    row.bar = make("span", {class: "use-pieces", role: "img"}, row.pieces);
    row.numbers = this.columns.map(([, key]) => make("span", {role: "cell", class: "use-cell use-" + key}));
    row.more = button("times", () => this.details(this.rows[row.index]), {class: "small", tabindex: -1});
    row.element = make("div", {class: "use-row use-" + this.mode, role: "row"}, make("span", {role: "cell", class: "use-cell use-name"}, row.first),
      make("span", {role: "cell", class: "use-bar"}, row.bar), row.numbers, make("span", {role: "cell", class: "use-more"}, row.more));
    return row;
  }

  fillRow(row, of) {
    if (row.name !== of.name) {
      row.name = of.name;
      row.first.replaceChildren(make("span", {}, breakable(cutMiddle(of.name, kMostLetters))));
      row.first.title = of.name;
      row.first.href = of.kind === "station" ? stationAddress(of.name) : selecting(of.kind, of.name);
      setAttribute(row.more, "aria-label", "Times of " + of.name);
    }
    of.shares.forEach((share, i) => { row.pieces[i].style.width = 100 * share + "%"; });
    const text = sharesText(this.of.kinds, of.shares);
    setAttribute(row.bar, "aria-label", text);
    setAttribute(row.bar, "title", text);
    this.columns.forEach(([, , value, words], i) => {
      const number = value(of);
      setText(row.numbers[i], number === null ? "–" : words(number));
    });
  }

  set(answer) {
    this.all = this.of.rows(this.app.plant, answer);
    this.apply();
  }

  filter(text) {
    this.words = text.toLowerCase().split(/\s+/);
    this.apply();
  }

  apply() {
    const found = this.all.filter(({name}) => this.words.every((word) => name.toLowerCase().includes(word)));
    this.rows = sorted(found, this.columns, this.key, this.down);
    this.list.setCount(this.rows.length);
  }
}

export class UtilizationView {
  constructor(app) {
    Object.assign(this, {app, title: "Utilization", answer: null, asked: -Infinity, pause: kPause, isAsking: false, tables: new Map(), mode: ""});
    const modes = ["station", "device", ...(app.plant.locations.length > 0 ? ["location"] : [])];
    this.search = make("input", {type: "search", "aria-label": "Filter by name", placeholder: "Name", autocomplete: "off", oninput: () => this.table.filter(this.search.value)});
    this.modes = modes.map((mode) => button(kModes[mode].title, () => this.choose(mode), {class: "toggle", "data-mode": mode}));
    this.since = make("span", {class: "soft", role: "status"});
    this.line = make("p", {});
    this.result = resultOutput();
    this.place = make("div", {class: "use-place"});
    this.legend = make("ul", {class: "plain use-legend", "aria-label": "Colors"});
    this.element = make("div", {class: "view fills utilization-view"},
      make("div", {class: "row tools"}, make("span", {class: "row", role: "group", "aria-label": "Rows"}, this.modes), this.search,
        button("Download CSV", () => this.save()),
        app.canAct ? actButton(app, this.result, "Count again", () => ({count: "utilization"}), {title: "Forget what is counted, and begin now"}) : null),
      make("div", {class: "row result-line"}, this.since, this.result), this.line, this.place, this.legend);
    this.choose("station");
  }

  get table() { return this.tables.get(this.mode); }

  choose(mode) {
    this.mode = mode;
    if (!this.tables.has(mode)) this.tables.set(mode, new UseTable(this.app, mode, (row) => this.details(row)));
    for (const element of this.modes) setAttribute(element, "aria-pressed", String(element.dataset.mode === mode));
    this.place.replaceChildren(this.table.element);
    this.legend.replaceChildren(...kModes[mode].kinds.map(({key, text}) => make("li", {}, make("span", {class: "use-swatch u-" + key, "aria-hidden": "true"}), text)));
    this.table.filter(this.search.value);
    if (this.answer) this.table.set(this.answer);
  }

  show() { this.ask(); }

  tick() { if (performance.now() - this.asked > this.pause) this.ask(); }

  change(change) {
    if (change.all || change.jumped || change.keys.has("acts")) this.ask();
  }

  /// A plant that answers slowly is asked less often.
  async ask() {
    if (this.isAsking || this.app.lost) return;
    this.isAsking = true;
    this.asked = performance.now();
    try {
      this.answer = await this.app.api.utilization();
      this.update();
    } catch (error) {
      setText(this.since, error.message);
    }
    this.isAsking = false;
    this.pause = Math.max(kPause, 10 * (performance.now() - this.asked));
  }

  update() {
    const {from, to} = this.answer;
    setText(this.since, "counted since " + instant(from) + ": " + duration(to - from) + " of plant time");
    setText(this.line, lineText(this.answer, this.app.plant.locations.length > 0));
    this.table.set(this.answer);
  }

  async save() {
    try {
      download(await this.app.api.utilizationTable(), "utilization.csv");
    } catch (error) {
      setText(this.since, error.message);
    }
  }

  /// Everything that is counted of a row.
  async details(row) {
    const {kinds} = kModes[this.mode];
    const shares = table("Shares of the time", ["What", "Share"], kinds.map(({text}, i) => [text, percent(row.shares[i])]).filter((_, i) => row.shares[i] > 0));
    const cycle = row.cycle ? [make("p", {}, "Cycle: " + count(row.cycle.count, "time") + ", least " + duration(row.cycle.least) + ", mean " + duration(row.cycle.mean)
      + ", greatest " + duration(row.cycle.greatest) + ", last " + duration(row.cycle.last) + ".")] : [];
    if (row.kind !== "device") return tell(row.name, [shares, ...cycle]);
    try {
      const {states, moves, cycle: of} = await this.app.api.utilization(row.index);
      const heads = ["Move", "Count", "Least", "Mean", "Greatest", "Last"];
      tell(row.name, [shares, row.malfunction > 0 ? make("p", {}, "Under a malfunction: " + percent(row.malfunction)) : "",
        make("h2", {}, "In states"), table("Time in states", ["State", "Time"], Object.entries(states).map(([state, time]) => [state, timeText(time)])),
        make("h2", {}, "Moves"), moves.length > 0 ? table("Moves", heads, moves.map(({from, to, count: number, least, mean, greatest, last}) =>
          [from + " to " + to, number, ...(number > 0 ? [least, mean, greatest, last].map(timeText) : ["–", "–", "–", "–"])])) : make("p", {class: "soft"}, "none yet"),
        ...(of ? [make("h2", {}, "Cycle, from " + of.state + " to " + of.state)] : []), ...cycle]);
    } catch (error) {
      setText(this.since, error.message);
    }
  }
}
