// What stays of the plan until the view moves: the picture behind it, frames with their names, belts, joins, names of tracks and places.
import {pointOn} from "./geometry.js";
import {colorOf, STATUSES} from "../status.js";
import {kFont, theme} from "../theme.js";
import {kBeltHeight, kSide, paintBelt} from "../track_draw.js";

export const kNear = 20;   // pixels for a grid unit, from which on names of things are written
export const kMiddle = 11;  // from which on symbols have a shape
const kJoinWidth = .5;
const kTaken = .98;        // grid units from the middle of a belt

/// A text cut to a width, with "…" in its middle, since names differ at their ends; "" if less than three letters have room.
export const cutText = (context, text, width) => {
  if (context.measureText(text).width <= width) return text;
  for (let length = Math.min(text.length - 1, Math.floor(width / 4)); length >= 3; --length) {
    const cut = text.slice(0, Math.ceil(length / 2)) + "…" + text.slice(text.length - Math.floor(length / 2));
    if (context.measureText(cut).width <= width) return cut;
  }
  return "";
};

/// The size of texts next to symbols, in pixels.
export const fontSize = (scale) => Math.max(11, Math.min(17, scale * .26));

/// Calls `draw(form, width)` with the context turned and scaled so that the strip of track_draw.js lies on the belt; the middle of the belt is at height 0.
export const onBelt = (context, camera, placed, draw) => {
  const [x, y] = camera.toScreen([placed.x, placed.y]);
  const zoom = placed.width * camera.scale / kBeltHeight;
  const width = placed.length * camera.scale / zoom + 2 * kSide;
  context.save();
  context.translate(x, y);
  context.rotate(placed.turn * Math.PI / 180);
  context.scale(zoom, zoom);
  context.translate(-kSide, 0);
  draw({belt: -kBeltHeight / 2, height: 0, names: null}, width);
  context.restore();
};

const paintBackground = (context, camera, background) => {
  if (!background?.image) return;
  const {image, x, y, width, opacity = 1} = background;
  const [left, top] = camera.toScreen([x, y]);
  const high = width * image.height / image.width;
  context.globalAlpha = opacity;
  context.drawImage(image, left, top, width * camera.scale, high * camera.scale);
  context.globalAlpha = 1;
};

/// The frame of a station: tinted by its most urgent status, whose letter is in its corner.
const paintFrame = (context, camera, frame, status) => {
  const color = theme();
  const {key, letter} = STATUSES[status ?? 0];
  const [x, y] = camera.toScreen([frame.x, frame.y]).map(Math.round);
  const [w, h] = [frame.w * camera.scale, frame.h * camera.scale].map(Math.round);
  const isCalm = status === null || colorOf(key) === "waits";
  const isUrgent = !isCalm && key !== "moving";
  context.fillStyle = isUrgent ? color[colorOf(key) + "-tint"] : color.side;
  context.globalAlpha = .8;
  context.fillRect(x, y, w, h);
  context.globalAlpha = 1;
  context.lineWidth = isUrgent ? 2 : 1;
  context.strokeStyle = isUrgent ? color[colorOf(key)] : color.line;
  context.strokeRect(x + .5, y + .5, w - 1, h - 1);
  context.lineWidth = 1;
  if (w < 24) return;
  const size = Math.max(10, Math.min(16, camera.scale * .8));
  const badge = isCalm || w < 50 ? 0 : size + 4;
  context.font = "600 " + size + "px " + kFont;
  context.textAlign = "left";
  context.textBaseline = "middle";
  const room = w - 8 - badge;
  const process = frame.name.split(" ").slice(1).join(" ") || frame.name;
  const text = context.measureText(frame.name).width <= room ? frame.name : process;
  const head = Math.max(size * .65, Math.min(camera.scale * .65, 18)) + 1;
  context.fillStyle = color.text;
  context.fillText(cutText(context, text, room), x + 4, y + head);
  if (badge > 0) paintBadge(context, letter, color[colorOf(key)], x + w - badge - 1, y + head - size / 2 - 1, size + 2);
};

/// A letter on a square.
export const paintBadge = (context, letter, back, x, y, size) => {
  context.fillStyle = back;
  context.fillRect(x, y, size, size);
  context.fillStyle = theme().back;
  context.font = "700 " + size * .78 + "px " + kFont;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(letter, x + size / 2, y + size / 2 + .5);
};

