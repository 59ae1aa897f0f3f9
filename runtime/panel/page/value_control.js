// The controls of a value: its number with a bar, and a slider and a field that set it.
import {actButton, acting, perform} from "./acts.js";
import {make, setAttribute, setText} from "./dom.js";
import {VALUE} from "./store.js";
import {readValue} from "./words.js";
import {hasRange, isKnown, partOf, sliderStep, withUnit} from "./value_words.js";

const kHeld = "a malfunction holds it";

/// The number of the value `index()` with its unit, a bar between its limits, and a mark; `update()` after each change.
export const valueDisplay = (app, index) => {
  const text = make("span", {class: "number"});
  const fill = make("span", {class: "fill"});
  const bar = make("span", {class: "range", "aria-hidden": "true"}, fill);
  const mark = make("span", {class: "letter s-malfunction", title: kHeld, hidden: true}, make("span", {"aria-hidden": "true"}, "M"),
    make("span", {class: "hidden-text"}, kHeld));
  const update = () => {
    const {numbers, valueFlags} = app.store;
    const value = app.plant.values[index()];
    const number = numbers[index()];
    const known = isKnown(app.plant, value) && !Number.isNaN(number);
    setText(text, known ? withUnit(number, value) : "-");
    setAttribute(text, "title", known ? String(number) : null);
    bar.classList.toggle("without", !known || !hasRange(value));
    if (hasRange(value)) fill.style.transform = "scaleX(" + partOf(value, number).toFixed(4) + ")";
    mark.hidden = (valueFlags[index()] & VALUE.held) === 0;
  };
  return {text, bar, mark, update};
};

/// A slider and a field for the number of `source`: its `key()`, `name()`, `unit()`, `isSettable()`, `may()`, `range()` ({ min, max, step }, or null
/// for no slider), `number()`, `text()`, `read(text)` and `set(number)`, an act. `update()` after each change, and when `key()` is another
/// one. A slider sets the number when it is let go; until then it does not follow the plant. Without `sets` it has the field only.
export const numberControl = (app, source, result, sets = true) => {
  let dragged = false;
  const slider = acting(app, make("input", {type: "range"}), source.may);
  const input = make("input", {type: "text", size: 7, inputmode: "decimal", autocomplete: "off"});
  const button = actButton(app, result, "Set", () => source.set(source.read(input.value)), {class: "small"}, source.may);
  const element = make("span", {class: "row value-control"}, slider, input, sets ? button : null);
  slider.addEventListener("input", () => {
    dragged = true;
    input.value = slider.value;
  });
  const letGo = () => {
    dragged = false;
    input.value = "";
    update();
  };
  let isSetting = false;
  slider.addEventListener("change", async () => {
    isSetting = true;
    await perform(app, result, () => source.set(Number(slider.value)));
    isSetting = false;
    letGo();
  });
  slider.addEventListener("pointerup", () => setTimeout(() => {  // a drag back to where it began is no change
    if (dragged && !isSetting) letGo();
  }));
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && sets) button.click();
    if (event.key !== "Escape") return;
    input.value = "";
    event.stopPropagation();
  });
  let shown = -1;
  const showSource = () => {
    shown = source.key();
    dragged = false;
    element.hidden = !source.isSettable();
    input.value = "";
    setAttribute(slider, "aria-label", source.name());
    setAttribute(input, "aria-label", "Number for " + source.name());
    setAttribute(input, "placeholder", source.unit() || "number");
    setAttribute(button, "aria-label", "Set " + source.name());
    for (const each of [slider, button]) each.refresh();
  };
  const update = () => {
    if (shown !== source.key()) showSource();
    if (dragged) return;
    const range = source.range();
    slider.hidden = range === null;
    if (range === null) return;
    for (const [name, limit] of Object.entries(range)) setAttribute(slider, name, String(limit));
    slider.value = source.number();
    setAttribute(slider, "aria-valuetext", source.text());
  };
  return {element, input, update};
};

const readNumber = (text) => {
  const {value: number, error} = readValue(text, "LREAL");
  if (error) throw new Error(error);
  if (typeof number !== "number") throw new Error("`" + text + "` is not a number");
  return number;
};

/// numberControl() of the value `index()`, if an act can set it.
export const valueControl = (app, index, result) => {
  const value = () => app.plant.values[index()];
  const number = () => app.store.numbers[index()];
  return numberControl(app, {key: index, name: () => value().name, unit: () => value().unit, isSettable: () => value().settable, may: () => app.may("values", index()), number,
    range: () => hasRange(value()) ? {min: value().min, max: value().max, step: sliderStep(value())} : null,
    text: () => withUnit(number(), value()), read: readNumber, set: (to) => ({set: {[value().name]: to}})}, result);
};
