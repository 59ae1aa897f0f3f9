// The views of the page and the list of them; only the one that is shown follows the plant.
import {refreshActs} from "./acts.js";
import {AlarmsView} from "./alarms.js";
import {ChartView} from "./chart.js";
import {make, setAttribute} from "./dom.js";
import {ExerciseView} from "./exercise.js";
import {FindingsView} from "./findings.js";
import {IoView} from "./io.js";
import {LineView} from "./line.js";
import {LinksView} from "./links.js";
import {MalfunctionsView} from "./malfunctions.js";
import {PlanView} from "./plan/view.js";
import {SessionView} from "./session.js";
import {UtilizationView} from "./utilization.js";
import {ValuesView} from "./values.js";
import {View3d} from "./view3d/view3d.js";

const kOfTrainer = ["malfunctions", "session"];

/// [key, title, class] in order.
export const makeViews = (app) => {
  const values = app.plant.values.length > 0 ? [["values", "Values", ValuesView]] : [];
  const all = [["plan", "Plan", PlanView], ["line", "Tiles", LineView], ["3d", "3D", View3d], ["io", "I/O", IoView], ...values, ["chart", "Chart", ChartView], ["alarms", "Alarms", AlarmsView], ["findings", "Findings", FindingsView],
    ["links", "Links", LinksView], ["malfunctions", "Malfunctions", MalfunctionsView], ["exercises", "Exercises", ExerciseView],
    ["session", "Session", SessionView], ["utilization", "Utilization", UtilizationView]];
  if (app.plant.mode === "recording") return all.slice(0, 6 + values.length);
  return app.plant.role === "trainer" ? all : all.filter(([key]) => !kOfTrainer.includes(key));
};

export class Views {
  /// `nav` gets a link for each view. A view is made when it is first shown.
  constructor(app, views, nav) {
    Object.assign(this, {app, made: new Map(), shown: null, shownKey: ""});
    this.views = new Map(views.map(([key, title, View]) => [key, {title, View}]));
    this.keys = [...this.views.keys()];
    this.links = new Map(views.map(([key, title]) => [key, make("a", {href: "#view=" + key}, title)]));
    nav.append(...this.links.values());
  }

  title(key) { return this.views.get(key).title; }

  show(route) {
    const key = this.views.has(route.view) ? route.view : this.keys[0];
    if (!this.made.has(key)) this.made.set(key, new (this.views.get(key).View)(this.app));
    const view = this.made.get(key);
    if (key !== this.shownKey) {
      this.shownKey = key;
      this.shown = view;
      this.app.main.replaceChildren(view.element);
      refreshActs();
      this.app.main.setAttribute("aria-label", this.title(key));
      for (const [of, link] of this.links) setAttribute(link, "aria-current", of === key ? "page" : null);
    }
    view.show(route);
    this.app.frames.request();
  }

  change(change, statusChanged) { this.shown?.change?.(change, statusChanged); }
  tick() { this.shown?.tick?.(); }
  /// Returns whether the view wants a further frame.
  frame(now) { return this.shown?.frame?.(now) ?? false; }
}
