// Draws one device, operated symbol, track or place of the plan, as it is now.
import {kindColor} from "../kinds.js";
import {slotOf} from "./geometry.js";
import {cutText, fontSize, kMiddle, kNear, onBelt, paintBadge} from "./draw.js";
import {levelOf, motionOf, runs} from "./motion.js";
import {drawShape} from "./shapes.js";
import {colorOf, rank, STATUSES} from "../status.js";
import {DEVICE, SYMBOL} from "../store.js";
import {kFont, reducedMotion, theme} from "../theme.js";
import {stateText} from "../tile.js";
import {paintMarks, paintMotors, paintParts, xOf} from "../track_draw.js";
import {isKnown, shortName, withUnit} from "../value_words.js";
import {isOn, value as valueText} from "../words.js";

const kSpin = 4;      // radians in a second, of what runs
const kUnder = .95;   // grid units below a symbol, for its texts
const kUrgent = rank.moving;

const spinAt = (now) => reducedMotion.matches ? .8 : now / 1e9 * kSpin % (2 * Math.PI);

const isForced = ({symbolFlags}, {events, operations}) => events.some((symbol) => symbolFlags[symbol] & SYMBOL.forced)
  || operations.some(({symbol}) => symbolFlags[symbol] & SYMBOL.forced);

const kLampColors = [[/RED/i, "stop"], [/AMBER|YELLOW|ORANGE/i, "kind0"], [/BLUE/i, "accent"], [/WHITE/i, "text"]];

/// The name of the color that a lamp has when it is lit, by its name; green without a word.
export const lampColor = (name) => kLampColors.find(([words]) => words.test(name))?.[1] ?? "on";

/// Texts below each other, the first in the color of texts, in `width` pixels around x.
const paintTexts = (context, texts, x, y, width, scale) => {
  const size = fontSize(scale);
  const color = theme();
  context.textAlign = "center";
  context.textBaseline = "middle";
  texts.slice(0, Math.floor(kUnder * scale / (size * 1.1))).forEach((text, i) => {
    context.font = (i === 0 ? "600 " : "") + size + "px " + kFont;
    context.fillStyle = i === 0 ? color.text : color.soft;
    context.fillText(cutText(context, text, width), x, y + size * (.55 + 1.1 * i));
  });
};

const valueLines = (app, device, values) => (values ?? []).filter((at) => isKnown(app.plant, app.plant.values[at]))
  .map((at) => [shortName(app.plant.values[at], device), withUnit(app.store.numbers[at], app.plant.values[at])].join(" "));

/// Far away: a square in the color of the status.
const paintDot = (context, x, y, scale, key) => {
  const color = theme();
  const size = Math.max(2, scale * .8);
  context.fillStyle = key === "waits" || colorOf(key) === "waits" ? color.line : color[colorOf(key)];
  context.fillRect(x - size / 2, y - size / 2, size, size);
};

/// `values`: the indexes of the values that are shown at the device.
export const paintDevice = (context, camera, app, index, placed, values, now) => {
  const {store, statuses, plant} = app;
  const device = plant.devices[index];
  const {key, letter} = STATUSES[statuses.of[index]];
  const [x, y] = camera.toScreen([placed.x, placed.y]);
  const {scale} = camera;
  if (scale < kMiddle) return paintDot(context, x, y, scale, key);
  const color = theme();
  const spins = store.moves(index) || runs(store, index);
  const motion = Object.assign(motionOf(store, index, now), {spin: spins ? spinAt(now) : .8, level: device.shape === "tank" ? levelOf(store, values) : null});
  const name = colorOf(key);
  const active = name === "waits" ? (motion.on ? color[device.shape === "lamp" ? lampColor(device.name) : "on"] : color.ink) : color[name];
  drawShape(context, device.shape, {x, y, turn: placed.turn}, scale * .92, {ink: name === "waits" ? color.ink : color[name], color: active,
    fill: color[name + "-tint"] ?? color.back}, motion, (store.flags[index] & DEVICE.disabled) !== 0);
  const badge = Math.max(9, Math.min(18, scale * .34));
  if (statuses.of[index] >= kUrgent) paintBadge(context, letter, color[name], x + scale * .5 - badge * .6, y - scale * .5 - badge * .1, badge);
  if ((store.flags[index] & DEVICE.malfunction) !== 0 && key !== "malfunction") {
    paintBadge(context, STATUSES[rank.malfunction].letter, color.malfunction, x + scale * .5 - badge * .6, y - scale * .5 + badge * .95, badge);
  }
  if (isForced(store, device)) paintBadge(context, "F", color.blocked, x - scale * .5 - badge * .4, y - scale * .5 - badge * .1, badge);
  if (scale >= kNear) {
    const lines = valueLines(app, device, values);
    const state = stateText(store, index);
    const texts = device.shape === "tank" || device.states.length < 2 ? [device.label, ...lines, state] : [device.label, state, ...lines];
    paintTexts(context, texts.filter((text) => text !== ""), x, y + scale * .5, 1.94 * scale, scale);
  }
};

