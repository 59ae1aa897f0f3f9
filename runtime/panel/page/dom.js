// Makes elements without strings of HTML: a text of the user becomes a text node or the value of an attribute, nothing else.
import {exactInstant, instant} from "./words.js";

const fill = (element, attributes, children) => {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === "function") element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return element;
};

/// make("p", {class: "x", onclick: act}, "text", [other, elements]). A function is a listener; null, false and absent
/// attributes and children are left out.
export const make = (name, attributes = {}, ...children) => fill(document.createElement(name), attributes, children);

/// A button that does not submit a form.
export const button = (label, onclick, attributes = {}) => make("button", {type: "button", onclick, ...attributes}, label);

/// Writes a text only if it differs: an unchanged text costs no layout.
export const setText = (element, text) => {
  if (element.shownText === text) return;
  element.shownText = text;
  element.textContent = text;
};

/// Sets or removes an attribute only if it differs; null removes it.
export const setAttribute = (element, name, value) => {
  if (element.getAttribute(name) === value) return;
  if (value === null) element.removeAttribute(name);
  else element.setAttribute(name, value);
};

/// A name that may break after its levels.
export const breakable = (name) => name.split(/(?<=[_.])/).flatMap((level, i) => i > 0 ? [make("wbr"), level] : [level]);

/// A plant time to the millisecond; the exact one is its title.
export const timeOf = (ns) => make("span", {title: exactInstant(ns)}, instant(ns));

/// Text for screen readers only.
export const hidden = (text) => make("span", {class: "hidden-text"}, text);

/// <select> with [value, text] pairs.
export const select = (label, options, attributes = {}) => make("select", {"aria-label": label, ...attributes},
  options.map(([value, text]) => make("option", {value}, text)));

/// A table with column heads. `rows` are arrays of cells; the first cell of a row is its head.
export const table = (caption, heads, rows) => make("table", {},
  make("caption", {class: "hidden-text"}, caption),
  make("thead", {}, make("tr", {}, heads.map((head) => make("th", {scope: "col"}, head)))),
  make("tbody", {}, rows.map((row) => make("tr", {}, row.map((cell, i) =>
    make(i === 0 ? "th" : "td", i === 0 ? {scope: "row"} : {}, cell))))));

/// Gives a file to the user.
export const download = (blob, name) => {
  const url = URL.createObjectURL(blob);
  make("a", {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
};
