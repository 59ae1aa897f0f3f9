// A list of rows of one height, of which only those that can be seen are in the document.
import {make} from "./dom.js";

const kMargin = 6;  // rows above and below what can be seen

export class VirtualList {
  /// `makeRow()` makes an empty row with an element and `first`, what gets the focus; `fillRow(row, index)` shows a row in it.
  constructor({height, label, role = "table", head = null, makeRow, fillRow}) {
    this.isTable = role === "table";
    Object.assign(this, {height, makeRow, fillRow, count: 0, current: 0, rows: new Map(), spare: []});
    this.body = make("div", {class: "virtual-body", role: this.isTable ? "rowgroup" : "list"});
    this.element = make("div", {class: "virtual", role: this.isTable ? "table" : "group", "aria-label": label,
      onkeydown: (event) => this.key(event), onfocusin: (event) => this.focused(event)}, head, this.body);
    this.element.addEventListener("scroll", () => this.mount(), {passive: true});
    new ResizeObserver(() => this.mount()).observe(this.element);
  }

  setCount(count) {
    this.count = count;
    this.current = Math.max(0, Math.min(this.current, count - 1));
    this.body.style.height = count * this.height + "px";
    if (this.isTable) this.element.setAttribute("aria-rowcount", count + 1);
    this.mount(true);
  }

  /// The rows that can be seen, [from, until).
  range() {
    const top = this.element.scrollTop;
    const from = Math.max(0, Math.floor(top / this.height) - kMargin);
    return [from, Math.min(this.count, Math.ceil((top + this.element.clientHeight) / this.height) + kMargin)];
  }

  /// `again`: also rows that are shown already are filled.
  mount(again = false) {
    const [from, until] = this.range();
    for (const [index, row] of this.rows) {
      const stays = index < this.count && (index >= from && index < until || row.element.contains(document.activeElement));
      if (stays) {
        if (again) this.fill(row, index);
        continue;
      }
      row.element.hidden = true;
      this.rows.delete(index);
      this.spare.push(row);
    }
    for (let index = from; index < until; ++index) if (!this.rows.has(index)) this.show(index);
  }

  show(index) {
    let row = this.spare.pop();
    if (!row) {
      row = this.makeRow();
      this.body.append(row.element);
    }
    row.element.hidden = false;
    row.element.style.transform = "translateY(" + index * this.height + "px)";
    this.rows.set(index, row);
    this.fill(row, index);
    return row;
  }

  fill(row, index) {
    row.index = index;
    row.element.setAttribute(this.isTable ? "aria-rowindex" : "aria-posinset", this.isTable ? index + 2 : index + 1);
    if (!this.isTable) row.element.setAttribute("aria-setsize", this.count);
    row.first.tabIndex = index === this.current ? 0 : -1;
    this.fillRow(row, index);
  }

  /// Fills a row again if it is shown.
  refresh(index) {
    const row = this.rows.get(index);
    if (row) this.fill(row, index);
  }

  refreshAll() { for (const [index, row] of this.rows) this.fill(row, index); }

  focused({target}) {
    for (const [index, row] of this.rows) {
      if (!row.element.contains(target)) continue;
      this.setCurrent(index);
    }
  }

  setCurrent(index) {
    const before = this.rows.get(this.current);
    if (before) before.first.tabIndex = -1;
    this.current = index;
    const row = this.rows.get(index);
    if (row) row.first.tabIndex = 0;
  }

  key(event) {
    const page = Math.max(1, Math.floor(this.element.clientHeight / this.height) - 2);
    const by = {ArrowUp: -1, ArrowDown: 1, PageUp: -page, PageDown: page, Home: -this.count, End: this.count}[event.key];
    if (by === undefined || this.count === 0 || event.target.tagName === "INPUT" || event.target.tagName === "SELECT") return;
    event.preventDefault();
    const index = Math.max(0, Math.min(this.count - 1, this.current + by));
    this.reveal(index);
    this.setCurrent(index);
    this.rows.get(index)?.first.focus({preventScroll: true});
  }

  /// Scrolls so that a row can be seen.
  reveal(index) {
    const top = index * this.height;
    const high = this.element.clientHeight - this.body.offsetTop;
    if (top < this.element.scrollTop) this.element.scrollTop = top;
    else if (top + this.height > this.element.scrollTop + high) this.element.scrollTop = top + this.height - high;
    this.mount();
  }
}
