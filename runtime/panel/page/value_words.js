// Numbers of values as texts. Without elements.

/// A number with about four digits that count: "21.98", "0.5000", "1234"; "1.23e+7" with three, since it needs room. Numbers of one size have one length, so that a
/// number that changes does not jump.
export const numberText = (number) => {
  const size = Math.abs(number);
  if (Number.isInteger(number) && size < 1e9) return String(number);
  if (size >= 1e6 || size < 1e-3) return number.toExponential(2).replace(/\.?0+e/, "e");
  return number.toFixed(Math.max(0, Math.min(4, 3 - Math.floor(Math.log10(size)))));
};

/// "21.98 l"; "-" if the number is not known
export const withUnit = (number, {unit}) => Number.isNaN(number) ? "-" : numberText(number) + (unit ? " " + unit : "");

/// Whether the page knows the number: a recording has only what its trace shows.
export const isKnown = (plant, value) => plant.mode !== "recording" || value.trace !== null;

/// What the page writes next to the name of a device: the name of its value without that of the device.
export const shortName = ({name}, device) => name.startsWith(device.name + ".") ? name.slice(device.name.length + 1) : name.split(".").pop();

const kNames = {lag: "lag of", delay: "delay of", derivative: "derivative of", integral: "integral of", is: "", linear: "linear in"};

/// The formula as a sentence: "integral of 2 * PUMP.RUN", "ramp toward 3, up 1 and down 2 per second"; "" if it has none.
export const formulaText = ({kind, formulas}) => {
  if (kind === "ramp") return "ramp toward " + formulas[0] + ", up " + formulas[1] + (formulas.length > 2 ? " and down " + formulas[2] : "") + " per second";
  if (kind === "pid") return "pid of " + formulas[0] + " to " + formulas[1];
  return formulas.length === 0 ? "" : ((kNames[kind] ?? kind) + " " + formulas.join("; ")).trim();
};

/// "0 to 120 l", "at least 0 l", "no limits"
export const rangeText = ({min, max, unit}) => {
  const end = unit ? " " + unit : "";
  if (min !== null && max !== null) return min + " to " + max + end;
  return min !== null ? "at least " + min + end : max !== null ? "at most " + max + end : "no limits";
};

/// Whether a bar or a slider can show the value.
export const hasRange = ({min, max}) => min !== null && max !== null && max > min;

/// Where a number is between `min` and `max`, 0 to 1; 0 if it is not known.
export const partOf = ({min, max}, number) => Number.isNaN(number) ? 0 : Math.max(0, Math.min(1, (number - min) / (max - min)));

/// The step of a slider: a power of ten, a hundred to a thousand of them in the range; "any" if they do not end at `max`.
export const sliderStep = ({min, max}) => {
  const step = 10 ** Math.floor(Math.log10((max - min) / 100) + 1e-9);
  const steps = (max - min) / step;
  return Math.abs(steps - Math.round(steps)) < 1e-6 ? step : "any";
};
