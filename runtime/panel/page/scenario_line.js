// The line below the bar that says how far the scenario of the run is; absent without one.
import {make, setText} from "./dom.js";

export class ScenarioLine {
  constructor(app) {
    this.app = app;
    this.progress = make("span", {class: "soft"});
    this.next = make("span", {class: "cut grow"});
    this.element = make("div", {class: "row scenario-line", hidden: true, "aria-label": "Scenario", role: "group"}, this.progress, this.next);
  }

  change(change) {
    if (!change.all && !change.keys.has("scenario")) return;
    const {scenario} = this.app.store;
    this.element.hidden = scenario === null;
    if (scenario === null) return;
    const {name, done, steps, over, next} = scenario;
    const progress = over ? "is over" : done === null ? "goes on" : done + " of " + steps + " steps done";
    setText(this.progress, "Scenario " + (name.split("/").pop() || "") + ": " + progress);
    setText(this.next, next === "" ? "" : "next: " + next);
    this.next.title = next;
  }
}
