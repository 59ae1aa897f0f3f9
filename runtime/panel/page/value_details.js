// The details of a value, and values in the details of a device.
import {button, make} from "./dom.js";
import {deviceLink, linkTo} from "./links_to.js";
import {lastFindings} from "./finding_list.js";
import {fillMalfunctions} from "./malfunction_section.js";
import {operates} from "./rights.js";
import {VALUE} from "./store.js";
import {valueControl, valueDisplay} from "./value_control.js";
import {formulaText, rangeText, shortName} from "./value_words.js";
import {duration} from "./words.js";

const display = (pane, index) => {
  const shown = valueDisplay(pane.app, () => index);
  pane.follow(shown.update);
  return shown;
};

const control = (pane, index) => {
  if (!operates(pane.app) || !pane.app.plant.values[index].settable) return null;
  const made = valueControl(pane.app, () => index, pane.result);
  pane.follow(made.update);
  return made.element;
};

export const fillValue = (pane, index) => {
  const {app} = pane;
  const {plant, store} = app;
  const value = plant.values[index];
  const {text, bar, mark} = display(pane, index);
  pane.section("Number", make("p", {class: "big row"}, text, mark), bar,
    pane.live(() => store.valueFlags[index] & VALUE.held ? "a malfunction holds it; what is set counts when it ends" : "", "p", {class: "condition"}),
    control(pane, index),
    value.trace === null ? make("p", {class: "soft"}, "Its `trace` is false: charts do not have it.")
      : make("p", {}, button("Show in chart", () => app.chart.addValue(index), {class: "small"})));
  const facts = [["Kind", value.kind], ["Formula", formulaText(value) || "-"], ["Range", rangeText(value)], ["Unit", value.unit || "-"],
    ["In traces", value.trace === null ? "never" : "each " + duration(value.trace)]];
  if (value.device !== null) facts.push(["Device", deviceLink(app, value.device)]);
  pane.section("Facts", make("dl", {}, facts.map(([name, of]) => [make("dt", {}, name), make("dd", {}, of)])));
  fillMalfunctions(pane, plant.malfunctions.filter(({values}) => values?.includes(index)).map(({name}) => [name, name]), pane.result);
  pane.section("Last findings", lastFindings(pane, (of) => of === value.name));
};

/// The values of a device, each with its number, bar and controls. Returns the section; null if it has none.
export const fillValuesOf = (pane, device) => {
  const {app} = pane;
  const indexes = app.store.valuesOf(device);
  if (indexes.length === 0) return null;
  return pane.section("Values", make("ul", {class: "plain"}, indexes.map((index) => {
    const value = app.plant.values[index];
    const {text, bar, mark} = display(pane, index);
    return make("li", {class: "symbol-item"}, make("div", {class: "row"}, linkTo("value", value.name, shortName(value, app.plant.devices[device])),
      text, mark, bar), control(pane, index));
  })));
};
