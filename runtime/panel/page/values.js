// The values view: all values with their numbers, bars, and what sets them.
import {resultOutput} from "./acts.js";
import {button, make, setAttribute, setText} from "./dom.js";
import {operates} from "./rights.js";
import {selecting} from "./router.js";
import {valueControl, valueDisplay} from "./value_control.js";
import {formulaText} from "./value_words.js";
import {VirtualList} from "./virtual_list.js";
import {count} from "./words.js";

const kHeight = 44;
const kColumns = ["Value", "Number", "Range", "Formula"];

export class ValuesView {
  constructor(app) {
    Object.assign(this, {app, title: "Values", indexes: [], rowOf: new Map()});
    this.search = make("input", {type: "search", "aria-label": "Filter by name, unit or formula", placeholder: "Name, unit or formula", autocomplete: "off",
      oninput: () => this.apply()});
    const box = make("input", {type: "checkbox", onchange: () => this.apply()});
    this.settable = box;
    this.found = make("span", {class: "soft", role: "status"});
    this.result = resultOutput();
    const heads = operates(app) ? [...kColumns, "Set", "Chart"] : [...kColumns, "Chart"];
    this.list = new VirtualList({height: kHeight, label: "Values",
      head: make("div", {class: "value-row io-head", role: "row"}, heads.map((head) => make("span", {role: "columnheader", class: "value-" + head.toLowerCase()}, head))),
      makeRow: () => this.makeRow(), fillRow: (row, at) => this.fillRow(row, this.indexes[at])});
    this.list.element.classList.toggle("io-acts", operates(app));
    this.element = make("div", {class: "view values-view fills"},
      make("div", {class: "row tools"}, this.search, make("label", {class: "check"}, box, "can be set")),
      make("div", {class: "row result-line"}, this.found, this.result), this.list.element);
  }

  show() { this.apply(); }

  accepts(value) {
    if (this.settable.checked && !value.settable) return false;
    const text = (value.name + " " + value.unit + " " + value.kind + " " + value.formulas.join(" ")).toLowerCase();
    return this.search.value.toLowerCase().split(/\s+/).every((word) => text.includes(word));
  }

  apply() {
    const {values} = this.app.plant;
    this.indexes = [...values.keys()].filter((index) => this.accepts(values[index]));
    this.rowOf = new Map(this.indexes.map((index, row) => [index, row]));
    this.list.setCount(this.indexes.length);
    setText(this.found, this.indexes.length === values.length ? count(values.length, "value") : this.indexes.length + " of " + count(values.length, "value"));
  }

  makeRow() {
    const {app} = this;
    const row = {first: make("a", {class: "name"}), shown: -1};
    const index = () => row.shown;
    const cell = (name, ...content) => make("span", {role: "cell", class: "value-" + name}, content);
    row.display = valueDisplay(app, index);
    row.formula = cell("formula");
    row.control = operates(app) ? valueControl(app, index, this.result) : null;
    row.chart = button("chart", () => app.chart.addValue(row.shown), {class: "small"});
    row.element = make("div", {class: "value-row", role: "row"}, cell("value", row.first), cell("number", row.display.text, row.display.mark),
      cell("range", row.display.bar), row.formula, row.control ? cell("set", row.control.element) : null, cell("chart", row.chart));
    return row;
  }

  fillRow(row, index) {
    const value = this.app.plant.values[index];
    if (row.shown !== index) {
      row.shown = index;
      setText(row.first, value.name);
      row.first.href = selecting("value", value.name);
      row.first.title = value.name;
      setText(row.formula, formulaText(value) || value.kind);
      row.formula.title = row.formula.textContent;
      row.chart.hidden = value.trace === null;
      setAttribute(row.chart, "aria-label", "Show " + value.name + " in the chart");
    }
    row.display.update();
    row.control?.update();
  }

  change({all, values}) {
    if (all) return this.list.refreshAll();
    for (const index of values) {
      const row = this.rowOf.get(index);
      if (row !== undefined) this.list.refresh(row);
    }
  }
}
