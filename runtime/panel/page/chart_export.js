// The chart as files: VCD, CSV and PNG.
import {writeCsv} from "./chart_csv.js";
import {drawAxis, drawCursors, drawRows, kAxisHeight, kRowHeight, stateWords, valueAt} from "./chart_draw.js";
import {download} from "./dom.js";
import {fitCanvas, kFont, theme} from "./theme.js";
import {axesOf, lineStyle} from "./trend_axes.js";
import {drawAxes, drawTrends, kAxisWidth} from "./trend_draw.js";
import {writeVcd} from "./vcd.js";

const kNames = 300;  // pixels for the names in a picture

/// Everything that the page knows of the rows, as the ChartView gives them.
export const exportVcd = (app, rows) => {
  const text = writeVcd(app.plant.plant, rows.map(({name, type, device, data}) => ({name, type, times: data.times,
    values: type === "state" ? data.values.map((value) => stateWords(device, value).replace(" → ", "->")) : data.values})));
  download(new Blob([text], {type: "text/plain"}), "chart.vcd");
};

/// The same as a table, one line for each time at which something changed.
export const exportCsv = (rows) => {
  const text = writeCsv(rows.map(({name, type, device, data, value}) => ({name, unit: value?.unit ?? "", data,
    text: type === "state" ? (of) => stateWords(device, of) : String})));
  download(new Blob([text], {type: "text/csv"}), "chart.csv");
};

const kRowOfName = 18;  // pixels for the name of a value

const layer = (width, height) => {
  const canvas = document.createElement("canvas");
  return [canvas, fitCanvas(canvas, width, height)];
};

/// What the chart shows, with names and values at cursor A.
export const exportPng = (app, chart) => {
  const {width} = chart;
  const height = chart.height();
  const high = chart.trendHeight();
  const known = {from: chart.model.from, until: chart.model.until};
  const axes = axesOf(chart.values(), chart.view, known.until);
  const left = kNames + axes.length * kAxisWidth;
  const [canvas, context] = layer(left + width, height);
  const color = theme();
  context.fillStyle = color.back;
  context.fillRect(0, 0, left + width, height);
  const add = (x, top, wide, tall, draw) => {
    if (wide === 0 || tall === 0) return;
    const [part, of] = layer(wide, tall);
    draw(of);
    context.drawImage(part, x, top, wide, tall);
  };
  add(left, 0, width, kAxisHeight, (of) => drawAxis(of, chart.view, width));
  add(kNames, kAxisHeight, left - kNames, high, (of) => drawAxes(of, axes, high));
  add(left, kAxisHeight, width, high, (of) => drawTrends(of, axes, chart.view, known, width, high));
  add(left, kAxisHeight + high, width, height - kAxisHeight - high, (of) => drawRows(of, chart.others(), chart.view, known, width));
  add(left, 0, width, height, (of) => drawCursors(of, chart.cursors, app.clock.now(), chart.view, width, height));
  context.font = "12px " + kFont;
  context.textBaseline = "middle";
  const write = (row, x, y) => {
    const value = chart.cursors.A === null ? "" : "   " + valueAt(row, chart.cursors.A);
    context.fillStyle = color.text;
    context.fillText(row.name + value, x, y, kNames - x - 8);
  };
  const values = chart.values();
  const rowOfName = Math.min(kRowOfName, high / Math.max(1, values.length));
  values.forEach((row, i) => {
    const y = kAxisHeight + (i + .5) * rowOfName;
    const style = lineStyle(row.rank);
    context.strokeStyle = color[style.color];
    context.lineWidth = 2;
    context.setLineDash(style.dash);
    context.beginPath();
    context.moveTo(8, y);
    context.lineTo(32, y);
    context.stroke();
    write(row, 40, y);
  });
  context.setLineDash([]);
  chart.others().forEach((row, i) => write(row, 8, kAxisHeight + high + (i + .5) * kRowHeight));
  canvas.toBlob((blob) => download(blob, "chart.png"), "image/png");
};
