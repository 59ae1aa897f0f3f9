// The links view: links to PLCs, programs in lock step, and how well the cycle keeps its time.
import {actButton, resultOutput} from "./acts.js";
import {make, table} from "./dom.js";
import {duration} from "./words.js";

const kPause = 500;

const bar = (part) => {
  const fill = make("span", {class: "fill"});
  fill.style.transform = "scaleX(" + part + ")";
  return make("span", {class: "bar shown wide", "aria-hidden": "true"}, fill);
};

/// Without the empty classes at both ends.
const trimmed = (histogram) => {
  const first = histogram.findIndex(([, count]) => count > 0);
  if (first < 0) return [];
  let last = histogram.length - 1;
  while (histogram[last][1] === 0) --last;
  return histogram.slice(first, last + 1);
};

export class LinksView {
  constructor(app) {
    Object.assign(this, {app, title: "Links", pending: false, last: 0});
    this.links = make("div", {});
    this.cycle = make("div", {});
    this.element = make("div", {class: "view columns"}, make("section", {"aria-label": "Links"}, make("h2", {}, "Links"), this.links,
      this.programs()), make("section", {"aria-label": "Cycle"}, make("h2", {}, "Cycle"), this.cycle));
  }

  /// The programs in lock step, each with a button for its cold start.
  programs() {
    const {plant} = this.app;
    if (plant.programs.length === 0) return null;
    const result = resultOutput();
    const restart = ({name, controller}) =>
      actButton(this.app, result, "Restart", () => ({restart: controller || true}), {class: "small", "aria-label": "Restart " + name});
    return make("div", {}, make("h3", {}, "PLC programs in lock step"), table("PLC programs", ["Program", "Controller", "Scan every", ""],
      plant.programs.map((program) => [make("span", {class: "name"}, program.name), program.controller || "-", duration(program.period),
        this.app.canAct ? restart(program) : ""])), result);
  }

  show() {
    const {store, plant} = this.app;
    this.last = performance.now();
    const rows = store.links.map(({state, requests, rate, last, losses}, i) => [make("span", {class: "name"}, plant.links[i]?.name ?? "?"),
      plant.links[i]?.controller || "-", make("span", {class: "link-" + state}, state), String(requests), String(Math.round(rate)),
      last === null || last === undefined ? "-" : last.toFixed(1) + " s ago", String(losses)]);
    this.links.replaceChildren(rows.length > 0
      ? table("Links", ["Link", "Controller", "State", "Requests", "A second", "Last request", "Losses"], rows)
      : make("p", {class: "soft"}, "The plant has no link to a PLC."));
    this.cycle.replaceChildren(...this.cycleParts(store.cycle));
  }

  cycleParts(cycle) {
    if (!cycle) return [make("p", {class: "soft"}, "The plant runs in virtual time: it has no cycle.")];
    const {late, work, histogram} = cycle;
    const times = (name, {p50, p99, p999, max}) => [name, ...[p50, p99, p999, max].map(duration)];
    const classes = trimmed(histogram ?? []);
    const most = Math.max(1, ...classes.map(([, number]) => number));
    return [make("p", {}, cycle.cycles + " cycles, " + cycle.overruns + " overruns, " + cycle.slipped + " slipped"),
      table("Times of the cycle", ["Time", "Half", "99 %", "99.9 %", "Most"], [times("Late by", late), times("Work", work)]),
      make("h3", {}, "How late cycles begin"),
      classes.length === 0 ? make("p", {class: "soft"}, "no cycles yet")
        : table("Histogram of lateness", ["Up to", "Cycles", "Share"], classes.map(([upper, number]) => [duration(upper), String(number), bar(number / most)]))];
  }

  change(change) {
    if (change.all || change.keys.has("links") || change.keys.has("cycle")) this.pending = true;
    if (this.pending) this.app.frames.request();
  }

  frame() {
    if (!this.pending) return false;
    if (performance.now() - this.last < kPause) return true;
    this.pending = false;
    this.show();
    return false;
  }
}
