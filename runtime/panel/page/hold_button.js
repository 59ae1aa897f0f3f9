// A button that holds: what it switches is on while the mouse button, the finger or the key is down on it.
import {acting, refreshAct} from "./acts.js";
import {button, make, setAttribute, setText} from "./dom.js";

const kTap = 400;  // ms; a screen reader clicks without holding
const kStuck = "still pressed";
const kKeys = [" ", "Enter"];

/// All buttons that hold the thing of this name.
export const refreshHolds = (name) => {
  for (const element of document.querySelectorAll(".hold")) if (element.holdName() === name) element.refresh();
};

/// `name()` is what it holds; `isPossible()`: whether it may be held now; `acts()` gives { on, off } when the button goes down; `label()` is its text. `refresh()` when that may
/// have changed.
export const holdButton = (app, {name, acts, label, result, isPossible = undefined}, attributes = {}) => {
  const text = make("span", {});
  const spoken = attributes["aria-label"];
  const begin = (by) => {
    if (element.getAttribute("aria-disabled") !== "true") app.holds.begin({name: name(), result, ...acts()}, by);
  };
  const tap = ({detail}) => {
    if (detail > 0 || app.holds.phase(name()) !== "") return;
    begin("tap " + name());
    setTimeout(() => app.holds.endBy("tap " + name()), kTap);
  };
  const element = acting(app, button(text, tap, {...attributes, class: "hold " + (attributes.class ?? "")}), isPossible);
  const listeners = {
    pointerdown: (event) => {
      if (event.button !== 0) return;
      if (element.hasPointerCapture(event.pointerId)) element.releasePointerCapture(event.pointerId);  // a finger can leave, too
      begin("pointer " + event.pointerId);
    },
    pointerleave: ({pointerId}) => app.holds.endBy("pointer " + pointerId),
    keydown: (event) => {
      if (!kKeys.includes(event.key)) return;
      event.preventDefault();
      if (!event.repeat) begin("key " + event.code);
    },
    keyup: (event) => { if (kKeys.includes(event.key)) event.preventDefault(); },
    blur: () => app.holds.end(name()),
    contextmenu: (event) => event.preventDefault(),
  };
  for (const [type, listener] of Object.entries(listeners)) element.addEventListener(type, listener);
  element.holdName = name;
  element.refresh = () => {
    const phase = app.holds.phase(name());
    refreshAct(app, element);
    setText(text, phase === "stuck" ? kStuck : label());
    if (spoken) setAttribute(element, "aria-label", phase === "stuck" ? kStuck + ", " + name() : spoken);
    element.classList.toggle("is-stuck", phase === "stuck");
    setAttribute(element, "aria-pressed", String(phase === "pressing" || phase === "held"));
    setAttribute(element, "aria-busy", phase === "pressing" || phase === "releasing" || phase === "stuck" ? "true" : null);
  };
  element.refresh();
  return element;
};
