// The controls of a symbol in a faceplate: jog, press, on, off, a set point, and force.
import {actButton} from "./acts.js";
import {make, setAttribute} from "./dom.js";
import {holdButton} from "./hold_button.js";
import {isSettable, setAct, writerText} from "./person.js";
import {operates} from "./rights.js";
import {setPoint} from "./set_point.js";
import {isOn, levels} from "./words.js";

const label = (text) => make("span", {class: "soft"}, text);

/// A button that holds a BOOL symbol on.
export const symbolHold = (app, index, result, attributes = {}) => {
  const symbol = app.plant.symbols[index];
  const isEvent = symbol.direction === "event";
  return holdButton(app, {name: () => symbol.name, label: () => isEvent ? "Press" : "Jog", result,
    acts: () => ({on: setAct(symbol, true), off: setAct(symbol, false)}), isPossible: () => app.may("symbols", index)},
  {title: "On while the mouse button or the key is down", "aria-label": null, ...attributes});
};

/// On and off, of which the present one is marked. `update()` after each change.
export const symbolSwitch = (app, index, result) => {
  const symbol = app.plant.symbols[index];
  const buttons = [true, false].map((on) => actButton(app, result, on ? "on" : "off", () => setAct(symbol, on), {"aria-label": "Set " + (on ? "on" : "off"), class: "state-button"},
    () => app.may("symbols", index)));
  const update = () => {
    const on = isOn(symbol, app.store.values[index]);
    buttons.forEach((element, i) => setAttribute(element, "aria-pressed", String(on === (i === 0))));
  };
  return {element: make("span", {class: "row", role: "group", "aria-label": "Set " + symbol.name}, label("Set"), buttons), update};
};

const releaseButton = (app, symbol, result) => actButton(app, result, "Release", () => ({release: [symbol.name]}), {class: "release"});

/// Force of a BOOL symbol on and off, as its meaning, and its release.
const forceButtons = (app, symbol, result) => make("span", {class: "row force", role: "group", "aria-label": "Force " + symbol.name}, label("Force"),
  levels(symbol).map(([text, bit]) => actButton(app, result, text, () => ({force: {[symbol.name]: bit}}), {"aria-label": "Force " + text})),
  releaseButton(app, symbol, result));

/// All controls of a symbol; nothing if the page may not operate it. Of one that something else writes, and without `sets`, only force, by a trainer.
export const symbolControls = (pane, index, sets = true) => {
  const {app, result} = pane;
  const symbol = app.plant.symbols[index];
  const settable = sets && isSettable(app.plant, symbol);
  if (!app.canAct && !(settable && operates(app))) return null;
  const writer = writerText(app.plant, symbol);
  if (symbol.type !== "BOOL") {
    const {element, force, update} = setPoint(app, index, result, settable);
    pane.follow(update);
    return make("div", {class: "row controls"}, writer ? label(writer) : null, element, app.canAct ? make("span", {class: "row force"}, force, releaseButton(app, symbol, result)) : null);
  }
  const set = settable ? symbolSwitch(app, index, result) : null;
  if (set) pane.follow(set.update);
  return make("div", {class: "row controls"}, settable ? symbolHold(app, index, result) : null, set?.element, writer ? label(writer) : null,
    app.canAct ? forceButtons(app, symbol, result) : null);
};
