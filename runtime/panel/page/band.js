// The band across the page while plant time does not pass: frozen, ended, or no connection. A frozen plant can be run again from it.
import {actButton} from "./acts.js";
import {make, setAttribute, setText} from "./dom.js";
import {clockText} from "./words.js";

/// The words of the band; "" while plant time passes.
export const bandText = (state, lost, time) => {
  if (lost) return "NO CONNECTION, the state of " + time;
  return state === "frozen" ? "FROZEN at " + time : state === "ended" ? "ENDED at " + time : "";
};

export class Band {
  /// `result` shows what came of the act.
  constructor(app, result) {
    this.app = app;
    this.text = make("strong", {role: "status"});
    const mayRun = app.canAct;
    this.run = mayRun ? actButton(app, result, "Run", () => ({run: true}), {class: "small", "aria-label": "Run the plant"}) : null;
    this.element = make("section", {class: "band", "aria-label": "State of the plant", hidden: true}, this.text, this.run);
  }

  update() {
    const {store, lost} = this.app;
    const {state} = store.clock;
    const text = bandText(state, lost, clockText(store.t));
    this.element.hidden = text === "";
    setText(this.text, text);
    setAttribute(this.element, "data-state", lost ? "lost" : state);
    if (this.run) this.run.hidden = lost || state !== "frozen";
  }

  change() { this.update(); }
}
