// Draws the chart on a canvas: the axis of time, a row for each symbol or device, cursors.
import {stateWords} from "./chart_rows.js";
import {ticks} from "./layout.js";
import {kFont, theme} from "./theme.js";

const kRowHeight = 40;
const kNameHeight = 15;  // of a name above its row
export const kAxisHeight = 26;
const kPad = 8;

/// The height of a row; `named` rows have their names above them in the picture.
export const bandHeight = (named) => kRowHeight + (named ? kNameHeight : 0);

const text = (context, words, x, y, color, align = "left") => {
  context.fillStyle = color;
  context.textAlign = align;
  context.textBaseline = "middle";
  context.fillText(words, x, y);
};

/// A tick of the axis, as exact as the distance of two ticks needs.
const tickText = (t, step) => {
  const digits = Math.max(0, Math.min(9, -Math.floor(Math.log10(step / 1e9) + 1e-9)));
  return (t / 1e9).toFixed(digits) + " s";
};

export const drawAxis = (context, view, width) => {
  const color = theme();
  context.clearRect(0, 0, width, kAxisHeight);
  context.font = "11px " + kFont;
  const found = ticks(view.from, view.to, Math.max(2, width / 120));
  const step = found.length > 1 ? found[1] - found[0] : view.to - view.from;
  for (const t of found) {
    const x = (t - view.from) / (view.to - view.from) * width;
    context.fillStyle = color.line;
    context.fillRect(Math.round(x), kAxisHeight - 7, 1, 7);
    if (t >= 0 && x < width - 40) text(context, tickText(t, step), x + 3, 10, color.soft);
  }
};

const drawBool = (context, pieces, color) => {
  const [high, low] = [kPad, kRowHeight - kPad];
  context.strokeStyle = color.accent;
  context.fillStyle = color.accent;
  context.globalAlpha = .18;
  for (const [x, until, on, dense] of pieces) if (on || dense) context.fillRect(x, high, until - x, low - high);
  context.globalAlpha = 1;
  context.beginPath();
  let before = null;
  for (const [x, until, on, dense] of pieces) {
    const y = on ? high : low;
    if (before !== null && before !== y) context.lineTo(x, y);
    else context.moveTo(x, y);
    context.lineTo(until, y);
    before = y;
    if (!dense) continue;
    context.moveTo(x, high);
    context.lineTo(x, low);
    context.lineTo(until, low);
    context.lineTo(until, high);
    before = null;
  }
  context.stroke();
};

const drawStates = (context, pieces, color, device) => {
  const [high, low] = [kPad, kRowHeight - kPad];
  for (const [x, until, value, dense] of pieces) {
    const moving = !dense && value.target !== value.state;
    context.fillStyle = dense ? color.soft : moving ? color.mark : color.belt;
    context.fillRect(x, high, Math.max(.5, until - x), low - high);
    context.strokeStyle = color.ink;
    if (until - x > 2) context.strokeRect(x + .5, high + .5, until - x - 1, low - high - 1);
    if (dense) continue;
    const words = stateWords(device, value);
    if (until - x > context.measureText(words).width + 8) text(context, words, (x + until) / 2, kRowHeight / 2, color.text, "center");
  }
};

/// `rows`: bits and states as describeRows() makes them. `view`: { from, to } shown, `known` { from, until } of which there is data.
export const drawRows = (context, rows, view, known, width, named) => {
  const color = theme();
  const pitch = bandHeight(named);
  context.clearRect(0, 0, width, Math.max(1, rows.length) * pitch);
  context.font = "11px " + kFont;
  const x = (t) => (t - view.from) / (view.to - view.from) * width;
  context.fillStyle = color.side;
  if (known.from > view.from) context.fillRect(0, 0, Math.min(width, x(known.from)), rows.length * pitch);
  if (known.until < view.to) context.fillRect(Math.max(0, x(known.until)), 0, width, rows.length * pitch);
  rows.forEach((row, rank) => {
    context.save();
    context.translate(0, rank * pitch);
    context.fillStyle = color.line;
    context.fillRect(0, pitch - 1, width, 1);
    if (named) text(context, row.name, 4, kNameHeight / 2 + 2, color.soft);
    context.translate(0, pitch - kRowHeight);
    context.lineWidth = 1.25;
    const pieces = row.data.pieces(view.from, view.to, known.until, width);
    if (row.kind === "device") drawStates(context, pieces, color, row.device);
    else drawBool(context, pieces, color);
    context.restore();
  });
};

/// Cursors A and B over the rows, and the present time of the plant as a dotted line.
export const drawCursors = (context, cursors, now, view, width, height) => {
  const color = theme();
  context.clearRect(0, 0, width, height);
  const present = Math.round((now - view.from) / (view.to - view.from) * width) + .5;
  context.strokeStyle = color.soft;
  context.setLineDash([2, 3]);
  context.beginPath();
  context.moveTo(present, 0);
  context.lineTo(present, height);
  context.stroke();
  context.setLineDash([]);
  context.font = "bold 12px " + kFont;
  for (const [name, t] of Object.entries(cursors)) {
    if (t === null) continue;
    const x = Math.round((t - view.from) / (view.to - view.from) * width);
    if (x < 0 || x > width) continue;
    context.fillStyle = name === "A" ? color.finding : color.transfer;
    context.fillRect(x, 0, 1.5, height);
    context.fillRect(x - 8, 0, 16, 15);
    text(context, name, x, 8, color.back, "center");
  }
};
