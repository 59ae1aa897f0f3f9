// The chart as files: VCD and PNG.
import {drawAxis, drawCursors, drawRows, kAxisHeight, kRowHeight, stateWords, valueAt} from "./chart_draw.js";
import {download} from "./dom.js";
import {fitCanvas, kFont, theme} from "./theme.js";
import {writeVcd} from "./vcd.js";

const kNames = 300;  // pixels for the names in a picture

/// Everything that the page knows of the rows, as the ChartView gives them.
export const exportVcd = (app, rows) => {
  const text = writeVcd(app.plant.plant, rows.map(({name, type, device, data}) => ({name, type, times: data.times,
    values: type === "state" ? data.values.map((value) => stateWords(device, value).replace(" → ", "->")) : data.values})));
  download(new Blob([text], {type: "text/plain"}), "chart.vcd");
};

const layer = (width, height) => {
  const canvas = document.createElement("canvas");
  return [canvas, fitCanvas(canvas, width, height)];
};

/// What the chart shows, with names and values at cursor A.
export const exportPng = (app, chart) => {
  const rows = chart.rows();
  const {width} = chart;
  const height = chart.height();
  const [canvas, context] = layer(kNames + width, height);
  const color = theme();
  context.fillStyle = color.back;
  context.fillRect(0, 0, kNames + width, height);
  const add = (top, high, draw) => {
    const [part, of] = layer(width, high);
    draw(of);
    context.drawImage(part, kNames, top, width, high);
  };
  add(0, kAxisHeight, (of) => drawAxis(of, chart.view, width));
  add(kAxisHeight, height - kAxisHeight, (of) => drawRows(of, rows, chart.view, {from: chart.model.from, until: chart.model.until}, width));
  add(0, height, (of) => drawCursors(of, chart.cursors, app.clock.now(), chart.view, width, height));
  context.font = "12px " + kFont;
  context.textBaseline = "middle";
  context.fillStyle = color.text;
  rows.forEach((row, i) => {
    const value = chart.cursors.A === null ? "" : "   " + valueAt(row, chart.cursors.A);
    context.fillText(row.name + value, 8, kAxisHeight + (i + .5) * kRowHeight, kNames - 16);
  });
  canvas.toBlob((blob) => download(blob, "chart.png"), "image/png");
};
