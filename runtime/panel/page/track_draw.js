// Draws a track on a canvas: the belt to scale, its parts, sensors, stops and transfers. What begins with `paint` draws on what is there, for the plan.
import {kindColor} from "./kinds.js";
import {ticks} from "./layout.js";
import {kFont, theme} from "./theme.js";
import {length as lengthText} from "./words.js";

export const kSide = 14;
export const kBeltHeight = 22;
const kMotorBand = 11;      // pixels below the belt, for its motors
const kMotorRadius = 4.5;
const kRollRadius = 60000;  // um, of a roller: what a motor drives turns as fast as it would
const kMostTurn = 8;        // radians per second, so that the eye sees the direction

/// A strip with the names of sensors and a scale, and a low one without: its height, the top of its belt, the line of names.
export const kFull = {height: 86, belt: 34, names: 11};
export const kCompact = {height: 50, belt: 15, names: null};

export const scaleOf = (track, width) => (width - 2 * kSide) / track.length;
export const xOf = (track, width, position) => kSide + position * scaleOf(track, width);

const write = (context, text, x, y, color, align = "center", size = 11) => {
  context.font = size + "px " + kFont;
  context.fillStyle = color;
  context.textAlign = align;
  context.textBaseline = "middle";
  context.fillText(text, x, y);
};

/// A text cut to a width, with "…".
const cut = (context, text, width) => {
  if (context.measureText(text).width <= width) return text;
  let length = text.length;
  while (length > 0 && context.measureText(text.slice(0, length) + "…").width > width) --length;
  return length === 0 ? "" : text.slice(0, length) + "…";
};

/// Sets how wide the names of sensors are.
export const measureNames = (context, sensors) => {
  context.font = "11px " + kFont;
  for (const sensor of sensors) sensor.wide = context.measureText(sensor.text).width;
};

/// The sensor at a point of the strip, or undefined.
export const sensorAt = (form, sensors, x, y) => y > form.belt ? undefined : sensors.find(({mark}) => Math.abs(mark - x) < 8);

/// The belt, and where one drive ends and the next begins.
export const paintBelt = (context, track, width, {belt}) => {
  const color = theme();
  context.fillStyle = color.belt;
  context.fillRect(kSide, belt, width - 2 * kSide, kBeltHeight);
  context.strokeStyle = color.ink;
  context.strokeRect(kSide + .5, belt + .5, width - 2 * kSide - 1, kBeltHeight - 1);
  for (const {until} of track.drives.slice(0, -1)) {
    const x = Math.round(xOf(track, width, until)) + .5;
    context.setLineDash([3, 3]);
    context.beginPath();
    context.moveTo(x, belt - 4);
    context.lineTo(x, belt + kBeltHeight + 4);
    context.stroke();
    context.setLineDash([]);
  }
};

/// The belt, its drives, ticks, transfers: what stays.
export const drawBelt = (context, track, width, form, transfers) => {
  const color = theme();
  const {belt} = form;
  context.clearRect(0, 0, width, form.height);
  paintBelt(context, track, width, form);
  for (const at of ticks(0, track.length, Math.max(2, width / 110))) {
    const x = xOf(track, width, at);
    context.fillStyle = color.line;
    context.fillRect(Math.round(x), belt + kBeltHeight, 1, 5);
    if (form.names === null) continue;
    write(context, lengthText(at), Math.min(Math.max(x, kSide + 12), width - kSide - 18), form.height - 9, color.soft);
  }
  for (const {at, into} of transfers) {
    const x = xOf(track, width, at);
    context.fillStyle = color.transfer;
    context.beginPath();
    const [tip, base] = into ? [belt + kBeltHeight + 1, belt + kBeltHeight + 9] : [belt + kBeltHeight + 9, belt + kBeltHeight + 1];
    context.moveTo(x, tip);
    context.lineTo(x - 5, base);
    context.lineTo(x + 5, base);
    context.fill();
  }
};

/// Arrows on drives that run, so that an empty belt shows its direction.
const drawDrives = (context, track, width, {belt}, speeds, shift) => {
  context.strokeStyle = theme().soft;
  context.lineWidth = 1.5;
  track.drives.forEach(({from, until}, drive) => {
    const speed = speeds[drive] ?? 0;
    if (speed === 0) return;
    const [begin, end] = [xOf(track, width, from), xOf(track, width, until ?? track.length)];
    const along = ((shift * speed * scaleOf(track, width)) % 40 + 40) % 40;
    const tip = speed > 0 ? 4 : -4;
    context.beginPath();
    for (let x = begin + along; x < end - 6; x += 40) {
      if (x < begin + 6) continue;
      context.moveTo(x - tip, belt + 5);
      context.lineTo(x, belt + kBeltHeight / 2);
      context.lineTo(x - tip, belt + kBeltHeight - 5);
    }
    context.stroke();
  });
  context.lineWidth = 1;
};

