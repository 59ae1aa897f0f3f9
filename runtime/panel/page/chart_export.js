// The changes of the chart's rows as files: VCD and CSV.
import {writeCsv} from "./chart_csv.js";
import {stateWords} from "./chart_rows.js";
import {download} from "./dom.js";
import {writeVcd} from "./vcd.js";

/// Everything that the page knows of the rows, as describeRows() makes them.
export const exportVcd = (app, rows) => {
  const text = writeVcd(app.plant.plant, rows.map(({name, unit, type, device, data}) => ({name, unit, type, times: data.times,
    values: type === "state" ? data.values.map((value) => stateWords(device, value).replace(" → ", "->")) : data.values})));
  download(new Blob([text], {type: "text/plain"}), "chart.vcd");
};

/// The same as a table, one line for each time at which something changed.
export const exportCsv = (rows) => {
  const text = writeCsv(rows.map(({name, unit, type, device, data}) => ({name, unit, data,
    text: type === "state" ? (of) => stateWords(device, of) : String})));
  download(new Blob([text], {type: "text/csv"}), "chart.csv");
};
