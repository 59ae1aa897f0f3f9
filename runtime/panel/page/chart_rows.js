// The rows of the chart with what is needed to draw, read and export them. Without elements.
import {withUnit} from "./value_words.js";
import {count, duration, exactInstant, value as valueText} from "./words.js";

/// "OPEN", or "OPEN → CLOSE" during a move.
export const stateWords = (device, {state, target}) => {
  const name = device.states[state] ?? "?";
  return target !== state && target >= 0 ? name + " → " + (device.states[target] ?? "?") : name;
};

/// Whether a row is a line in the plot: a value, or a symbol that is a number. The others are rows of their own below it.
export const isCurve = (plant, kind, index) => kind === "value" || kind === "symbol" && plant.symbols[index].type !== "BOOL";

const curve = ({plant, names}, {kind, index, data}, rank) => {
  const value = kind === "value" ? plant.values[index] : null;
  const symbol = kind === "symbol" ? plant.symbols[index] : null;
  return {kind, index, data, rank, value, symbol, name: names.name(kind, index), isCurve: true, type: symbol?.type ?? "LREAL", unit: value?.unit ?? "",
    least: value?.min ?? null, most: value?.max ?? null, every: value?.trace ?? 0};
};

const band = ({plant, names}, {kind, index, data}) => ({kind, index, data, name: names.name(kind, index), isCurve: false, unit: "",
  device: kind === "device" ? plant.devices[index] : null, symbol: kind === "symbol" ? plant.symbols[index] : null, type: kind === "symbol" ? "BOOL" : "state"});

/// { curves, bands } of the chosen rows of the model: the lines, then the bits and states, each in the order in which they were chosen.
export const describeRows = (app, rows) => {
  const curves = rows.filter(({kind, index}) => isCurve(app.plant, kind, index));
  return {curves: curves.map((row, rank) => curve(app, row, rank)), bands: rows.filter((row) => !curves.includes(row)).map((row) => band(app, row))};
};

/// The present value of a row, from the state of the plant.
export const valueNow = (store, {kind, index, value, device, symbol}) => kind === "value" ? withUnit(store.numbers[index], value)
  : kind === "device" ? stateWords(device, {state: store.state[index], target: store.target[index]}) : valueText(store.values[index], symbol);

/// The value of a row at a time as text; "-" where nothing is known: before its first entry and after `until`.
export const valueAt = (row, t, until) => {
  const found = t > until ? undefined : row.data.at(t);
  if (found === undefined) return "-";
  if (row.kind === "value") return withUnit(row.data.numberAt(t, row.every), row.value);
  return row.kind === "device" ? stateWords(row.device, found) : valueText(found, row.symbol);
};

/// From cursor A to B: the difference of a curve, the number of changes of a bit or state.
export const differenceText = (row, a, b, until) => {
  if (Math.max(a, b) > until || row.data.at(Math.min(a, b)) === undefined) return "-";
  if (!row.isCurve) return count(row.data.changesBetween(Math.min(a, b), Math.max(a, b)), "change");
  const by = row.data.numberAt(b, row.every) - row.data.numberAt(a, row.every);
  return Number.isFinite(by) ? (by > 0 ? "+" : "") + withUnit(by, row) : "-";
};

/// The table of the cursors: { heads, rows } of texts. Each row begins with its name; the first has the times. Only cursors that are set have a column.
export const cursorTable = (rows, {A, B}, until) => {
  const times = [A, B].filter((t) => t !== null);
  const both = times.length === 2;
  const heads = ["Row", ...(A === null ? [] : ["A"]), ...(B === null ? [] : ["B"]), ...(both ? ["B − A"] : [])];
  const line = (row) => [row.name, ...times.map((t) => valueAt(row, t, until)), ...(both ? [differenceText(row, A, B, until)] : [])];
  return {heads, rows: [["Time", ...times.map((t) => exactInstant(t, 6)), ...(both ? [duration(B - A)] : [])], ...rows.map(line)]};
};

/// "A 1.2 s, B 3.4 s, from A to B 2.2 s"
export const cursorText = ({A, B}) => [A === null ? "" : "A " + exactInstant(A, 6), B === null ? "" : "B " + exactInstant(B, 6),
  A === null || B === null ? "" : "from A to B " + duration(B - A)].filter((words) => words).join(", ");
