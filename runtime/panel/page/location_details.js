// The details of a track or place: its parts, what sees and moves them, and putting and taking by hand.
import {actButton, resultOutput} from "./acts.js";
import {make, select, table} from "./dom.js";
import {locationLink} from "./links_to.js";
import {symbolItem} from "./device_details.js";
import {length, speed} from "./words.js";

const kMostRows = 100;

const partRows = (app, location, rank) => {
  const {store, plant, clock} = app;
  if (location.kind === "place") return (store.places[rank] ?? []).map(([number, kind]) => [String(number), plant.part_kinds[kind].name]);
  return store.partsOn(rank, clock.now()).map(([number, kind, x, v]) => [String(number), plant.part_kinds[kind].name, length(x), speed(v)]);
};

const partTable = (pane, location, rank) => {
  const heads = location.kind === "track" ? ["Part", "Kind", "Front at", "Speed"] : ["Part", "Kind"];
  const element = make("div", {});
  let shown = null;
  pane.follow(() => {
    const rows = partRows(pane.app, location, rank).slice(0, kMostRows);
    const text = JSON.stringify(rows);
    if (text === shown) return;
    shown = text;
    element.replaceChildren(rows.length > 0 ? table("Parts", heads, rows) : make("p", {class: "soft"}, "no parts"));
  });
  return element;
};

const handControls = (app, location, result) => {
  if (!app.canAct) return null;
  const isTrack = location.kind === "track";
  const kinds = select("Kind of the part", app.plant.part_kinds.map(({name}) => [name, name]));
  const at = make("input", {type: "text", size: 7, "aria-label": "Position on the track", placeholder: "300 mm", autocomplete: "off"});
  const where = () => isTrack && at.value.trim() !== "" ? location.name + "@" + at.value.trim() : location.name;
  return make("div", {class: "row controls"}, kinds, isTrack ? at : null,
    actButton(app, result, "Put", () => ({put: {at: where(), kind: kinds.value}})),
    actButton(app, result, "Take", () => ({take: where()})));
};

export const fillLocation = (pane, index) => {
  const {app} = pane;
  const {plant, store} = app;
  const location = plant.locations[index];
  const result = resultOutput();
  const facts = location.kind === "track" ? "A track of " + length(location.length) : "A place for " + location.holds + " parts";
  pane.section("Parts", make("p", {class: "soft"}, facts), partTable(pane, location, store.rankOfLocation[index]),
    handControls(app, location, result));
  if (location.sensors.length > 0) {
    pane.section("Sensors", make("ul", {class: "plain"}, location.sensors.map(({symbol, at}) =>
      symbolItem(pane, symbol, at === undefined ? "" : "at " + length(at), result))));
  }
  const ends = (location.ends ?? []).map(({to}) => make("li", {}, "the end leads ", to === null ? "out" : ["to ", locationLink(app, to)]));
  const target = (to) => to.location === null ? "out" : locationLink(app, to.location);
  const transfers = plant.transfers.filter(({from, to}) => from.location === index || to.location === index)
    .map(({name, from, to}) => make("li", {}, make("a", {href: "#" + new URLSearchParams({why: name})}, name), ": ",
      locationLink(app, from.location), " → ", target(to)));
  if (ends.length + transfers.length > 0) pane.section("Where parts go", make("ul", {class: "plain"}, ends, transfers));
  pane.element.append(result);
};

