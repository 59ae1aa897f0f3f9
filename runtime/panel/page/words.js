// Numbers and values as texts.

const trimmed = (number, digits) => String(Number(number.toFixed(digits)));

/// A duration in nanoseconds: "850 ms", "12.3 s", "3 min 5 s".
export const duration = (ns) => {
  const size = Math.abs(ns);
  if (size < 1e3) return ns + " ns";
  if (size < 1e6) return trimmed(ns / 1e3, 1) + " us";
  if (size < 1e9) return trimmed(ns / 1e6, size < 1e7 ? 2 : 1) + " ms";
  if (size < 6e10) return trimmed(ns / 1e9, 3) + " s";
  const seconds = Math.round(size / 1e9);
  const sign = ns < 0 ? "-" : "";
  if (seconds < 3600) return sign + Math.floor(seconds / 60) + " min " + seconds % 60 + " s";
  return sign + Math.floor(seconds / 3600) + " h " + Math.floor(seconds % 3600 / 60) + " min";
};

/// A plant time for a display that runs: "0:00:12.3".
export const clockText = (ns) => {
  const tenths = Math.floor(ns / 1e8);
  const two = (number) => String(number).padStart(2, "0");
  return Math.floor(tenths / 36000) + ":" + two(Math.floor(tenths / 600) % 60) + ":" + two(Math.floor(tenths / 10) % 60)
    + "." + tenths % 10;
};

/// A plant time, rounded to the millisecond: "12.34 s".
export const instant = (ns) => trimmed(ns / 1e9, 3) + " s";

/// A plant time as exact as it is known, to the nanosecond.
export const exactInstant = (ns, digits = 9) => trimmed(ns / 1e9, digits) + " s";

/// A sentence of the plant with its times rounded to the millisecond.
export const withRoundTimes = (text) => text.replace(/\d+\.\d{4,}(?= s\b)/g, (number) => trimmed(Number(number), 3));

/// A length in micrometers: "300 mm", "1.5 m".
export const length = (um) => um === 0 ? "0" : Math.abs(um) < 1e6 ? trimmed(um / 1e3, 1) + " mm" : trimmed(um / 1e6, 3) + " m";

/// A speed in micrometers per second.
export const speed = (um) => trimmed(um / 1e6, 3) + " m/s";

/// Whether a value of a symbol means on: its bit, turned round if it is inverted, or a number that is not 0.
export const isOn = ({inverted}, of) => inverted ? of === false : of !== false && of !== 0;

/// The value of a symbol: a number, or what its bit means.
export const value = (of, symbol) => typeof of !== "boolean" ? String(of) : isOn(symbol, of) ? "on" : "off";

/// value(), of an inverted symbol with the bit that the PLC sees: "on (bit 0)".
export const valueWithBit = (of, symbol) => value(of, symbol) + (typeof of === "boolean" && symbol.inverted ? " (bit " + Number(of) + ")" : "");

/// What a BOOL symbol can be, as [text, bit]: on, then off.
export const levels = (symbol) => [!symbol.inverted, Boolean(symbol.inverted)].map((bit) => [value(bit, symbol), bit]);

/// A count with its noun: "1 device", "2 devices".
export const count = (number, noun) => number + " " + noun + (number === 1 ? "" : "s");

export const factor = (number) => number === "max" ? "as fast as possible" : trimmed(number, 2) + " x";

/// The value of an input field for a symbol: `{ value }` or `{ error }`. Integers beyond 2^53 stay texts.
export const readValue = (text, type) => {
  const trimmedText = text.trim();
  if (type === "BOOL") {
    if (/^(on|true|1)$/i.test(trimmedText)) return {value: true};
    if (/^(off|false|0)$/i.test(trimmedText)) return {value: false};
    return {error: "write on or off"};
  }
  if (/^-?\d+$/.test(trimmedText)) {
    const number = Number(trimmedText);
    return {value: Number.isSafeInteger(number) ? number : trimmedText};
  }
  if (/^16#[0-9a-f_]+$/i.test(trimmedText) || /^(nan|-?inf)$/i.test(trimmedText)) return {value: trimmedText};
  if (trimmedText !== "" && Number.isFinite(Number(trimmedText))) return {value: Number(trimmedText)};
  return {error: "`" + trimmedText + "` is not a number"};
};

/// A text of at most `most` characters: its middle is left out, since names differ most at their ends.
export const cutMiddle = (text, most) => {
  const letters = [...text];
  if (letters.length <= most) return text;
  const end = Math.ceil((most - 1) / 2);
  return letters.slice(0, most - 1 - end).join("") + "…" + letters.slice(letters.length - end).join("");
};
