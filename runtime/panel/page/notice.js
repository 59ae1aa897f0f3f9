// The line under the bar that says what is wrong with the page itself: a lost connection, a restart, a missing token.
import {button, make} from "./dom.js";

const kAfterReload = "symplant notice";

export class Notice {
  /// `element` has the role alert.
  constructor(element) {
    this.element = element;
    const kept = sessionStorage.getItem(kAfterReload);
    sessionStorage.removeItem(kAfterReload);
    if (kept) this.show("restart", kept, true);
  }

  /// One line for each `kind`; an empty text removes it. `act` is { label, run }.
  show(kind, text, closes = false, act = null) {
    const shown = [...this.element.children].find((line) => line.dataset.kind === kind);
    if (shown?.dataset.text === text || (!shown && text === "")) return;
    shown?.remove();
    if (text === "") return;
    const line = make("div", {class: "row notice", "data-kind": kind, "data-text": text}, make("span", {class: "grow"}, text),
      act ? button(act.label, act.run) : null, closes ? button("✕", () => line.remove(), {class: "tiny", "aria-label": "Close this message"}) : null);
    this.element.append(line);
  }

  /// Loads the page again and shows a text then.
  static reload(text) {
    sessionStorage.setItem(kAfterReload, text);
    location.reload();
  }
}
