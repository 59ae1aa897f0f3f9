// Controls that act on the plant. Each shows its result, or what the server says against it, next to itself.
import {actText} from "./act_words.js";
import {button, make, select, setAttribute, setText} from "./dom.js";
import {instant} from "./words.js";

const kShown = 8000;  // ms; a result that is no error goes by itself

/// The place of a result; screen readers say it when it changes. It keeps the height of a line, so that no control moves; a
/// longer text covers what is below. A click removes it.
export const resultOutput = () => {
  const output = make("output", {class: "result", role: "status", onclick: () => output.replaceChildren()});
  return output;
};

/// Shows a text in the place of a result; an empty one removes what is there.
export const showResult = (output, text, isWrong = false) => {
  clearTimeout(output.timer);
  output.classList.toggle("wrong", isWrong);
  output.replaceChildren(...(text === "" ? [] : [make("span", {title: text}, text)]));
  if (!isWrong) output.timer = setTimeout(() => output.replaceChildren(), kShown);
};

/// Does `acts()` (one act, or a list) and shows the result in `result`. Returns whether it was done.
export const perform = async (app, result, acts) => {
  try {
    if (app.lost) throw new Error("there is no connection to the plant: nothing was done");
    const list = [acts()].flat();
    const {t} = await app.api.acts(...list);
    showResult(result, actText(list, (name) => app.names.symbol(name)) + " at " + instant(t));
    return true;
  } catch (error) {
    showResult(result, error.status === 401 ? app.deniedText : error.message, true);
    return false;
  }
};

/// Brings a control that acts up to date. What it does is shown as busy until the answer.
export const refreshAct = (app, element) => {
  setAttribute(element, "aria-busy", element.isBusy ? "true" : null);
  const isOff = app.lost || element.isBusy || !element.isPossible();
  if (element.tagName === "SELECT" || element.type === "range") element.disabled = isOff;
  else setAttribute(element, "aria-disabled", String(isOff));
};

/// All controls in the document that act: they rest while the connection to the plant is lost.
export const refreshActs = () => { for (const element of document.querySelectorAll(".acts-on-plant")) element.refresh(); };

/// Makes a button or <select> one that acts: it rests while the connection is lost, or `isPossible()` is false. Call `refresh()`
/// when that may have changed.
export const acting = (app, element, isPossible = () => true) => {
  element.classList.add("acts-on-plant");
  Object.assign(element, {isPossible, isBusy: false, refresh: () => refreshAct(app, element)});
  element.refresh();
  return element;
};

/// A button for something that ends in an act. It rests while that is under way, and keeps the focus.
export const actingButton = (app, label, run, attributes = {}, isPossible = undefined) => {
  const element = button(label, async () => {
    if (element.getAttribute("aria-disabled") === "true") return;
    element.isBusy = true;
    element.refresh();
    try {
      await run();
    } finally {
      element.isBusy = false;
      element.refresh();
    }
  }, attributes);
  return acting(app, element, isPossible);
};

/// A button for an act.
export const actButton = (app, result, label, acts, attributes = {}, isPossible = undefined) =>
  actingButton(app, label, () => perform(app, result, acts), attributes, isPossible);

/// Puts a device into one of its states.
export const stateControl = (app, index, result) => {
  const {name, states} = app.plant.devices[index];
  const choice = select("State for " + name, states.map((state) => [state, state]));
  return make("div", {class: "row controls"}, make("span", {class: "soft"}, "Put into state"), choice,
    actButton(app, result, "Set state", () => ({state: {[name]: choice.value}}), {}, () => app.may("devices", index)));
};

/// What the ordinary malfunctions do.
const kOrdinary = {
  stuck: "the device stays as it is, whatever is commanded", slow: "its moves take three times as long",
  "stuck on": "the PLC always sees it on", "stuck off": "the PLC always sees it off",
};

/// A button that starts or ends a malfunction; `update()` after each change. With a label it is a toggle, without one it
/// says what it does.
export const malfunctionButton = (app, result, name, label = null) => {
  const isActive = () => app.store.malfunctions.some(([active]) => active === name);
  const text = make("span", {}, label);
  const element = actButton(app, result, text, () => isActive() ? {stop: name} : {start: name},
    {class: label === null ? null : "toggle", title: kOrdinary[label], "data-malfunction": name});
  const update = () => {
    if (label !== null) return setAttribute(element, "aria-pressed", String(isActive()));
    setText(text, isActive() ? "Stop" : "Start");
    setAttribute(element, "aria-label", (isActive() ? "Stop " : "Start ") + name);
  };
  update();
  return {element, update};
};
