// A place in the line view: slots with the kinds of the parts in it, its sensors and its transfers.
import {make, setText} from "./dom.js";
import {showKind} from "./kinds.js";
import {linkTo} from "./links_to.js";
import {isOn} from "./words.js";

const kMostSlots = 6;

/// "3 raw, 1 machined" for parts as the stream has them.
export const countsByKind = (parts, kinds) => {
  const counts = new Map();
  for (const [, kind] of parts) counts.set(kind, (counts.get(kind) ?? 0) + 1);
  return [...counts].map(([kind, count]) => count + " " + kinds[kind].name).join(", ");
};

export class Place {
  constructor(app, index) {
    const {plant, store} = app;
    Object.assign(this, {app, index, rank: store.rankOfLocation[index], location: plant.locations[index], dirty: true});
    const slots = Math.min(this.location.holds, kMostSlots);
    this.slots = Array.from({length: slots}, () => make("span", {class: "slot"}));
    this.text = make("span", {class: "soft"});
    this.sensors = this.location.sensors.map(({symbol}) => ({symbol, element: make("span", {class: "dot", "aria-hidden": "true"})}));
    this.element = make("section", {class: "place", "data-location": this.location.name},
      make("div", {class: "row"}, linkTo("location", this.location.name), this.sensors.map(({element}) => element)),
      make("div", {class: "slots", "aria-hidden": "true"}, this.slots), this.text, this.transfers());
  }

  transfers() {
    const texts = this.app.plant.transfers.flatMap(({name, from, to}) => [
      ...(to.location === this.index ? ["→ " + name] : []), ...(from.location === this.index ? [name + " →"] : [])]);
    return texts.length > 0 ? make("div", {class: "soft cut", title: texts.join(", ")}, texts.join(", ")) : null;
  }

  close() {}
  redraw() { this.dirty = true; }
  touchAll() { this.dirty = true; }
  touchSensors() { this.dirty = true; }
  touchParts() { this.dirty = true; }

  draw() {
    if (!this.dirty) return false;
    this.dirty = false;
    const {store, plant} = this.app;
    const parts = store.places[this.rank] ?? [];
    this.slots.forEach((slot, i) => {
      showKind(slot, plant.part_kinds, parts[i] ? parts[i][1] : null);
    });
    setText(this.text, parts.length === 0 ? "empty, holds " + this.location.holds
      : parts.length + " of " + this.location.holds + ": " + countsByKind(parts, plant.part_kinds));
    for (const {symbol, element} of this.sensors) {
      element.classList.toggle("on", isOn(plant.symbols[symbol], store.values[symbol]));
    }
    return false;
  }
}
