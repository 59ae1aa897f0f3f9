// The names of the chart's rows, each at the height of what is drawn of it, with its present value.
import {breakable, button, make, setAttribute, setText} from "./dom.js";
import {linkTo} from "./links_to.js";
import {valueNow} from "./chart_rows.js";
import {dashOf, kColors} from "./trend_axes.js";

/// What rows have in common is small, what differs is large.
const twoLines = ({name, device, symbol}, plant) => {
  const of = device ?? plant.devices[symbol?.device];
  const head = device ? name.slice(0, -device.label.length) : of && name.startsWith(of.name + "_") ? of.name + "_" : "";
  return head === "" || !name.startsWith(head) ? [make("span", {class: "cut"}, name)]
    : [make("span", {class: "soft cut"}, head), make("span", {class: "cut"}, name.slice(head.length))];
};

export class ChartLegend {
  /// `moveUp(row)` and `remove(row)` are called by the buttons of a row.
  constructor(app, {moveUp, remove}) {
    Object.assign(this, {app, moveUp, remove, shown: []});
    this.element = make("ul", {class: "chart-names", "aria-label": "Rows of the chart, with their present values"});
  }

  /// Rows as describeRows() makes them.
  build({curves, bands}) {
    this.shown = [];
    this.curves = make("li", {class: "chart-values"}, make("ul", {}, curves.map((row) => this.label(row))));
    this.element.replaceChildren(make("li", {class: "chart-head"}, make("span", {class: "grow"}, "Name"), make("span", {class: "present"}, "Now")),
      ...(curves.length > 0 ? [this.curves] : []),
      ...bands.map((row) => this.label(row)));
    this.update();
  }

  /// The height of the curves, in pixels.
  setHeight(high) { this.curves.style.height = high + "px"; }

  label(row) {
    const {name, isCurve, rank} = row;
    const link = linkTo(row.kind, name, isCurve ? make("span", {}, breakable(name)) : twoLines(row, this.app.plant));
    link.title = name;
    const present = make("span", {class: "present"});
    this.shown.push([row, present]);
    return make("li", {"data-row": name}, make("span", {class: "grow"},
      isCurve ? make("span", {class: "swatch trend" + rank % kColors + " dash" + dashOf(rank), "aria-hidden": "true"}) : null, link), present,
    make("span", {class: "row-buttons"}, button("↑", () => this.moveUp(row), {class: "tiny", "aria-label": "Move up " + name, title: "Move up"}),
      button("✕", () => this.remove(row), {class: "tiny", "aria-label": "Remove " + name, title: "Remove"})));
  }

  /// Writes the present values again.
  update() {
    for (const [row, present] of this.shown) {
      const text = valueNow(this.app.store, row);
      setText(present, text);
      setAttribute(present, "title", text);  // a narrow column cuts it
    }
  }
}
