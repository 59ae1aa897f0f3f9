// The table of the chart's cursors: the value of each row at both, and the difference.
import {cursorTable} from "./chart_rows.js";
import {make, setText, table} from "./dom.js";

export class CursorTable {
  constructor() {
    this.element = make("section", {class: "chart-cursors", "aria-label": "Values at the cursors", tabindex: 0, hidden: true});
    this.shape = "";
  }

  /// Rows as describeRows() makes them, the curves first; `until` is the end of what is known. Only texts that changed are written.
  show(rows, cursors, until) {
    this.element.hidden = cursors.A === null && cursors.B === null;
    if (this.element.hidden) return;
    const {heads, rows: texts} = cursorTable(rows, cursors, until);
    const shape = JSON.stringify([heads, texts.map(([name]) => name)]);
    if (shape !== this.shape) this.build(shape, heads, texts);
    texts.forEach((line, i) => line.forEach((text, k) => setText(this.cells[i][k], text)));
  }

  build(shape, heads, texts) {
    this.shape = shape;
    const made = table("Values at the cursors", heads, texts);
    this.cells = [...made.tBodies[0].rows].map((row) => [...row.cells]);
    this.element.replaceChildren(made);
  }
}