/// What an operated symbol looks like.
export const operatorShape = ({direction, type}) => direction === "operation" ? "lamp" : type === "BOOL" ? "button" : "selector";

export const paintOperator = (context, camera, app, {symbol: index, x: px, y: py}) => {
  const {store, plant} = app;
  const symbol = plant.symbols[index];
  const [x, y] = camera.toScreen([px, py]);
  const {scale} = camera;
  const on = isOn(symbol, store.values[index]);
  if (scale < kMiddle) return paintDot(context, x, y, scale, on ? "moving" : "waits");
  const color = theme();
  drawShape(context, operatorShape(symbol), {x, y, turn: 0}, scale * .92, {ink: color.ink, color: color[operatorShape(symbol) === "lamp" ? lampColor(symbol.name) : "on"], fill: color.back}, {amount: on ? 1 : 0, turn: 0, on, spin: 0}, false);
  if (store.symbolFlags[index] & SYMBOL.forced) paintBadge(context, "F", color.blocked, x - scale * .6, y - scale * .5, Math.max(9, Math.min(18, scale * .34)));
  if (scale < kNear) return;
  paintTexts(context, [symbol.comment ?? symbol.name.split("_").slice(2).filter((level) => !["I", "O"].includes(level)).join(" "), valueText(store.values[index], symbol)],
    x, y + scale * .5, 1.94 * scale, scale);
};

/// Parts, drives, stops and sensors of a track.
export const paintTrack = (context, camera, app, index, placed, now) => {
  const {store, plant} = app;
  const location = plant.locations[index];
  const at = store.rankOfLocation[index];
  const {stops = [], drives = []} = store.tracks[at] ?? {};
  const seconds = reducedMotion.matches ? 0 : now / 1e9;
  onBelt(context, camera, placed, (form, width) => {
    context.lineWidth = 1;
    const write = (text, x, y, color) => {
      if (camera.scale < kMiddle) return;
      context.save();
      context.translate(x, y);
      if (placed.turn === 180) context.rotate(Math.PI);
      Object.assign(context, {fillStyle: color, textAlign: "center", textBaseline: "middle"});
      context.fillText(text, 0, 0);
      context.restore();
    };
    paintParts(context, location, width, form, {parts: store.partsOn(at, now), kinds: plant.part_kinds, speeds: drives, stops, seconds}, write);
    if (camera.scale < kMiddle) return;
    if (plant.mode !== "recording") paintMotors(context, location, width, form, drives, seconds);
    paintMarks(context, location, width, form, sensorMarks(app, location, width));
  });
};

/// The sensors of a track as paintMarks draws them.
const sensorMarks = ({store, plant}, location, width) => location.sensors.map(({symbol, at}) => ({at, mark: xOf(location, width, at), shown: "", left: 0,
  on: isOn(plant.symbols[symbol], store.values[symbol]), forced: (store.symbolFlags[symbol] & SYMBOL.forced) !== 0}));

/// The slots of a place with their parts, its sensors, and how many parts have no slot.
export const paintPlace = (context, camera, app, index, placed) => {
  const {store, plant} = app;
  const color = theme();
  const {scale} = camera;
  const parts = store.places[store.rankOfLocation[index]] ?? [];
  const slots = placed.columns * placed.h;
  const holds = Math.min(slots, plant.locations[index].holds);
  for (let i = 0; i < holds; ++i) {
    const [x, y] = camera.toScreen(slotOf(placed, i));
    const size = scale * .84;
    context.lineWidth = 1;
    context.fillStyle = color.belt;
    context.strokeStyle = color.ink;
    context.fillRect(x - size / 2, y - size / 2, size, size);
    context.strokeRect(x - size / 2, y - size / 2, size, size);
    if (!parts[i]) continue;
    context.fillStyle = color[kindColor(parts[i][1])];
    context.fillRect(x - size * .36, y - size * .36, size * .72, size * .72);
    context.strokeRect(x - size * .36, y - size * .36, size * .72, size * .72);
    if (scale < kNear) continue;
    Object.assign(context, {fillStyle: color["on-kind"], textAlign: "center", textBaseline: "middle", font: fontSize(scale) + "px " + kFont});
    const isLast = i === holds - 1 && parts.length > holds;
    context.fillText(cutText(context, isLast ? "+" + (parts.length - holds + 1) : plant.part_kinds[parts[i][1]]?.name ?? "?", size * .7), x, y);
  }
  if (scale < kMiddle) return;
  plant.locations[index].sensors.forEach(({symbol}, i) => {
    const [x, y] = camera.toScreen([placed.x + .25 + i * .45, placed.y]);
    const on = isOn(plant.symbols[symbol], store.values[symbol]);
    context.fillStyle = on ? color.on : color.back;
    context.strokeStyle = on ? color.back : color.soft;
    context.beginPath();
    context.arc(x, y, scale * .14, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  });
};
