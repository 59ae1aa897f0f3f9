// The chart as a picture: what it shows, with axes, a legend, and the values at the cursors, at twice the resolution of the page.
import {bandHeight, drawAxis, drawCursors, drawRows, kAxisHeight} from "./chart_draw.js";
import {cursorTable, valueNow} from "./chart_rows.js";
import {download} from "./dom.js";
import {fitCanvas, kFont, theme} from "./theme.js";
import {drawAxes, drawSample, drawTrends, kAxisWidth} from "./trend_draw.js";
import {exactInstant} from "./words.js";

const kRatio = 2;
const kTitle = 26;      // pixels above the chart
const kNames = 270;     // pixels for names, and for each column of values
const kColumn = 110;
const kMostLine = 20;   // pixels for the name of a curve

const layer = (width, height) => {
  const canvas = document.createElement("canvas");
  return [canvas, fitCanvas(canvas, width, height, kRatio)];
};

/// { heads, rows } of the legend: the present values, or those at the cursors if there are any.
const legendOf = (app, chart, rows) => {
  if (chart.cursors.A === null && chart.cursors.B === null) return {heads: ["Row", "Now"], rows: rows.map((row) => [row.name, valueNow(app.store, row)])};
  const {heads, rows: texts} = cursorTable(rows, chart.cursors, chart.model.until);
  return {heads: heads.map((head, i) => i === 0 ? head : head + " " + texts[0][i]), rows: texts.slice(1)};
};

const writeLine = (context, texts, y, indent = 8) => texts.forEach((text, i) => {
  const x = i === 0 ? indent : kNames + (i - 1) * kColumn;
  context.fillText(text, x, y, (i === 0 ? kNames - indent : kColumn) - 8);
});

/// The picture of the chart as a canvas.
export const drawPng = (app, chart) => {
  const {width, view, narrow} = chart;
  const {curves, bands} = chart.shownRows;
  const high = chart.trendHeight();
  const height = chart.height();
  const known = {from: chart.model.from, until: chart.model.until};
  const axes = chart.axes();
  const legend = legendOf(app, chart, chart.rows());
  const names = kNames + (legend.heads.length - 1) * kColumn;
  const left = names + axes.length * kAxisWidth;
  const [canvas, context] = layer(left + width, kTitle + height);
  const color = theme();
  context.fillStyle = color.back;
  context.fillRect(0, 0, left + width, kTitle + height);
  const add = (x, top, wide, tall, draw) => {
    if (wide === 0 || tall === 0) return;
    const [part, of] = layer(wide, tall);
    draw(of);
    context.drawImage(part, x, kTitle + top, wide, tall);
  };
  add(left, 0, width, kAxisHeight, (of) => drawAxis(of, view, width));
  add(names, kAxisHeight, left - names, high, (of) => drawAxes(of, axes, high));
  add(left, kAxisHeight, width, high, (of) => drawTrends(of, axes, view, known, width, high));
  add(left, kAxisHeight + high, width, height - kAxisHeight - high, (of) => drawRows(of, bands, view, known, width, narrow));
  add(left, 0, width, height, (of) => drawCursors(of, chart.cursors, app.clock.now(), view, width, height));
  context.textBaseline = "middle";
  context.fillStyle = color.text;
  context.font = "bold 14px " + kFont;
  context.fillText(app.plant.plant + ", " + exactInstant(Math.max(0, view.from), 3) + " to " + exactInstant(view.to, 3), 8, kTitle / 2, left + width - 16);
  context.font = "bold 11px " + kFont;
  writeLine(context, legend.heads, kTitle + kAxisHeight / 2);
  context.font = "12px " + kFont;
  const line = Math.min(kMostLine, high / Math.max(1, curves.length));
  chart.rows().forEach((row, i) => {
    const y = kTitle + kAxisHeight + (row.isCurve ? (i + .5) * line : high + (i - curves.length + .5) * bandHeight(narrow));
    if (row.isCurve) drawSample(context, row.rank, 8, y, 28);
    writeLine(context, legend.rows[i], y, row.isCurve ? 44 : 8);
  });
  return canvas;
};

export const exportPng = (app, chart) => drawPng(app, chart).toBlob((blob) => download(blob, "chart.png"), "image/png");
