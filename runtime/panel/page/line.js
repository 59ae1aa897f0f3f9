// The line view: stations with their devices, tracks and places. A large plant shows its stations as small tiles first.
import {make, select} from "./dom.js";
import {groupDevices, operatedSymbols, stationsOf} from "./layout.js";
import {stationAddress} from "./links_to.js";
import {Material} from "./material.js";
import {OperatorPanel} from "./operator_panel.js";
import {Overview} from "./overview.js";
import {STATUSES} from "./status.js";
import {TileGrid} from "./tile_grid.js";
import {count} from "./words.js";

const kMostAtOnce = 120;  // devices; more are shown as an overview
const kNoStation = "no station";
const kMostFirst = 6;
const kMostColumns = 6;  // of a station next to others

/// Of the frame of a station next to others, in pixels; as in panel.css.
const frameWidth = (views) => {
  const columns = Math.max(Math.min(views.length, kMostColumns), ...views.map((view) => view ? Math.ceil(view.x) + 1 : 1));
  return columns * 184 - 8 + 24;
};

const legend = () => make("details", {class: "legend"}, make("summary", {}, "Legend"),
  make("ul", {}, STATUSES.map(({key, letter, text}) =>
    make("li", {}, make("span", {class: "letter s-" + key, "aria-hidden": "true"}, letter), " ", text))),
  make("p", {class: "soft"}, "▸ an operation that is on, ■ □ events that are on and off, F a forced symbol. On a track: ▼ sensors, ",
    "bars across the belt are stops, filled if they hold; triangles below are transfers; circles below are drives, filled while they run."));

export class LineView {
  constructor(app) {
    this.app = app;
    this.title = "Line";
    this.groups = groupDevices(app.plant);
    this.operated = operatedSymbols(app.plant);
    if (this.operated.has(null) && !this.groups.some(({station}) => station === null)) this.groups.push({station: null, devices: []});
    this.locationStations = app.plant.locations.map((location) => stationsOf(location, app.plant));
    this.content = make("div", {class: "line"});
    this.tools = make("div", {class: "row tools"});
    this.element = make("div", {class: "view line-view"}, this.tools, this.content, legend());
    this.parts = [];
    this.shown = null;
  }

  nameOf({station}) { return station === null ? kNoStation : this.app.plant.stations[station].name || kNoStation; }
  isLarge() { return this.app.plant.devices.length > kMostAtOnce && this.groups.length > 1; }

  show({station = ""}) {
    if (this.shown !== station) this.build(station);
    else this.touchAll();
    this.parts.forEach((part) => part.selected?.());
    this.app.frames.request();
  }

  build(station) {
    this.parts.forEach((part) => part.close());
    this.shown = station;
    const one = this.groups.find((group) => this.nameOf(group) === station);
    this.tools.replaceChildren(...this.makeTools(station, one).filter((tool) => tool !== null));
    this.parts = one ? this.makeStation(one) : this.makeAll();
    const frames = this.parts.filter((part) => part.frame).map((part) => part.frame);
    const others = this.parts.filter((part) => !part.frame).map((part) => part.element);
    const ordered = [...others, make("div", {class: "frames"}, frames)];
    this.content.replaceChildren(...(this.materialFirst(one) ? ordered : ordered.reverse()));
    this.app.main.scrollTop = 0;
  }

  makeTools(station, one) {
    const {plant} = this.app;
    const {trackLocations, placeLocations} = this.app.store;
    const summary = [[plant.devices, "device"], [plant.symbols, "symbol"], [trackLocations, "track"], [placeLocations, "place"]]
      .filter(([list]) => list.length > 0).map(([list, noun]) => count(list.length, noun)).join(", ");
    if (this.groups.length < 2) return [make("span", {class: "soft"}, summary)];
    const choice = select("Station", [["", "All stations"], ...this.groups.map((group) => [this.nameOf(group), this.nameOf(group)])],
      {onchange: () => this.app.router.view("line", choice.value ? {station: choice.value} : {})});
    choice.value = one ? station : "";
    if (!one) return [choice, make("span", {class: "soft"}, summary)];
    const at = this.groups.indexOf(one);
    const step = (by, text) => {
      const group = this.groups[at + by];
      return group ? make("a", {href: stationAddress(this.nameOf(group)), class: "step"}, text) : null;
    };
    return [make("a", {href: "#view=line", class: "step"}, "← All stations"), choice, step(-1, "Previous"), step(1, "Next"),
      make("span", {class: "soft"}, count(one.devices.length, "device"))];
  }

  /// The devices of a group, and its buttons, selectors and lamps.
  makeGroup(group, link) {
    const symbols = this.operated.get(group.station) ?? [];
    const name = group.station === null ? "" : " of " + this.nameOf(group);
    return [...(group.devices.length > 0 ? [this.makeFrame(group, link)] : []),
      ...(symbols.length > 0 ? [new OperatorPanel(this.app, symbols, "Operator panel" + name)] : [])];
  }

  makeFrame(group, link) {
    const name = this.nameOf(group);
    const grid = new TileGrid(this.app, group.devices, "Devices of " + name, this.app.main);
    grid.frame = make("section", {class: "frame", "aria-label": "Station " + name},
      make("h2", {tabindex: link ? null : -1}, link ? make("a", {href: stationAddress(name)}, name) : name), grid.element);
    if (link) grid.frame.style.width = frameWidth(group.devices.map((device) => this.app.plant.devices[device].view)) + "px";
    else grid.frame.classList.add("whole");
    return grid;
  }

  makeStation(group) {
    const locations = this.locationStations.flatMap((stations, index) => stations.includes(group.station) ? [index] : []);
    return [...(locations.length > 0 ? [new Material(this.app, locations, false)] : []), ...this.makeGroup(group, false)];
  }

  /// A few tracks come before the stations, many after them.
  materialFirst(one) { return Boolean(one) || this.app.plant.locations.length <= kMostFirst; }

  makeAll() {
    const {plant} = this.app;
    const material = plant.locations.length > 0 ? [new Material(this.app, [...plant.locations.keys()], this.isLarge())] : [];
    if (!this.isLarge()) return [...material, ...this.groups.flatMap((group) => this.makeGroup(group, this.groups.length > 1))];
    const overview = new Overview(this.app, this.groups, (station) => this.nameOf({station}));
    overview.frame = overview.element;
    return [...material, overview];
  }

  touchAll() {
    for (const part of this.parts) {
      part.touchAll?.();
      part.change?.({all: true, tracks: [], places: [], symbols: []});
    }
  }

  /// `statusChanged` is a set of devices.
  change(change, statusChanged) {
    const {symbols, values} = this.app.plant;
    for (const part of this.parts) {
      part.change?.(change);
      if (!part.touch) continue;
      if (change.all) {
        part.touchAll();
        continue;
      }
      for (const device of statusChanged) part.touch(device);
      if (part instanceof Overview) continue;
      for (const device of change.devices) part.touch(device);
      for (const symbol of change.symbols) if (symbols[symbol].device !== null) part.touch(symbols[symbol].device);
      for (const value of change.values) if (values[value].device !== null) part.touchValues?.(values[value].device);
    }
    this.app.frames.request();
  }

  selectionChanged() { this.parts.forEach((part) => part.selected?.()); }

  /// Returns whether something moves on.
  frame(now) {
    let again = false;
    let late = false;
    for (const part of this.parts) {
      if (part instanceof Overview) late = part.draw(now) || late;
      else again = part.draw(now) || again;
    }
    return late || (again && this.app.clock.runs);
  }
}
