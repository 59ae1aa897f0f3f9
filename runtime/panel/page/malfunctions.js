// The malfunctions view: the active ones, those of the plant's description, and the ordinary ones of devices and symbols.
import {actButton, malfunctionButton, resultOutput} from "./acts.js";
import {make, table, timeOf} from "./dom.js";
import {deviceLink, linkTo, symbolLink} from "./links_to.js";
import {makeSearch} from "./search.js";

export class MalfunctionsView {
  constructor(app) {
    Object.assign(this, {app, title: "Malfunctions", toggles: [], ordinary: []});
    this.result = resultOutput();
    this.active = make("div", {});
    this.chosen = make("div", {});
    // What is chosen comes before the active ones: their list grows and shrinks, and must not move a control.
    this.element = make("div", {class: "view columns malfunctions"}, this.result,
      make("section", {"aria-label": "Malfunctions of the plant"}, make("h2", {}, "Of this plant"), this.described()),
      app.canAct ? make("section", {"aria-label": "Ordinary malfunctions", class: "opens"}, make("h2", {}, "Of any device or event"),
        make("p", {class: "soft"}, "A device can be stuck or slow, a BOOL event stuck on or off."), this.search(), this.chosen) : null,
      make("section", {"aria-label": "Active malfunctions", class: "active"}, make("h2", {}, "Active"), this.active));
  }

  described() {
    const {app, result} = this;
    const rows = app.plant.malfunctions.map(({name, kind, devices = [], symbols = [], values = []}) => {
      const of = [...devices.map((index) => deviceLink(app, index)), ...symbols.map((index) => symbolLink(app, index)),
        ...values.map((index) => linkTo("value", app.plant.values[index].name))];
      const shown = [...of.slice(0, 5).flatMap((link, i) => i > 0 ? [", ", link] : [link]), of.length > 5 ? " and " + (of.length - 5) + " more" : ""];
      if (!app.canAct) return [name, kind, shown];
      const toggle = malfunctionButton(app, result, name);
      this.toggles.push(toggle);
      return [name, kind, shown, toggle.element];
    });
    return rows.length > 0 ? table("Malfunctions of the plant", ["Name", "Kind", "Acts on", ...(app.canAct ? ["Act"] : [])], rows)
      : make("p", {class: "soft"}, "plant.json has no malfunctions");
  }

  search() {
    return makeSearch(this.app, {label: "Find a device or an event", accepts: (kind, index) => this.kindsOf(kind, index).length > 0,
      choose: ({kind, name}) => this.offer(kind, name)});
  }

  /// The ordinary malfunctions of a thing: none of an operation or a number.
  kindsOf(kind, index) {
    const {ordinary = {}, symbols} = this.app.plant;
    if (kind === "device") return ordinary.device ?? [];
    return kind === "symbol" && symbols[index].direction === "event" && symbols[index].type === "BOOL" ? ordinary.event ?? [] : [];
  }

  offer(kind, name) {
    const kinds = this.kindsOf(kind, this.app.names.index(kind, name));
    this.ordinary = kinds.map((of) => malfunctionButton(this.app, this.result, name + " " + of, of));
    this.chosen.replaceChildren(make("p", {}, make("span", {class: "name"}, name)),
      make("div", {class: "row controls"}, this.ordinary.map(({element}) => element)));
  }

  show() { this.update(); }

  update() {
    const {app, result} = this;
    const rows = app.store.malfunctions.map(([name, since, by]) => [make("span", {class: "name"}, name), timeOf(since), by,
      ...(app.canAct ? [actButton(app, result, "Stop", () => ({stop: name}), {class: "small", "aria-label": "Stop " + name})] : [])]);
    this.active.replaceChildren(rows.length > 0
      ? table("Active malfunctions", ["Name", "Since", "Started by", ...(app.canAct ? ["Act"] : [])], rows) : make("p", {class: "soft"}, "none"));
    for (const {update} of [...this.toggles, ...this.ordinary]) update();
  }

  change(change) {
    if (change.all || change.keys.has("malfunctions")) this.update();
  }
}
