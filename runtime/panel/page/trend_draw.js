// Draws the curves of the chart: their lines over one axis of time, with an axis of numbers for each unit.
import {kFont, theme} from "./theme.js";
import {axisTexts, lineStyle} from "./trend_axes.js";

export const kAxisWidth = 58;  // of an axis of numbers
const kTop = 28;     // above the plot: the unit, and the lines to which the axis belongs
const kBottom = 10;
const kSample = 13;  // pixels of a line in the head of its axis
const kMostSamples = 4;

const yOf = (axis, height) => (number) => kTop + (axis.to - number) / (axis.to - axis.from) * (height - kTop - kBottom);

/// A piece of a line in its color and dashes, for axes and legends.
export const drawSample = (context, rank, x, y, width) => {
  const style = lineStyle(rank);
  context.strokeStyle = theme()[style.color];
  context.lineWidth = 2;
  context.setLineDash(style.dash);
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x + width, y);
  context.stroke();
  context.setLineDash([]);
};

const drawAxis = (context, axis, right, height) => {
  const color = theme();
  const y = yOf(axis, height);
  const {head, texts} = axisTexts(axis);
  context.fillStyle = color.soft;
  context.fillRect(right, kTop - 4, 1, height - kTop + 4);
  context.textAlign = "right";
  context.font = "11px " + kFont;
  axis.ticks.forEach((tick, i) => {
    context.fillRect(right - 4, Math.round(y(tick)), 4, 1);
    context.fillText(texts[i], right - 7, y(tick), kAxisWidth - 10);
  });
  context.fillStyle = color.text;
  context.font = "bold 11px " + kFont;
  context.fillText(head, right, 8, kAxisWidth - 6);
  axis.rows.slice(0, kMostSamples).forEach(({rank}, i) => drawSample(context, rank, right - (i + 1) * (kSample + 1), 19, kSample - 2));
};

/// The axes next to the plot, the first one at the right, next to the lines.
export const drawAxes = (context, axes, height) => {
  const width = axes.length * kAxisWidth;
  context.clearRect(0, 0, width, height);
  context.textBaseline = "middle";
  axes.forEach((axis, i) => drawAxis(context, axis, width - i * kAxisWidth - 1, height));
};

const drawLine = (context, points, y) => {
  let joined = false;
  context.beginPath();
  for (const [at, number] of points) {
    if (Number.isNaN(number)) joined = false;
    else if (joined) context.lineTo(at, y(number));
    else context.moveTo(at, y(number));
    joined = !Number.isNaN(number);
  }
  context.stroke();
};

/// The lines of the curves. `known` { from, until } is of what there is data.
export const drawTrends = (context, axes, view, known, width, height) => {
  const color = theme();
  context.clearRect(0, 0, width, height);
  const x = (t) => (t - view.from) / (view.to - view.from) * width;
  context.fillStyle = color.side;
  if (known.from > view.from) context.fillRect(0, 0, Math.min(width, x(known.from)), height);
  if (known.until < view.to) context.fillRect(Math.max(0, x(known.until)), 0, width, height);
  context.fillStyle = color.line;
  for (const tick of axes[0]?.ticks ?? []) context.fillRect(0, Math.round(yOf(axes[0], height)(tick)), width, 1);
  context.fillRect(0, height - 1, width, 1);
  context.lineWidth = 1.75;
  context.lineJoin = "round";
  for (const axis of axes) {
    const y = yOf(axis, height);
    for (const row of axis.rows) {
      const style = lineStyle(row.rank);
      context.strokeStyle = color[style.color];
      context.setLineDash(style.dash);
      drawLine(context, row.data.line(view.from, view.to, known.until, width, row.every), y);
    }
  }
  context.setLineDash([]);
};
