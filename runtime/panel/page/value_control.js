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
    const known = isKnown(app.plant, value);
    setText(text, known ? withUnit(number, value) : "-");
    setAttribute(text, "title", known ? String(number) : null);
    bar.classList.toggle("without", !known || !hasRange(value));
    if (hasRange(value)) fill.style.transform = "scaleX(" + partOf(value, number).toFixed(4) + ")";
    mark.hidden = (valueFlags[index()] & VALUE.held) === 0;
  };
  return {text, bar, mark, update};
};

/// A slider and a field for a number, if an act can set the value `index()`; `update()` after each change, and when `index()` is
/// another one. A slider sets the value when it is let go; until then it does not follow the plant.
export const valueControl = (app, index, result) => {
  const value = () => app.plant.values[index()];
  const set = (number) => ({set: {[value().name]: number}});
  let dragged = false;
  const may = () => app.may("values", index());
  const slider = acting(app, make("input", {type: "range"}), may);
  const input = make("input", {type: "text", size: 7, inputmode: "decimal", autocomplete: "off"});
  const read = () => {
    const {value: number, error} = readValue(input.value, "LREAL");
    if (error) throw new Error(error);
    if (typeof number !== "number") throw new Error("`" + input.value + "` is not a number");
    return set(number);
  };
  const button = actButton(app, result, "Set", read, {class: "small"}, may);
  const element = make("span", {class: "row value-control"}, slider, input, button);
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
    await perform(app, result, () => set(Number(slider.value)));
    isSetting = false;
    letGo();
  });
  slider.addEventListener("pointerup", () => setTimeout(() => {  // a drag back to where it began is no change
    if (dragged && !isSetting) letGo();
  }));
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") button.click();
    if (event.key !== "Escape") return;
    input.value = "";
    event.stopPropagation();
  });
  let shown = -1;
  const showValue = () => {
    const {name, min, max, settable, unit} = value();
    shown = index();
    dragged = false;
    element.hidden = !settable;
    slider.hidden = !hasRange(value());
    if (!slider.hidden) Object.assign(slider, {min, max, step: sliderStep(value())});
    input.value = "";
    setAttribute(slider, "aria-label", name);
    setAttribute(input, "aria-label", "Number for " + name);
    setAttribute(input, "placeholder", unit || "number");
    setAttribute(button, "aria-label", "Set " + name);
    for (const each of [slider, button]) each.refresh();
  };
  const update = () => {
    if (shown !== index()) showValue();
    if (slider.hidden || dragged) return;
    slider.value = app.store.numbers[index()];
    setAttribute(slider, "aria-valuetext", withUnit(app.store.numbers[index()], value()));
  };
  return {element, update};
};