/// The path of parts between two tracks or places: a short belt at the end of a track, a dashed line of a transfer.
const paintJoin = (context, camera, {points, isEnd}) => {
  const color = theme();
  const path = points.map((point) => camera.toScreen(point));
  const trace = () => {
    context.beginPath();
    context.moveTo(...path[0]);
    for (let i = 1; i + 1 < path.length; ++i) context.arcTo(...path[i], ...path[i + 1], camera.scale * .6);
    context.lineTo(...path[path.length - 1]);
    context.stroke();
  };
  context.lineJoin = "round";
  if (isEnd) {
    context.strokeStyle = color.ink;
    context.lineWidth = kJoinWidth * camera.scale;
    trace();
    context.strokeStyle = color.belt;
    context.lineWidth = Math.max(1, kJoinWidth * camera.scale - 2);
    trace();
  } else {
    context.strokeStyle = color.transfer;
    context.lineWidth = Math.max(1.5, camera.scale * .08);
    context.setLineDash([camera.scale * .25, camera.scale * .18]);
    trace();
    context.setLineDash([]);
  }
  paintTip(context, path, isEnd ? color.ink : color.transfer, camera.scale * (isEnd ? .18 : .25));
  context.lineWidth = 1;
};

/// A triangle at the end of a path.
const paintTip = (context, path, fill, size) => {
  const [[px, py], [x, y]] = path.slice(-2);
  const long = Math.hypot(x - px, y - py) || 1;
  const [dx, dy] = [(x - px) / long * size, (y - py) / long * size];
  context.fillStyle = fill;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x - 1.6 * dx - dy, y - 1.6 * dy + dx);
  context.lineTo(x - 1.6 * dx + dy, y - 1.6 * dy - dx);
  context.fill();
};

/// An arrow at the end of a track where parts leave the plant.
const paintOut = (context, camera, placed) => {
  const [dx, dy] = [[1, 0], [0, 1], [-1, 0], [0, -1]][placed.turn / 90];
  const end = [placed.x + dx * placed.length, placed.y + dy * placed.length];
  paintTip(context, [camera.toScreen(end), camera.toScreen([end[0] + dx * .6, end[1] + dy * .6])], theme().soft, camera.scale * .28);
};

/// A dashed arrow away from a belt where a transfer takes parts out of the plant.
const paintTaken = (context, camera, placed, at, length) => {
  const [x, y] = pointOn(placed, at, length);
  const [dx, dy] = placed.turn % 180 === 0 ? [0, 1] : [1, 0];
  paintJoin(context, camera, {isEnd: false, points: [[x + dx * .42, y + dy * .42], [x + dx * kTaken, y + dy * kTaken]]});
};

const paintName = (context, camera, placed, name) => {
  const {scale} = camera;
  context.font = fontSize(scale) + "px " + kFont;
  context.fillStyle = theme().soft;
  context.textBaseline = "middle";
  const [x, y] = camera.toScreen([placed.x, placed.y]);
  if (placed.kind === "place") {
    context.textAlign = "center";
    context.fillText(cutText(context, name, Math.max(placed.w, 2) * scale), x + placed.w * scale / 2, y + placed.h * scale + fontSize(scale) * .7);
    return;
  }
  const along = placed.length * scale;
  if (placed.turn % 180 === 0) {
    const left = placed.turn === 0 ? x : x - along;
    context.textAlign = "left";
    context.fillText(cutText(context, name, along * .6), left + (placed.turn === 0 ? 1.4 : .2) * scale, y + (placed.turn === 0 ? .72 : -.72) * scale);
  } else {
    context.save();
    context.translate(x, y);
    context.rotate(Math.PI / 2);
    context.textAlign = "center";
    context.fillText(cutText(context, name, along - 8), (placed.turn === 90 ? 1 : -1) * along / 2, -.72 * scale);
    context.restore();
  }
};

/// Draws what stays. `statusOf(frame)`: the most urgent status of a frame's devices, or null.
export const drawStill = (context, camera, {plant, placed, background, statusOf}) => {
  context.clearRect(0, 0, camera.wide, camera.high);
  paintBackground(context, camera, background);
  placed.frames.forEach((frame) => { if (camera.sees(frame)) paintFrame(context, camera, frame, statusOf(frame)); });
  for (const join of placed.joins) paintJoin(context, camera, join);
  placed.locations.forEach((location, index) => {
    const {name, ends} = plant.locations[index];
    if (location.kind === "track") {
      onBelt(context, camera, location, (form, width) => paintBelt(context, plant.locations[index], width, form));
      if ((ends ?? []).some(({to}) => to === null)) paintOut(context, camera, location);
    }
    for (const {from, to} of plant.transfers) {
      if (location.kind === "track" && from.location === index && to.location === null) paintTaken(context, camera, location, from.at ?? plant.locations[index].length, plant.locations[index].length);
    }
    if (camera.scale >= kNear) paintName(context, camera, location, name);
  });
};
