// The bar at the top of a live plant: plant time, run and freeze, speed, snapshot, what is forced.
import {actButton, perform, resultOutput} from "./acts.js";
import {ask} from "./dialog.js";
import {button, make, select, setAttribute, setText} from "./dom.js";
import {clockText, count, factor} from "./words.js";

const kSpeeds = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];
const kNoJump = "A PLC that is connected does not jump: its outputs, timers and counters stay as they are.";

/// Asks if a PLC is connected, then sets the plant back or on.
export const restore = async (app, result, {name, kind}) => {
  if (app.plant.with_plc && !await ask("Restore " + name + "?", [kNoJump], "Restore")) return;
  await perform(app, result, () => ({restore: name}), "restored the " + kind);
};

export class ControlBar {
  constructor(app) {
    this.app = app;
    this.result = resultOutput();
    this.time = make("span", {class: "plant-time", role: "timer", "aria-label": "Plant time"});
    this.state = make("span", {class: "plant-state"});
    this.forced = make("a", {href: "#view=io&filter=forced"});
    this.malfunctions = make("a", {href: "#view=malfunctions"});
    const acts = app.canAct ? this.acts() : [make("span", {class: "note"}, app.plant.acts ? app.deniedNote() : "This panel only shows: acts are off.")];
    this.element = make("div", {class: "row bar"}, this.time, this.state, acts, this.result);
    this.marks = make("div", {class: "row marks"}, this.malfunctions, this.forced, app.canAct ? this.releaseAll : null);
    this.update();
  }

  acts() {
    const {app, result} = this;
    this.runButton = button("", () => this.toggle(), {class: "run"});
    const step = (kind, label) => actButton(app, result, label, () => ({step: kind}));
    this.speed = select("Speed", [...kSpeeds.map((speed) => [String(speed), speed + " x"]), ["max", "max"]],
      {onchange: () => perform(app, result, () => ({speed: this.speed.value === "max" ? "max" : Number(this.speed.value)}))});
    if (app.plant.with_plc || app.plant.speed === false) {
      this.speed.disabled = true;
      this.speed.title = "Plant time is real time in this run";
    }
    this.releaseAll = actButton(app, result, "Release all", () => ({release: "all"}), {class: "small"});
    this.backtrack = button("Backtrack", () => this.back(), {title: "Restore the last backtrack"});
    return [make("span", {class: "row group", role: "group", "aria-label": "Plant time"}, this.runButton, step("cycle", "Step cycle"), step("change", "Step change"), this.speed,
      button("Reset", () => this.reset())),
    make("span", {class: "row group", role: "group", "aria-label": "Snapshots"},
      actButton(app, result, "Snapshot", () => ({snapshot: "at " + (app.store.t / 1e9).toFixed(3) + " s"})), this.backtrack)];
  }

  toggle() {
    perform(this.app, this.result, () => this.app.store.clock.state === "running" ? {freeze: true} : {run: true});
  }

  async reset() {
    const texts = ["Everything begins again at time 0. Forces and malfunctions end."];
    if (this.app.plant.with_plc) texts.push(kNoJump);
    if (await ask("Reset the plant?", texts, "Reset")) perform(this.app, this.result, () => ({reset: true}));
  }

  back() {
    const last = this.app.store.snapshots.filter(({kind}) => kind === "backtrack").pop();
    if (last) restore(this.app, this.result, last);
  }

  update() {
    this.tick();
    const {clock, forced, malfunctions, snapshots} = this.app.store;
    const speed = clock.state === "running" ? ", " + factor(clock.real_speed) : "";
    setText(this.state, clock.state + speed);
    setAttribute(this.state, "data-state", clock.state);
    setText(this.forced, forced + " forced");
    this.forced.classList.toggle("alert", forced > 0);
    setText(this.malfunctions, count(malfunctions.length, "malfunction"));
    this.malfunctions.classList.toggle("alert", malfunctions.length > 0);
    if (!this.runButton) return;
    setText(this.runButton, clock.state === "running" ? "Freeze" : "Run");
    this.runButton.disabled = clock.state === "ended";
    this.releaseAll.hidden = forced === 0;
    this.backtrack.disabled = !snapshots.some(({kind}) => kind === "backtrack");
    if (document.activeElement !== this.speed) this.speed.value = String(clock.speed);
  }

  tick() { setText(this.time, clockText(this.app.clock.now())); }
}
