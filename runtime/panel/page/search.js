// A field that finds stations, devices, symbols, tracks, requirements and values by parts of their names, by address, or by comment.
import {breakable, make, setAttribute} from "./dom.js";

const kMost = 40;
const kWords = {station: "station", device: "device", symbol: "symbol", location: "track or place", requirement: "requirement", value: "value"};
const kWithMore = ["device", "symbol"];  // their comments, and addresses, are shown

let fields = 0;

/// `choose(found)` gets { kind, name }. `accepts(kind, index)`: what may be found, all without it. The element has `input`.
export const makeSearch = (app, {label, accepts = () => true, choose}) => {
  const id = "search" + ++fields;
  let found = [];
  let active = -1;
  let before = null;  // what had the focus
  const list = make("ul", {id, class: "found", role: "listbox", "aria-label": label + ": found", hidden: true});
  const input = make("input", {type: "search", role: "combobox", "aria-expanded": "false", "aria-controls": id, "aria-autocomplete": "list",
    "aria-label": label, placeholder: label, autocomplete: "off", spellcheck: "false"});
  const close = () => {
    list.hidden = true;
    setAttribute(input, "aria-expanded", "false");
    setAttribute(input, "aria-activedescendant", null);
    active = -1;
  };
  const mark = (index) => {
    active = index;
    [...list.children].forEach((item, i) => setAttribute(item, "aria-selected", String(i === index)));
    setAttribute(input, "aria-activedescendant", index >= 0 ? id + "-" + index : null);
    list.children[index]?.scrollIntoView({block: "nearest"});
  };
  const take = (index) => {
    if (!found[index]) return;
    input.value = "";
    close();
    choose(found[index]);
  };
  const show = () => {
    found = app.names.search(input.value, kMost, accepts);
    list.replaceChildren(...found.map(({kind, name, more}, i) => make("li", {id: id + "-" + i, role: "option", "aria-selected": "false",
      onpointerdown: (event) => event.preventDefault(), onclick: () => take(i)}, make("span", {class: "name"}, breakable(name)), " ",
      make("span", {class: "soft"}, kWords[kind] + (kWithMore.includes(kind) && more ? ", " + more : "")))));
    if (found.length === 0 && input.value.trim() !== "") list.replaceChildren(make("li", {class: "soft", role: "option", "aria-disabled": "true"}, "nothing found"));
    list.hidden = input.value.trim() === "";
    if (!list.hidden) list.scrollIntoView({block: "nearest"});
    setAttribute(input, "aria-expanded", String(!list.hidden));
    active = -1;
  };
  input.addEventListener("input", show);
  /// Back to what had the focus, so that keys of one letter act again.
  const leave = () => {
    input.value = "";
    close();
    if (before?.isConnected && before !== document.body) before.focus();
    else app.main.focus();
  };
  input.addEventListener("focus", ({relatedTarget}) => {
    before = relatedTarget;
    if (input.value) show();
  });
  input.addEventListener("blur", close);
  input.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      event.preventDefault();
      if (found.length > 0) mark((active + (event.key === "ArrowDown" ? 1 : found.length - 1) + (active < 0 && event.key === "ArrowUp" ? 1 : 0)) % found.length);
    } else if (event.key === "Enter") {
      take(Math.max(0, active));
    } else if (event.key === "Escape") {
      event.stopPropagation();
      leave();
    }
  });
  const element = make("div", {class: "search"}, input, list);
  element.input = input;
  return element;
};
