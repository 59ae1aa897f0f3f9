// The name under which a trainee acts: asked once, kept for this tab, and sent with each act.
import {actingButton, perform, showResult} from "./acts.js";
import {button, make, setAttribute} from "./dom.js";

const kKey = "symplant name";
const kRunKey = "symplant name run";  // in which the name has joined
const kMostBytes = 64;

/// What is wrong with a name; empty if nothing is.
export const nameError = (name) => {
  if (name === "") return "enter a name";
  if (new TextEncoder().encode(name).length > kMostBytes) return "the name is too long: at most 64 bytes";
  return /[\p{Cc}\p{Zl}\p{Zp}\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069\ufeff]/u.test(name) ? "the name has a control character" : "";
};

export const keptName = () => sessionStorage.getItem(kKey) ?? "";

/// After a restart the program does not know the name: it joins again.
export const joinAgain = (app) => {
  if (app.rights !== "allowed" || app.api.name === "" || sessionStorage.getItem(kRunKey) === app.plant.run) return;
  app.api.acts({join: true}).then(() => sessionStorage.setItem(kRunKey, app.plant.run), () => {});
};

/// The field for the name, and then the name with a button to change it.
export class TraineeName {
  constructor(app, result) {
    Object.assign(this, {app, result});
    this.input = make("input", {type: "text", "aria-label": "Your name", placeholder: "Your name", maxlength: 64, size: 20, autocomplete: "off",
      onkeydown: (event) => { if (event.key === "Enter") this.join(); }});
    this.form = make("span", {class: "row"}, this.input, actingButton(app, "Join", () => this.join()));
    this.text = make("strong", {class: "name"});
    this.change = button("Change the name", () => this.ask(), {class: "small"});
    this.known = make("span", {class: "row"}, make("span", {}, "You are ", this.text), this.change);
    this.element = make("div", {class: "row controls"}, this.form, this.known);
    this.show();
  }

  show() {
    const {name} = this.app.api;
    this.text.textContent = name;
    setAttribute(this.form, "hidden", name === "" ? null : "");
    setAttribute(this.known, "hidden", name === "" ? "" : null);
  }

  ask() {
    this.input.value = this.app.api.name;
    setAttribute(this.form, "hidden", null);
    setAttribute(this.known, "hidden", "");
    this.input.focus();
  }

  async join() {
    const {app, result} = this;
    const name = this.input.value.trim();
    const error = nameError(name);
    if (error) return showResult(result, error, true);
    const before = app.api.name;
    app.api.name = name;
    if (!await perform(app, result, () => ({join: true}))) {
      app.api.name = before;
      return;
    }
    sessionStorage.setItem(kKey, name);
    sessionStorage.setItem(kRunKey, app.plant.run);
    this.show();
    this.change.focus();
  }
}
