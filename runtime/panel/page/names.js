// Finds what a name, a comment, or a part of them means.
import {deviceComment} from "./comments.js";

const kKinds = ["device", "symbol", "location", "requirement", "value"];

/// The symbols in no device, by the device with the longest name with which theirs begin.
const looseSymbols = (plant, devices) => {
  const found = new Map();
  plant.symbols.forEach(({name, device}, symbol) => {
    if (device !== null) return;
    const ends = [...name.matchAll(/[_.]/g)].map(({index}) => index).reverse();
    const end = ends.find((at) => devices.has(name.slice(0, at)));
    if (end === undefined) return;
    const of = devices.get(name.slice(0, end));
    if (found.has(of)) found.get(of).push(symbol);
    else found.set(of, [symbol]);
  });
  return found;
};

export class Names {
  constructor(plant) {
    this.plant = plant;
    this.comments = new Map();  // of devices, once they are searched
    this.lists = {device: plant.devices, symbol: plant.symbols, location: plant.locations, requirement: plant.requirements, value: plant.values ?? []};
    this.indexes = Object.fromEntries(kKinds.map((kind) =>
      [kind, new Map(this.lists[kind].map(({name}, index) => [name, index]))]));
    this.stationIndexes = new Map(plant.stations.map(({name}, index) => [name, index]));
  }

  /// null if there is none.
  index(kind, name) { return this.indexes[kind]?.get(name) ?? null; }
  /// The symbol of this name; null if there is none.
  symbol(name) { return this.plant.symbols[this.index("symbol", name)] ?? null; }
  station(name) { return this.stationIndexes.get(name) ?? null; }
  name(kind, index) { return this.lists[kind][index]?.name ?? "?"; }

  /// { kind, index } of a name that may be of any kind, or null.
  find(name) {
    for (const kind of kKinds) {
      const index = this.index(kind, name);
      if (index !== null) return {kind, index};
    }
    return null;
  }

  /// The symbols that are in no device, but whose names begin with that of the device.
  looseSymbolsOf(device) {
    this.loose ??= looseSymbols(this.plant, this.indexes.device);
    return this.loose.get(device) ?? [];
  }

  /// The comment of a device.
  commentOf(device) {
    if (!this.comments.has(device)) this.comments.set(device, deviceComment(this.plant, device));
    return this.comments.get(device);
  }

  /// At most `most` of what contains all words of the text and `accepts(kind, index)`, whole levels of names first, as
  /// { kind, name, more }.
  search(text, most, accepts = () => true) {
    const words = text.toLowerCase().split(/\s+/).filter((word) => word !== "");
    if (words.length === 0) return [];
    const found = [];
    const add = (kind, list, moreOf = () => "") => list.forEach((thing, index) => {
      const {name} = thing;
      const more = moreOf(thing);
      const all = (name + " " + more).toLowerCase();
      if (words.every((word) => all.includes(word)) && accepts(kind, index)) found.push({kind, name, more});
    });
    add("station", this.plant.stations);
    add("device", this.plant.devices, (device) => this.commentOf(device));
    add("location", this.plant.locations, ({kind}) => kind);
    add("symbol", this.plant.symbols, ({address, comment}) => [address, comment].filter((text) => text).join(", "));
    add("requirement", this.plant.requirements);
    add("value", this.lists.value, ({unit}) => unit);
    const begins = ({name}) => name.toLowerCase().split(/[_. ]/).includes(words[0]) ? 0 : 1;
    return found.sort((a, b) => begins(a) - begins(b)).slice(0, most);
  }
}
