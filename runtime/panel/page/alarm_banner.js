// The line with the alarms that wait for a person, in every view: how many, the most urgent one, and the horn.
import {actButton, resultOutput} from "./acts.js";
import {alarmText, priorityText} from "./alarm_words.js";
import {PRIORITIES} from "./alarm_state.js";
import {button, make, setAttribute, setText} from "./dom.js";
import {Horn} from "./horn.js";
import {operates} from "./rights.js";

const kPause = 4000;  // ms between two announcements

export class AlarmBanner {
  constructor(app) {
    Object.assign(this, {app, horn: new Horn(), first: null, said: null, timer: null});
    this.counts = PRIORITIES.map(({key}) => ({key, element: make("span", {class: "alarm-chip", "data-priority": key})}));
    this.link = make("a", {href: "#view=alarms", class: "alarm-counts"}, this.counts.map(({element}) => element));
    this.text = make("span", {class: "cut grow alarm-first"});
    this.result = resultOutput();
    this.live = make("div", {class: "hidden-text", role: "status", "aria-live": "polite"});
    this.hornButton = button("Horn", () => this.switchHorn(), {class: "small toggle", "aria-pressed": "false",
      title: "This browser sounds while an alarm of high priority waits"});
    this.silence = operates(app) ? actButton(app, this.result, "Silence", () => ({silence: true}), {class: "small", title: "Ends the horn in all browsers, until the next alarm"},
      () => app.store.alarms.horn) : null;
    this.acknowledge = operates(app) ? actButton(app, this.result, "Acknowledge", () => ({acknowledge: this.first.name}), {class: "small"}, () => this.first !== null) : null;
    this.element = make("div", {class: "row alarm-line", role: "group", "aria-label": "Alarms that are not acknowledged"}, this.link, this.text, this.result,
      this.acknowledge, this.silence, this.hornButton, this.live);
    this.update();
  }

  switchHorn() {
    this.horn.switch(!this.horn.isOn);
    setAttribute(this.hornButton, "aria-pressed", String(this.horn.isOn));
  }

  update() {
    const {counts, first, horn} = this.app.store.alarms;
    this.first = first;
    for (const {key, element} of this.counts) {
      setText(element, priorityText(key).replace(" ", " " + counts[key] + " "));
      element.classList.toggle("waits", counts[key] > 0);
    }
    setText(this.text, first === null ? "no alarm waits" : alarmText(first));
    this.text.title = first?.text ?? "";
    setAttribute(this.element, "data-priority", first?.priority ?? "");
    if (this.acknowledge) {
      setAttribute(this.acknowledge, "aria-label", first ? "Acknowledge " + first.name : null);
      this.acknowledge.refresh();
      this.silence.refresh();
    }
    this.horn.update(horn);
  }

  change(change) {
    if (!change.all && !change.keys.has("alarms")) return;
    this.update();
    this.announce(change.all);
  }

  /// Findings are announced as such; here it is the alarms of the program.
  announce(isNew) {
    const last = this.lastOfProgram();
    if (this.said === null || isNew) this.said = last?.came ?? -1;
    else if (last && last.came > this.said && this.timer === null) this.timer = setTimeout(() => this.say(), 200);
  }

  lastOfProgram() {
    let last = null;
    for (const alarm of this.app.store.alarms.byName.values()) {
      if (alarm.source === "alarm" && alarm.state === "active" && (last === null || alarm.came > last.came)) last = alarm;
    }
    return last;
  }

  say() {
    const last = this.lastOfProgram();
    if (last) {
      this.said = last.came;
      this.live.textContent = "Alarm, " + last.priority + ": " + alarmText(last);
    }
    this.timer = setTimeout(() => {
      this.timer = null;
      this.announce(false);
    }, kPause);
  }
}
