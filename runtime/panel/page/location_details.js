// The details of a track or place: its parts, what sees and moves them, and putting and taking by hand.
import {actButton} from "./acts.js";
import {make, select, setText, table} from "./dom.js";
import {locationLink} from "./links_to.js";
import {symbolItem} from "./device_details.js";
import {operates} from "./rights.js";
import {driveText} from "./drive_words.js";
import {kindChip} from "./kinds.js";
import {length, speed} from "./words.js";

const kMostRows = 100;

/// Parts as [number, kind, x, v] from the front; those in a place have no x and v.
const partsAt = (app, location, rank) => location.kind === "track" ? app.store.partsOn(rank, app.clock.now()) : app.store.places[rank] ?? [];

/// A row of the table of parts; it stays while the part is there, so that its button can be pressed while the part moves.
const partRow = (app, location, rank, hand, number) => {
  const isTrack = location.kind === "track";
  const isExact = app.plant.mode !== "recording";
  const cells = Array.from({length: !isTrack ? 1 : isExact ? 3 : 2}, () => make("td", {}));
  // A track gives the part that covers a position: the middle of this one when the button is pressed.
  const where = () => {
    const [, kind, x] = partsAt(app, location, rank).find((part) => part[0] === number) ?? [];
    if (kind === undefined) throw new Error("part " + number + " is not there any more");
    return location.name + "@" + Math.round(x - app.plant.part_kinds[kind].length / 2) + " um";
  };
  const acts = hand && isTrack ? make("td", {}, make("span", {class: "row"},
    hand.button("Take", () => ({take: where()}), {class: "small", "aria-label": "Take part " + number}), " ",
    hand.button("Change", () => hand.change(where()), {class: "small", "aria-label": "Change the kind of part " + number}))) : null;
  const element = make("tr", {}, make("th", {scope: "row"}, String(number)), cells, acts);
  let shownKind = null;
  return {element, update: ([, kind, x, v]) => {
    if (shownKind !== kind) cells[0].replaceChildren(kindChip(app.plant.part_kinds, kind));
    shownKind = kind;
    if (!isTrack) return;
    setText(cells[1], length(x));
    if (isExact) setText(cells[2], speed(v));
  }};
};

const partTable = (pane, location, rank, hand) => {
  const {app} = pane;
  const places = app.plant.mode === "recording" ? ["Front, estimated"] : ["Front at", "Speed"];
  const heads = location.kind === "track" ? ["Part", "Kind", ...places, ...(hand ? ["Act"] : [])] : ["Part", "Kind"];
  const element = table("Parts", heads, []);
  const body = element.tBodies[0];
  const none = make("p", {class: "soft"}, "no parts");
  const rows = new Map();
  pane.follow(() => {
    const parts = partsAt(app, location, rank).slice(0, kMostRows);
    const order = parts.map(([number]) => number);
    if (order.join() !== [...rows.keys()].join()) {
      const kept = new Map(rows);
      rows.clear();
      for (const number of order) rows.set(number, kept.get(number) ?? partRow(app, location, rank, hand, number));
      for (const [number, {element: row}] of kept) if (!rows.has(number)) row.remove();
      [...rows.values()].forEach(({element: row}, i) => { if (body.children[i] !== row) body.insertBefore(row, body.children[i] ?? null); });
    }
    for (const part of parts) rows.get(part[0]).update(part);
    element.hidden = parts.length === 0;
    none.hidden = parts.length > 0;
  });
  return [element, none];
};

/// What a hand can do with the parts of a location; null if the page may not act. `change` replaces the part at a location by
/// one of the chosen kind, in one instant.
const handOn = (app, location, result) => {
  if (!operates(app)) return null;
  const isTrack = location.kind === "track";
  const kinds = select("Kind of the part", app.plant.part_kinds.map(({name}) => [name, name]));
  const at = make("input", {type: "text", size: 7, "aria-label": "Position on the track", placeholder: "300 mm", autocomplete: "off"});
  const where = () => isTrack && at.value.trim() !== "" ? location.name + "@" + at.value.trim() : location.name;
  const put = (to) => ({put: {at: to, kind: kinds.value}});
  const change = (from) => [{take: from}, put(from)];
  const may = () => app.may("locations", app.names.index("location", location.name));
  const button = (label, acts, attributes) => actButton(app, result, label, acts, attributes, may);
  const controls = make("div", {class: "row controls"}, kinds, isTrack ? at : null, button("Put", () => put(where())),
    button(isTrack ? "Take at" : "Take", () => ({take: where()})), isTrack ? null : button("Change", () => change(where()), {"aria-label": "Change the kind"}));
  return {controls, change, button};
};

/// The drives of a track with their speeds. A recording does not know them.
const fillDrives = (pane, {kind, drives}, rank) => {
  const {store, plant} = pane.app;
  if (kind !== "track" || plant.mode === "recording") return;
  pane.section("Drives", make("ul", {class: "plain"}, drives.map(({from, until}, drive) => make("li", {}, length(from) + " to " + length(until) + ": ",
    pane.live(() => driveText(store.tracks[rank]?.drives[drive] ?? 0), "strong")))));
};

export const fillLocation = (pane, index) => {
  const {app} = pane;
  const {plant, store} = app;
  const location = plant.locations[index];
  const {result} = pane;
  const hand = handOn(app, location, result);
  const facts = location.kind === "track" ? "A track of " + length(location.length) : "A place for " + location.holds + " parts";
  pane.section("Parts", make("p", {class: "soft"}, facts), partTable(pane, location, store.rankOfLocation[index], hand),
    hand?.controls);
  if (location.sensors.length > 0) {
    pane.section("Sensors", make("ul", {class: "plain"}, location.sensors.map(({symbol, at}) =>
      symbolItem(pane, symbol, at === undefined ? "" : "at " + length(at)))));
  }
  fillDrives(pane, location, store.rankOfLocation[index]);
  const ends = (location.ends ?? []).map(({to}) => make("li", {}, "the end leads ", to === null ? "out" : ["to ", locationLink(app, to)]));
  const target = (to) => to.location === null ? "out" : locationLink(app, to.location);
  const transfers = plant.transfers.filter(({from, to}) => from.location === index || to.location === index)
    .map(({name, from, to}) => make("li", {}, make("a", {href: "#" + new URLSearchParams({why: name})}, name), ": ",
      locationLink(app, from.location), " → ", target(to)));
  if (ends.length + transfers.length > 0) pane.section("Where parts go", make("ul", {class: "plain"}, ends, transfers));
};

