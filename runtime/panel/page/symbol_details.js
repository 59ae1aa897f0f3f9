// The details of a symbol.
import {button, make} from "./dom.js";
import {fillMalfunctions} from "./malfunction_section.js";
import {deviceLink, locationLink} from "./links_to.js";
import {lastFindings} from "./finding_list.js";
import {symbolControls} from "./operate.js";
import {SYMBOL} from "./store.js";
import {invertedMark} from "./symbol_marks.js";
import {length, value} from "./words.js";

/// What sets the value of a symbol, in words.
const driverText = ({direction, driver}) => direction === "operation" ? "the PLC"
  : {device: "its device", parts: "parts", follow: "a condition", signal: "a formula", none: "-"}[driver] ?? driver ?? "-";

/// What an operation drives, in words: "track CV1, EXLINE_MB_AGV", `-` for nothing.
const drivesText = ({drives}) => (drives ?? []).join(", ") || "-";

/// What sets an event, or what an operation drives.
export const driverOrDrivenText = (symbol) => symbol.direction === "operation" ? "drives " + drivesText(symbol) : driverText(symbol);

const typeText = (symbol) => symbol.type + (symbol.inverted ? ", inverted" : "");

const marks = (store, index) => [store.symbolFlags[index] & SYMBOL.forced ? "forced" : "",
  store.symbolFlags[index] & SYMBOL.malfunction ? "a malfunction decides its value" : ""].filter((text) => text).join("; ");

export const fillSymbol = (pane, index) => {
  const {app} = pane;
  const {plant, store} = app;
  const symbol = plant.symbols[index];
  const {result} = pane;
  pane.section("Value",
    make("p", {class: "big row"}, pane.live(() => value(store.values[index], symbol)), invertedMark(symbol)),
    make("p", {}, pane.since(() => store.symbolSince[index])),
    pane.live(() => marks(store, index), "p", {class: "condition"}),
    symbolControls(pane, index),
    make("p", {}, button("Show in chart", () => app.chart.addSymbol(index), {class: "small"})));
  const facts = [...(symbol.comment ? [["Comment", symbol.comment]] : []), ["Address", symbol.address ?? "-"], ["Type", typeText(symbol)],
    ["Direction", symbol.direction === "event" ? "event: the PLC reads it" : "operation: the PLC writes it"],
    ["Driven by", driverText(symbol)], ...(symbol.direction === "operation" ? [["Drives", drivesText(symbol)]] : []),
    ["Link", symbol.link === null ? "none" : plant.links[symbol.link].name],
    ["In the list", symbol.list]];
  if (symbol.device !== null) facts.push(["Device", deviceLink(app, symbol.device)]);
  plant.locations.forEach(({sensors}, location) => {
    for (const sensor of sensors) {
      if (sensor.symbol === index) facts.push(["Sensor", [locationLink(app, location), sensor.at === undefined ? "" : " at " + length(sensor.at)]]);
    }
  });
  pane.section("Facts", make("dl", {}, facts.map(([name, text]) => [make("dt", {}, name), make("dd", {}, text)])));
  const ordinary = symbol.direction === "event" && symbol.type === "BOOL" ? plant.ordinary?.event ?? [] : [];
  fillMalfunctions(pane, [...plant.malfunctions.filter(({symbols}) => symbols?.includes(index)).map(({name}) => [name, name]),
    ...ordinary.map((kind) => [symbol.name + " " + kind, kind])], result);
  pane.section("Last findings", lastFindings(pane, (of) => of === symbol.name));
};
