// The alarms view: the list with its filters, and what is shelved.
import {actButton, actingButton, perform, resultOutput} from "./acts.js";
import {isUnacknowledged} from "./alarm_state.js";
import {alarmText, priorityChoices, priorityText, stateChoices, stateMark, stationText, timesText} from "./alarm_words.js";
import {tell} from "./dialog.js";
import {button, make, select, setAttribute, setText, table} from "./dom.js";
import {nameLink} from "./links_to.js";
import {operates} from "./rights.js";
import {selecting} from "./router.js";
import {VirtualList} from "./virtual_list.js";
import {clockText, count, exactInstant} from "./words.js";

const kHeight = 68;
const kNarrow = 640;        // px of the list; below it a row has more lines
const kNarrowHeight = 134;
const kMostNames = 100;     // of one act
const kMostShelved = 100;   // that are shown
const kColumns = ["State", "Priority", "Since", "Station", "Alarm", "Count"];
const kTimes = [["1min", "1 min"], ["10min", "10 min"], ["1h", "1 h"], ["8h", "8 h"], ["24h", "24 h"]];

export class AlarmsView {
  constructor(app) {
    Object.assign(this, {app, title: "Alarms", shown: []});
    const apply = {onchange: () => this.apply()};
    this.state = select("State", stateChoices, apply);
    this.priority = select("Priority", priorityChoices, apply);
    this.station = select("Station", [["", "All stations"], ...app.plant.stations.map(({name}, index) => [String(index), name || "-"]), ["none", "No station"]], apply);
    this.time = select("Shelve for", kTimes, {title: "Plant time for which Shelve takes an alarm out of the list", onchange: () => this.list.refreshAll()});
    this.time.value = "10min";
    this.found = make("span", {class: "soft", role: "status"});
    this.result = resultOutput();
    this.all = operates(app) ? actingButton(app, "Acknowledge all shown", () => this.acknowledgeShown(), {}, () => this.shown.some(isUnacknowledged)) : null;
    this.list = this.makeList();
    this.shelved = make("div", {});
    this.shelvedCount = make("span", {class: "soft"});
    this.element = make("div", {class: "view alarms-view fills"},
      make("div", {class: "row tools"}, this.state, this.priority, this.station, this.all,
        operates(app) ? make("label", {class: "check"}, "Shelve for", this.time) : null),
      make("div", {class: "row result-line"}, this.found, this.result), this.list.element,
      make("section", {"aria-label": "Shelved alarms", class: "alarms-shelved"}, make("h2", {}, "Shelved ", this.shelvedCount), this.shelved));
  }

  makeList() {
    const heads = operates(this.app) ? [...kColumns, "Acts"] : kColumns;
    const list = new VirtualList({height: kHeight, label: "Alarms, the most urgent first",
      head: make("div", {class: "alarm-row io-head", role: "row"}, heads.map((head) => make("span", {role: "columnheader", class: "alarm-" + head.toLowerCase()}, head))),
      makeRow: () => this.makeRow(), fillRow: (row, at) => this.fillRow(row, at)});
    list.element.classList.toggle("alarm-acts-on", operates(this.app));
    new ResizeObserver(() => this.fit()).observe(list.element);
    return list;
  }

  /// In a narrow window a row has more lines.
  fit() {
    for (const row of this.list.rows.values()) this.offerMore(row);
    const isNarrow = this.list.element.clientWidth < kNarrow;
    this.list.element.classList.toggle("narrow", isNarrow);
    const height = isNarrow ? kNarrowHeight : kHeight;
    if (height === this.list.height) return;
    this.list.height = height;
    this.list.setCount(this.shown.length);
    for (const [index, {element}] of this.list.rows) element.style.transform = "translateY(" + index * height + "px)";
  }

