// The pane at the side: what is selected, with why it is as it is, and what can be done with it.
import {resultOutput} from "./acts.js";
import {commentOf} from "./comments.js";
import {breakable, button, make, setAttribute, setText} from "./dom.js";
import {fillDevice} from "./device_details.js";
import {fillLocation} from "./location_details.js";
import {fillRequirement} from "./requirement_details.js";
import {operates} from "./rights.js";
import {fillSymbol} from "./symbol_details.js";
import {fillValue} from "./value_details.js";
import {Why} from "./why.js";
import {exactInstant, instant} from "./words.js";

const kFillers = {device: fillDevice, symbol: fillSymbol, location: fillLocation, requirement: fillRequirement, value: fillValue};
const kWords = {device: "Device", symbol: "Symbol", location: "Track or place", requirement: "Requirement", value: "Value", why: "Explanation"};

/// What a filler uses: sections, and texts that follow the state of the plant.
export class Pane {
  constructor(app) {
    this.app = app;
    this.updates = [];
    this.element = make("div", {class: "pane"});
    this.result = resultOutput();  // of all acts of the pane; it stays in view at the top
    this.beforeWhy = null;  // the section after which the explanation comes; null: the first one
    this.devices = new Set();
    this.symbols = new Set();
  }

  /// A text that is computed again after each change.
  live(compute, name = "span", attributes = {}) {
    const element = make(name, attributes);
    this.follow(() => setText(element, compute()));
    return element;
  }

  /// `update()` is called now and after each change.
  follow(update) {
    update();
    this.updates.push(update);
  }

  /// An attribute that is computed again after each change; null removes it.
  attribute(element, name, compute) {
    this.follow(() => setAttribute(element, name, compute()));
    return element;
  }

  /// "since 12.3 s", with the exact time as its title.
  since(time) { return this.attribute(this.live(() => "since " + instant(time())), "title", () => exactInstant(time())); }

  /// Appends a section and returns it.
  section(title, ...content) {
    const section = make("section", {}, make("h3", {}, title), ...content);
    this.element.append(section);
    return section;
  }

  update() { for (const update of this.updates) update(); }
}

export class Details {
  /// `element` is the <aside>.
  constructor(app, element) {
    Object.assign(this, {app, element, shown: "", pane: null, why: null});
  }

  /// `selection` is { kind, name } or null.
  show(selection) {
    const shown = selection ? selection.kind + "\n" + selection.name : "";
    if (shown === this.shown) return;
    this.shown = shown;
    this.why?.close();
    this.why = this.pane = null;
    this.element.hidden = selection === null;
    document.body.classList.toggle("with-details", selection !== null);
    if (selection === null) return this.element.replaceChildren();
    this.fill(selection);
  }

  fill({kind, name}) {
    const {app} = this;
    const pane = this.pane = new Pane(app);
    const index = kind === "why" ? null : app.names.index(kind, name);
    const comment = index === null ? "" : commentOf(app.plant, kind, index);
    pane.element.append(make("div", {class: "row pane-head"},
      make("div", {class: "grow"}, make("div", {class: "soft"}, kWords[kind]), make("h2", {class: "name", tabindex: -1}, breakable(name)),
        comment ? make("div", {class: "comment"}, comment) : null),
      button("✕", () => app.router.deselect(), {class: "close", "aria-label": "Close the details", title: "Close (Esc)"}), operates(app) ? pane.result : null));
    if (kind !== "why" && index === null) {
      pane.element.append(make("p", {class: "wrong"}, "The plant has no " + kWords[kind].toLowerCase() + " of this name."));
    } else {
      kFillers[kind]?.(pane, index);
      if (app.plant.mode === "live") {
        this.why = new Why(app, name);
        // Why comes as early as possible: it is what the user looks for. Before it come the controls of a faceplate.
        (pane.beforeWhy ?? pane.element.children[pane.element.children.length > 1 ? 1 : 0]).after(this.why.element);
      }
    }
    this.element.replaceChildren(pane.element);
    this.element.scrollTop = 0;
  }

  change(change) {
    if (!this.pane) return;
    this.pane.update();
    this.why?.change(change);
  }

  /// Texts that depend on plant time.
  tick() {
    this.pane?.update();
    this.why?.tick();
  }
}
