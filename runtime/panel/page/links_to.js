// Links to what a name means.
import {breakable, make} from "./dom.js";
import {selecting} from "./router.js";

export const linkTo = (kind, name, text = breakable(name)) => make("a", {href: selecting(kind, name), class: "name"}, text);

export const deviceLink = (app, index, text) => linkTo("device", app.names.name("device", index), text);
export const symbolLink = (app, index, text) => linkTo("symbol", app.names.name("symbol", index), text);
export const locationLink = (app, index, text) => linkTo("location", app.names.name("location", index), text);

/// A link if the name is known, else the name.
export const nameLink = (app, name) => {
  const found = app.names.find(name);
  return found ? linkTo(found.kind, name) : make("span", {class: "name"}, breakable(name));
};

export const stationAddress = (name) => "#" + new URLSearchParams({view: "line", station: name}).toString();
