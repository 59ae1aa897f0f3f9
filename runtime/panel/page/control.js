// The bar at the top of a live plant: plant time, run and freeze, speed, snapshot, what is forced.
import {actButton, acting, actingButton, perform, resultOutput} from "./acts.js";
import {ask} from "./dialog.js";
import {make, select, setAttribute, setText} from "./dom.js";
import {seesMalfunctions} from "./rights.js";
import {clockText, count, factor} from "./words.js";

const kSpeeds = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];
const kMeasured = 2500;  // ms until the real speed is measured
const kNoJump = "A PLC that is connected does not jump: its outputs, timers and counters stay as they are.";

/// The speed that was chosen, with the real one where they differ. That one is the mean of a second: while the choice `isNew`
/// it is of the speed before.
export const speedText = ({speed, real_speed: real}, isNew) => {
  if (speed === "max") return isNew ? "max" : factor(real);
  return isNew || Math.abs(real - speed) <= .1 * speed ? factor(speed) : factor(real).replace(" x", " of ") + factor(speed);
};

/// The name of a snapshot of now.
export const presentName = (app) => "at " + (app.clock.now() / 1e9).toFixed(3) + " s";

/// Asks if a PLC is connected, then sets the plant back or on.
export const restore = async (app, result, {name}) => {
  if (app.plant.with_plc && !await ask("Restore " + name + "?", [kNoJump], "Restore")) return;
  await perform(app, result, () => ({restore: name}));
};

/// Why the page does not act.
const restNote = ({plant, rights, deniedNote}) =>
  !plant.acts ? "This panel only shows: acts are off." : rights === "denied" ? deniedNote() : "This link only shows the plant.";

export class ControlBar {
  constructor(app) {
    this.app = app;
    this.result = resultOutput();
    this.time = make("span", {class: "plant-time", role: "timer", "aria-label": "Plant time"});
    this.state = make("span", {class: "plant-state"});
    this.forced = make("a", {href: "#view=io&filter=forced"});
    this.malfunctions = make("a", {href: "#view=malfunctions"});
    const acts = app.canAct ? this.acts() : app.rights === "allowed" ? [] : [make("span", {class: "note"}, restNote(app))];
    this.element = make("div", {class: "row bar"}, this.time, this.state, acts, this.result);
    this.marks = make("div", {class: "row marks"}, seesMalfunctions(app) ? this.malfunctions : null, this.forced, app.canAct ? this.releaseAll : null);
    this.update();
  }

  acts() {
    const {app, result} = this;
    this.runButton = actingButton(app, "", () => this.toggle(), {class: "run"}, () => app.store.clock.state !== "ended");
    const step = (kind, label) => actButton(app, result, label, () => ({step: kind}));
    const isSet = !app.plant.with_plc && app.plant.speed !== false;
    this.speed = acting(app, select("Speed", [...kSpeeds.map((speed) => [String(speed), speed + " x"]), ["max", "max"]],
      {title: isSet ? null : "Plant time is real time in this run",
        onchange: () => perform(app, result, () => ({speed: this.speed.value === "max" ? "max" : Number(this.speed.value)}))}), () => isSet);
    this.releaseAll = actButton(app, result, "Release all", () => ({release: "all"}), {class: "small"}, () => app.store.forced > 0);
    this.backtrack = actingButton(app, "Backtrack", () => this.back(), {title: "Restore the last backtrack"}, () => Boolean(this.lastBacktrack()));
    return [make("span", {class: "row group", role: "group", "aria-label": "Plant time"}, this.runButton, step("cycle", "Step cycle"), step("change", "Step change"), this.speed,
      actingButton(app, "Reset", () => this.reset())),
    make("span", {class: "row group", role: "group", "aria-label": "Snapshots"},
      actButton(app, result, "Snapshot", () => ({snapshot: presentName(app)})), this.backtrack)];
  }

  toggle() {
    return perform(this.app, this.result, () => this.app.store.clock.state === "running" ? {freeze: true} : {run: true});
  }

  async reset() {
    const texts = ["Everything begins again at time 0, and so does a scenario that runs. Forces and malfunctions end."];
    if (this.app.plant.with_plc) texts.push(kNoJump);
    if (await ask("Reset the plant?", texts, "Reset")) await perform(this.app, this.result, () => ({reset: true}));
  }

  /// Whether the clock goes on in another way since a moment ago.
  isNew({state, speed}) {
    const shown = state + speed;
    if (shown !== this.clockShown) Object.assign(this, {clockShown: shown, clockSince: performance.now()});
    return performance.now() - this.clockSince < kMeasured;
  }

  lastBacktrack() { return this.app.store.snapshots.filter(({kind}) => kind === "backtrack").pop(); }
  back() { return restore(this.app, this.result, this.lastBacktrack()); }

  update() {
    this.tick();
    const {store, lost} = this.app;
    const {clock, forced, malfunctions} = store;
    setText(this.state, lost ? "no connection" : clock.state + (clock.state === "running" ? ", " + speedText(clock, this.isNew(clock)) : ""));
    setAttribute(this.state, "data-state", lost ? "lost" : clock.state);
    setText(this.forced, forced + " forced");
    this.forced.classList.toggle("alert", forced > 0);
    setText(this.malfunctions, count(malfunctions.length, "malfunction"));
    this.malfunctions.classList.toggle("alert", malfunctions.length > 0);
    if (!this.runButton) return;
    setText(this.runButton, clock.state === "running" ? "Freeze" : "Run");
    for (const element of [this.runButton, this.releaseAll, this.backtrack]) element.refresh();
    if (document.activeElement !== this.speed) this.speed.value = String(clock.speed);
  }

  tick() { setText(this.time, clockText(this.app.clock.now())); }
}
