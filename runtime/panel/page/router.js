// What the fragment of the address says: the view, what is shown in it, and what is selected. Names, not indexes, so that
// a link is still right after a restart.

const kFirst = "plan";
const kSelections = ["device", "symbol", "location", "requirement", "value", "why"];

export class Router {
  /// `changed(route)` is called at once, and each time the fragment changes.
  constructor(changed) {
    this.changed = changed;
    this.route = {view: kFirst};
    addEventListener("hashchange", () => this.read());
    document.addEventListener("click", (event) => this.clicked(event));
  }

  /// A link without `view` keeps the view and what is shown in it; one without a selection keeps the selection.
  clicked(event) {
    const link = event.target.closest?.('a[href^="#"]');
    if (!link || event.defaultPrevented || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    const wanted = Object.fromEntries(new URLSearchParams(link.hash.slice(1)));
    const selection = this.selection();
    const keeps = selection && !kSelections.some((key) => key in wanted);
    this.go({...(wanted.view ? {} : this.withoutSelection()), ...wanted, ...(keeps ? {[selection.kind]: selection.name} : {})});
  }

  read() {
    const wanted = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
    const route = wanted.view ? wanted : {...this.withoutSelection(), ...wanted};
    if (!route.view) route.view = kFirst;
    this.route = route;
    if (location.hash.slice(1) !== this.text(route)) history.replaceState(null, "", "#" + this.text(route));
    this.changed(route);
  }

  text(route) { return new URLSearchParams(route).toString(); }

  withoutSelection() {
    return Object.fromEntries(Object.entries(this.route).filter(([key]) => !kSelections.includes(key)));
  }

  selection() {
    const kind = kSelections.find((key) => key in this.route);
    return kind ? {kind, name: this.route[kind]} : null;
  }

  go(route) { location.hash = this.text(route); }
  select(kind, name) { this.go({...this.withoutSelection(), [kind]: name}); }
  deselect() { this.go(this.withoutSelection()); }
  /// To another view; the selection stays.
  view(view, more = {}) {
    const selected = this.selection();
    this.go({view, ...more, ...(selected ? {[selected.kind]: selected.name} : {})});
  }
}

/// The fragment of a link that selects something and keeps the view.
export const selecting = (kind, name) => "#" + new URLSearchParams({[kind]: name}).toString();
