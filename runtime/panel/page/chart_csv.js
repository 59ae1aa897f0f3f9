// Changes of rows of the chart as comma-separated values. Without elements.

/// A text of a table. One that begins like a formula gets an apostrophe, so that spreadsheets do not compute it.
const cell = (text) => {
  const safe = /^[=+\-@\t\r]/.test(text) ? "'" + text : text;
  return /[",\n\r]/.test(safe) ? '"' + safe.replaceAll('"', '""') + '"' : safe;
};

/// `rows`: { name, unit, data, text } each; `text(value)` gives a value as text. The first column is plant time in seconds; a line
/// for each time at which a row changed has what all rows were then, empty before the first that is known.
export const writeCsv = (rows) => {
  const times = [...new Set(rows.flatMap(({data}) => data.times))].sort((a, b) => a - b);
  const lines = [["time [s]", ...rows.map(({name, unit}) => name + (unit ? " [" + unit + "]" : ""))].map(cell).join(",")];
  const next = rows.map(() => 0);
  const now = rows.map(() => "");
  for (const t of times) {
    rows.forEach(({data, text}, i) => {
      if (data.times[next[i]] !== t) return;
      const value = data.values[next[i]++];
      now[i] = typeof value === "number" ? String(value) : cell(text(value));
    });
    lines.push([t / 1e9, ...now].join(","));
  }
  return lines.join("\n") + "\n";
};
