// Colors of the style sheet for 3D, as [red, green, blue] from 0 to 1.
import {kindColor, kKindColors} from "../kinds.js";
import {lampColor} from "../plan/things.js";
import {STATUSES} from "../status.js";
import {theme} from "../theme.js";

/// "#0b57a4" or "#05a" as three numbers.
export const rgb = (text) => {
  const digits = text.slice(1).length === 3 ? [...text.slice(1)].map((digit) => digit + digit).join("") : text.slice(1);
  return [0, 2, 4].map((at) => parseInt(digits.slice(at, at + 2), 16) / 255);
};

export const mixed = (a, b, part) => a.map((value, i) => value + (b[i] - value) * part);

/// The color of a status in the style sheet; null: the style sheet gives it no color.
const kOfStatus = {moving: "moving", stopped: "stopped", disabled: "disabled", blocked: "blocked", frozen: "malfunction", malfunction: "malfunction", finding: "finding"};
export const statusColor = (status) => {
  const name = kOfStatus[STATUSES[status].key];
  return name ? rgb(theme()[name]) : null;
};

/// The name of a device for the picture, with the letter and color of its status if it has a color.
export const statusLabel = (app, device) => {
  const {label} = app.plant.devices[device];
  const {key, letter} = STATUSES[app.statuses.of[device]];
  const color = statusColor(app.statuses.of[device]);
  return {key: label + " " + key, text: label, letter: color ? letter : "", color: color ? "rgb(" + color.map((part) => Math.round(part * 255)).join() + ")" : ""};
};

/// Of a lamp, sensor or button that is on: as in the plan.
export const litColor = ({shape, name}) => rgb(theme()[shape === "lamp" ? lampColor(name) : "on"]);

/// All colors of a scene, in the current theme.
export const sceneColors = () => {
  const color = theme();
  const of = (name) => rgb(color[name]);
  const kinds = Array.from({length: kKindColors}, (_, kind) => of(kindColor(kind)));
  const housing = mixed(of("soft"), of("back"), .45);
  return {back: of("back"), floor: of("side"), line: of("line"), text: color.text, soft: of("soft"), belt: mixed(of("belt"), of("ink"), .3), ink: of("ink"), accent: of("accent"), housing,
    mover: mixed(housing, of("ink"), .55), liquid: mixed(of("accent"), of("back"), .25), kinds: (kind) => kinds[kind % kKindColors]};
};

/// Of a device: its housing and what moves.
export const deviceColors = (colors, status) => {
  const own = statusColor(status);
  return own === null ? {body: colors.housing, mover: colors.mover} : {body: own, mover: mixed(own, colors.ink, .35)};
};