  makeRow() {
    const {app, result} = this;
    const row = {state: stateMark(), priority: make("span", {class: "alarm-priority", role: "cell"}), since: make("span", {class: "alarm-since number", role: "cell"}),
      station: make("span", {class: "alarm-station", role: "cell"}), text: make("span", {class: "alarm-words"}), first: make("a", {class: "name"}),
      count: make("span", {class: "alarm-count-cell number", role: "cell"})};
    row.acknowledge = operates(app) ? actButton(app, result, "Acknowledge", () => ({acknowledge: row.alarm.name}), {class: "small"}, () => Boolean(row.alarm && isUnacknowledged(row.alarm))) : null;
    row.shelve = operates(app) ? actButton(app, result, "Shelve", () => ({shelve: row.alarm.name, for: this.time.value}), {class: "small"}) : null;
    row.more = button("More", () => tell("Alarm of " + row.alarm.of, [make("p", {}, alarmText(row.alarm))]), {class: "tiny", hidden: true});
    row.element = make("div", {class: "alarm-row", role: "row"}, make("span", {class: "alarm-state-cell", role: "cell"}, row.state.element), row.priority, row.since, row.station,
      make("span", {class: "alarm-alarm", role: "cell"}, row.text, make("span", {class: "row alarm-subject"}, row.first, row.more)), row.count,
      operates(app) ? make("span", {class: "row alarm-acts", role: "cell"}, row.acknowledge, row.shelve) : null);
    return row;
  }

  fillRow(row, at) {
    const {app} = this;
    const alarm = this.shown[at];
    row.alarm = alarm;
    row.state.update(alarm.state);
    row.element.dataset.priority = alarm.priority;
    row.element.dataset.alarm = alarm.name;
    setText(row.priority, priorityText(alarm.priority));
    setText(row.since, timesText(alarm));
    row.since.title = "came at " + exactInstant(alarm.came) + (alarm.went === null ? "" : ", went at " + exactInstant(alarm.went));
    setText(row.station, stationText(app.plant, alarm));
    const isName = alarm.text === alarm.of;
    setText(row.text, isName ? "" : alarmText(alarm));
    row.text.title = alarm.text;
    setText(row.first, alarm.of);
    const found = app.names.find(alarm.of);
    setAttribute(row.first, "href", found ? selecting(found.kind, alarm.of) : "#view=findings");
    setText(row.count, alarm.count + " x");
    setAttribute(row.more, "aria-label", "More of the alarm of " + alarm.of);
    this.offerMore(row);
    if (!operates(app)) return;
    setAttribute(row.acknowledge, "aria-label", "Acknowledge " + alarm.name);
    row.acknowledge.refresh();
    setAttribute(row.shelve, "aria-label", "Shelve " + alarm.name + " for " + kTimes.find(([value]) => value === this.time.value)[1]);
  }

  /// A button for the whole text, if a row does not show it.
  offerMore({text, more}) { more.hidden = text.scrollHeight <= text.clientHeight; }

  show() { this.apply(); }

  apply() {
    const {alarms} = this.app.store;
    this.shown = alarms.filtered({state: this.state.value, priority: this.priority.value, station: this.station.value});
    const shelved = alarms.shelved();
    const all = alarms.size - shelved.length;
    setText(this.found, (this.shown.length === all ? count(all, "alarm") : this.shown.length + " of " + count(all, "alarm"))
      + (alarms.dropped > 0 ? "; " + alarms.dropped + " left out, since the list is full" : ""));
    this.list.setCount(this.shown.length);
    this.all?.refresh();
    this.showShelved(shelved);
  }

  showShelved(shelved) {
    if (this.shownShelved !== undefined && this.shownShelved.length === shelved.length && shelved.every((alarm, i) => alarm === this.shownShelved[i])) return;
    this.shownShelved = shelved;
    const {app, result} = this;
    setText(this.shelvedCount, shelved.length > kMostShelved ? shelved.length + ", the first " + kMostShelved : shelved.length > 0 ? String(shelved.length) : "none");
    const rows = shelved.slice(0, kMostShelved).map((alarm) => [nameLink(app, alarm.of), priorityText(alarm.priority), alarm.on ? "on" : "off",
      make("span", {title: exactInstant(alarm.until)}, clockText(alarm.until)),
      ...(operates(app) ? [actButton(app, result, "Unshelve", () => ({unshelve: alarm.name}), {class: "small", "aria-label": "Unshelve " + alarm.name})] : [])]);
    this.shelved.replaceChildren(...(rows.length > 0 ? [table("Shelved alarms", ["Alarm", "Priority", "Is", "Until", ...(operates(app) ? ["Act"] : [])], rows)] : []));
  }

  /// Those that are shown now, not what comes meanwhile.
  async acknowledgeShown() {
    const names = this.shown.filter(isUnacknowledged).map(({name}) => name);
    for (let from = 0; from < names.length; from += kMostNames) {
      if (!await perform(this.app, this.result, () => ({acknowledge: names.slice(from, from + kMostNames)}))) return;
    }
  }

  change(change) { if (change.all || change.keys.has("alarms")) this.apply(); }
}
