// Draws the values of the chart: their lines over one axis of time, with an axis of numbers for each unit.
import {kFont, theme} from "./theme.js";
import {lineStyle} from "./trend_axes.js";
import {numberText} from "./value_words.js";

export const kTrendHeight = 260;
export const kAxisWidth = 58;  // of an axis of numbers
const kPad = 10;

const yOf = (axis, height) => (number) => kPad + (axis.to - number) / (axis.to - axis.from) * (height - 2 * kPad);

/// The numbers of a tick, as exact as the distance of two ticks needs.
const tickText = (number, {ticks: all}) => {
  const step = all.length > 1 ? all[1] - all[0] : 1;
  const digits = Math.max(0, Math.min(9, -Math.floor(Math.log10(step) + 1e-9)));
  return Math.abs(number) >= 1e6 ? numberText(number) : number.toFixed(digits);
};

/// The axes next to the plot, the first one at the right, next to the lines.
export const drawAxes = (context, axes, height) => {
  const color = theme();
  const width = axes.length * kAxisWidth;
  context.clearRect(0, 0, width, height);
  context.font = "11px " + kFont;
  context.textBaseline = "middle";
  axes.forEach((axis, i) => {
    const right = width - i * kAxisWidth - 1;
    const y = yOf(axis, height);
    context.fillStyle = color.line;
    context.fillRect(right, 0, 1, height);
    for (const tick of axis.ticks) {
      context.fillStyle = color.soft;
      context.fillRect(right - 4, Math.round(y(tick)), 4, 1);
      context.textAlign = "right";
      // The unit is above the numbers.
      if (y(tick) > 24 && y(tick) < height - 6) context.fillText(tickText(tick, axis), right - 7, y(tick), kAxisWidth - 10);
    }
    context.fillStyle = color.text;
    context.font = "bold 11px " + kFont;
    context.fillText(axis.unit || "-", right - 7, 9, kAxisWidth - 10);
    context.font = "11px " + kFont;
  });
};

/// The lines of the values. `known` { from, until } is of what there is data.
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
      context.beginPath();
      row.data.line(view.from, view.to, known.until, width, row.value.trace).forEach(([at, number], i) => {
        if (i === 0) context.moveTo(at, y(number));
        else context.lineTo(at, y(number));
      });
      context.stroke();
    }
  }
  context.setLineDash([]);
};