const drawMotor = (context, x, y, speed, seconds) => {
  const color = theme();
  context.beginPath();
  context.arc(x, y, kMotorRadius, 0, 2 * Math.PI);
  context.fillStyle = speed === 0 ? color.back : color.moving;
  context.strokeStyle = speed === 0 ? color.soft : color.moving;
  context.fill();
  context.stroke();
  if (speed === 0) return;
  const angle = seconds * Math.max(-kMostTurn, Math.min(kMostTurn, speed / kRollRadius)) % (2 * Math.PI);
  const [dx, dy] = [Math.cos(angle) * kMotorRadius, Math.sin(angle) * kMotorRadius];
  context.strokeStyle = color.back;
  context.beginPath();
  context.moveTo(x - dx, y - dy);
  context.lineTo(x + dx, y + dy);
  context.stroke();
  const side = Math.sign(speed);
  context.fillStyle = color.moving;
  context.beginPath();
  context.moveTo(x + side * (kMotorRadius + 8), y);
  context.lineTo(x + side * (kMotorRadius + 2), y - 4);
  context.lineTo(x + side * (kMotorRadius + 2), y + 4);
  context.fill();
};

/// Brings back what is on the picture of drawBelt in a band of the strip.
const restore = (context, still, width, top, height) => {
  const ratio = still.width / width;
  context.clearRect(0, top, width, height);
  context.drawImage(still, 0, top * ratio, still.width, height * ratio, 0, top, width, height);
};

/// The motor of each drive below the belt: filled and turning while it runs, with an arrow. `seconds` is plant time.
export const paintMotors = (context, track, width, {belt}, speeds, seconds) => {
  const top = belt + kBeltHeight + 1;
  context.lineWidth = 1.5;
  track.drives.forEach(({from}, drive) => drawMotor(context, xOf(track, width, from) + 16, top + kMotorBand / 2, speeds[drive] ?? 0, seconds));
  context.lineWidth = 1;
};

export const drawMotors = (context, still, track, width, form, speeds, seconds) => {
  restore(context, still, width, form.belt + kBeltHeight + 1, kMotorBand);
  paintMotors(context, track, width, form, speeds, seconds);
};

/// Stops are bars across the belt, filled while they hold.
const drawStops = (context, track, width, {belt}, stops) => {
  const color = theme();
  track.stops.forEach(({at}, i) => {
    const x = Math.round(xOf(track, width, at));
    context.fillStyle = stops[i] ? color.stop : color.back;
    context.strokeStyle = color.stop;
    context.fillRect(x - 2, belt + 1, 5, kBeltHeight - 2);
    context.strokeRect(x - 1.5, belt + .5, 4, kBeltHeight - 1);
  });
};

/// The parts, each with its kind as far as it fits. `seconds` is plant time. `write(text, x, y, color)` writes in the middle of a part.
export const paintParts = (context, track, width, form, {parts, kinds, speeds, stops, seconds}, writeOn = (...args) => write(context, ...args)) => {
  const color = theme();
  const {belt} = form;
  drawDrives(context, track, width, form, speeds, seconds);
  const scale = scaleOf(track, width);
  context.strokeStyle = color.ink;
  for (const [number, kind, x] of parts) {
    const long = Math.max(3, kinds[kind].length * scale);
    const left = kSide + x * scale - long;
    context.fillStyle = color[kindColor(kind)];
    context.fillRect(left, belt + 3, long, kBeltHeight - 6);
    context.strokeRect(left + .5, belt + 3.5, long - 1, kBeltHeight - 7);
    context.font = "11px " + kFont;
    const text = cut(context, kinds[kind].name, long - 4) || cut(context, String(number), long - 2);
    if (text.length > 1 || long < 30) writeOn(text, left + long / 2, belt + kBeltHeight / 2, color["on-kind"]);
  }
  drawStops(context, track, width, form, stops);
};

/// `still` is the picture of drawBelt.
export const drawParts = (context, still, track, width, form, what) => {
  restore(context, still, width, form.belt - 1, kBeltHeight + 2);
  paintParts(context, track, width, form, what);
};

export const drawMarks = (context, still, track, width, form, sensors) => {
  restore(context, still, width, 0, form.belt - 1);
  paintMarks(context, track, width, form, sensors);
};

/// Sensors above the belt: a filled triangle is on, an empty one off. Its tip is at the position, its base where it has room.
export const paintMarks = (context, track, width, form, sensors) => {
  const color = theme();
  const {belt} = form;
  for (const {at, mark, shown, left, on, forced} of sensors) {
    context.beginPath();
    context.moveTo(xOf(track, width, at), belt - 1);
    context.lineTo(mark - 6, belt - 12);
    context.lineTo(mark + 6, belt - 12);
    context.closePath();
    context.fillStyle = on ? color.on : color.back;
    context.strokeStyle = on ? color.back : color.soft;  // an edge between those that are side by side
    context.fill();
    context.stroke();
    if (form.names !== null) write(context, shown, left, form.names, on ? color.text : color.soft, "left");
    if (forced) write(context, "F", mark + 12, belt - 7, color.blocked);
  }
};
