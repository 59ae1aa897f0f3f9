// Keys of the page, and the help that lists them. Keys of one letter can be switched off.
import {button, make, table} from "./dom.js";
import {kChartKeys} from "./chart_input.js";
import {kPlanKeys} from "./plan/input.js";
import {kView3dKeys} from "./view3d/keys.js";

const kOffKey = "symplant keys off";

const isTyping = ({target}) => target.closest?.("input, select, textarea, dialog, [contenteditable]");

export class Shortcuts {
  /// `keys` are [key, text, act].
  constructor(keys) {
    this.keys = keys;
    this.off = localStorage.getItem(kOffKey) === "1";
    document.addEventListener("keydown", (event) => this.key(event));
  }

  key(event) {
    if (event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === "?" && !isTyping(event)) return this.help();
    if (event.key !== "Escape" && (this.off || isTyping(event))) return;
    const found = this.keys.find(([key]) => key === event.key);
    if (!found || document.querySelector("dialog[open]")) return;
    event.preventDefault();
    found[2]();
  }

  help() {
    if (document.querySelector("dialog[open]")) return;
    const dialog = make("dialog", {"aria-labelledby": "help-title"});
    const box = make("input", {type: "checkbox", onchange: () => {
      this.off = !box.checked;
      localStorage.setItem(kOffKey, this.off ? "1" : "0");
    }});
    box.checked = !this.off;
    const close = () => {
      dialog.close();
      dialog.remove();
    };
    const rows = (keys) => keys.map(([key, text]) => [make("kbd", {}, key === "Escape" ? "Esc" : key), text]);
    dialog.append(make("h2", {id: "help-title", tabindex: -1, autofocus: true}, "Keys"),
      table("Keys of the page", ["Key", "Does"], [...rows(this.keys), ...rows([["?", "show this help"],
        ["Tab", "to the next control; arrow keys move within tiles and lists"]])]),
      make("h2", {}, "Keys of the plan, while it has the focus"), table("Keys of the plan", ["Key", "Does"], rows(kPlanKeys)),
      make("h2", {}, "Keys of the chart, while it has the focus"), table("Keys of the chart", ["Key", "Does"], rows(kChartKeys)),
      make("h2", {}, "Keys of the 3D view, while it has the focus"), table("Keys of the 3D view", ["Key", "Does"], rows(kView3dKeys)),
      make("label", {class: "check"}, box, "Keys of one letter act"),
      make("div", {class: "row end"}, button("Close", close, {class: "primary"})));
    dialog.addEventListener("cancel", () => dialog.remove());
    document.body.append(dialog);
    dialog.showModal();
  }
}
