// Value change dump of rows of the chart, for waveform viewers. Names and states are written as `symplant run --vcd` does.

const kTypes = {BOOL: ["wire", 1], REAL: ["real", 64], LREAL: ["real", 64]};

/// Short identifiers of printable characters: "!", "\"", ... "!!".
export const identifier = (index) => {
  let text = "";
  for (let rest = index + 1; rest > 0; rest = Math.floor((rest - 1) / 94)) text += String.fromCharCode(33 + (rest - 1) % 94);
  return text;
};

const hex = (number, digits) => number.toString(16).toUpperCase().padStart(digits, "0");

/// Letters that are not ASCII become u00FC, what VCD has no place for becomes _.
export const vcdName = (name) => [...name].map((letter) => {
  const code = letter.codePointAt(0);
  if (code > 126) return "u" + hex(code, 4);
  return /[A-Za-z0-9_.]/.test(letter) ? letter : "_";
}).join("");

/// A string value: bytes that are not printable ASCII as \xC3.
export const vcdText = (text) => [...new TextEncoder().encode(text)].map((byte) =>
  byte > 32 && byte < 127 && byte !== 92 ? String.fromCharCode(byte) : "\\x" + hex(byte, 2)).join("");

const binary = (value) => BigInt.asUintN(64, BigInt(value)).toString(2);

const valueLine = ([kind], value, id) => {
  if (kind === "wire") return (value === true ? "1" : "0") + id;
  if (kind === "string") return "s" + vcdText(value) + " " + id;
  if (kind === "real") return "r" + (Number.isFinite(Number(value)) ? Number(value) : 0) + " " + id;
  return "b" + binary(value) + " " + id;
};

/// `rows`: { name, unit, type, times, values } each; type is BOOL, REAL, LREAL, another one of integers, or "state" for texts.
export const writeVcd = (plant, rows) => {
  const types = rows.map(({type}) => type === "state" ? ["string", 1] : kTypes[type] ?? ["integer", 64]);
  const lines = ["$timescale 1 ns $end", "$scope module " + vcdName(plant) + " $end",
    ...rows.filter(({unit}) => unit).map(({name, unit}) => "$comment " + vcdName(name) + " is in " + vcdText(unit) + " $end"),
    ...rows.map(({name}, i) => "$var " + types[i].join(" ") + " " + identifier(i) + " " + vcdName(name) + " $end"),
    "$upscope $end", "$enddefinitions $end"];
  const changes = rows.flatMap(({times, values}, row) => times.map((t, i) => [t, row, values[i]]));
  changes.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  let now = null;
  for (const [t, row, value] of changes) {
    if (t !== now) lines.push("#" + t);
    now = t;
    lines.push(valueLine(types[row], value, identifier(row)));
  }
  return lines.join("\n") + "\n";
};
