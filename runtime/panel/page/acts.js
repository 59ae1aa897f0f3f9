// Controls that act on the plant. Each shows its result, or what the server says against it, next to itself.
import {button, make, select, setAttribute, setText} from "./dom.js";
import {instant, readValue} from "./words.js";

/// Does `acts()` (one act, or a list) and shows the result in `result`. Returns whether it was done.
export const perform = async (app, result, acts, done = "done") => {
  result.className = "result";
  result.textContent = "...";
  try {
    const list = [acts()].flat();
    const {t} = await app.api.acts(...list);
    result.textContent = done + " at " + instant(t);
    return true;
  } catch (error) {
    result.classList.add("wrong");
    result.textContent = error.status === 401 ? app.deniedText : error.message;
    return false;
  }
};

/// The place of a result; screen readers say it when it changes.
export const resultOutput = () => make("output", {class: "result", role: "status"});

/// A button for an act. It rests while the act is under way, and keeps the focus.
export const actButton = (app, result, label, acts, attributes = {}) => {
  const element = button(label, async () => {
    if (element.getAttribute("aria-disabled") === "true") return;
    element.setAttribute("aria-disabled", "true");
    await perform(app, result, acts);
    element.setAttribute("aria-disabled", "false");
  }, attributes);
  return element;
};

/// A field for a value, with its buttons: [[label, (value) => act], ...].
const valueForm = (app, result, symbol, buttons) => {
  const input = make("input", {type: "text", size: 8, "aria-label": "Value for " + symbol.name, placeholder: symbol.type,
    inputmode: "decimal", autocomplete: "off"});
  return make("span", {class: "row"}, input, buttons.map(([label, act]) => actButton(app, result, label, () => {
    const {value, error} = readValue(input.value, symbol.type);
    if (error) throw new Error(error);
    return act(value);
  })));
};

const isSettable = (symbol) => symbol.direction === "event" ? symbol.driver === "none" : symbol.link === null;

/// Set, force and release of a symbol; nothing if the page may not act.
export const symbolControls = (app, index, result) => {
  if (!app.canAct) return null;
  const symbol = app.plant.symbols[index];
  const act = (key, value) => ({[key]: {[symbol.name]: value}});
  const release = actButton(app, result, "Release", () => ({release: [symbol.name]}), {class: "release"});
  const settable = isSettable(symbol);
  if (symbol.type !== "BOOL") {
    const buttons = [["Force", (value) => act("force", value)]];
    if (settable) buttons.unshift(["Set", (value) => act("set", value)]);
    return make("div", {class: "row controls"}, valueForm(app, result, symbol, buttons), release);
  }
  const pair = (key, label) => make("span", {class: "row", role: "group", "aria-label": label}, make("span", {class: "soft"}, label),
    actButton(app, result, "on", () => act(key, true), {"aria-label": label + " on"}),
    actButton(app, result, "off", () => act(key, false), {"aria-label": label + " off"}));
  return make("div", {class: "row controls"}, settable ? pair("set", "Set") : null, pair("force", "Force"), release);
};

/// Puts a device into one of its states.
export const stateControl = (app, index, result) => {
  if (!app.canAct) return null;
  const {name, states} = app.plant.devices[index];
  if (states.length === 0) return null;
  const choice = select("State for " + name, states.map((state) => [state, state]));
  return make("div", {class: "row controls"}, make("span", {class: "soft"}, "Put into state"), choice,
    actButton(app, result, "Set state", () => ({state: {[name]: choice.value}})));
};

/// A button that starts or ends a malfunction; `update()` after each change. With a label it is a toggle, without one it
/// says what it does.
export const malfunctionButton = (app, result, name, label = null) => {
  const isActive = () => app.store.malfunctions.some(([active]) => active === name);
  const text = make("span", {}, label);
  const element = actButton(app, result, text, () => isActive() ? {stop: name} : {start: name},
    {class: label === null ? null : "toggle", "data-malfunction": name});
  const update = () => {
    if (label !== null) return setAttribute(element, "aria-pressed", String(isActive()));
    setText(text, isActive() ? "Stop" : "Start");
    setAttribute(element, "aria-label", (isActive() ? "Stop " : "Start ") + name);
  };
  update();
  return {element, update};
};
