// The set point of a numeric symbol: a slider and a field that set it, and force. The type of the symbol limits the slider.
import {actButton} from "./acts.js";
import {numberControl} from "./value_control.js";
import {readValue} from "./words.js";

const kFirst = 100;  // the end of the slider until a number is larger
const kSteps = 1000;
const kMost = {SINT: 127, USINT: 255, BYTE: 255, INT: 32767, UINT: 65535, WORD: 65535, DINT: 2147483647, UDINT: 4294967295, DWORD: 4294967295};
const kUnsigned = /^(U.*|BYTE|L?D?WORD)$/;

/// The range of a slider for a number of a type without limits in the symbol list: from 0, or as far below it, to 1, 2 or
/// 5 times a power of ten. null for a number that a slider cannot show exactly.
export const spanOf = (number, type) => {
  if (!Number.isFinite(number) || Math.abs(number) > Number.MAX_SAFE_INTEGER) return null;
  const size = Math.max(kFirst, Math.abs(number));
  const power = 10 ** Math.floor(Math.log10(size));
  const end = [1, 2, 5, 10].map((times) => times * power).find((most) => most >= size);
  const max = Math.min(end, kMost[type] ?? end);
  return {min: number < 0 && !kUnsigned.test(type) ? -max : 0, max, step: /REAL$/.test(type) ? max / kSteps : Math.max(1, Math.round(max / kSteps))};
};

/// The wider one of two ranges: a slider that is shown does not shrink.
const wider = (a, b) => a && b ? {min: Math.min(a.min, b.min), max: Math.max(a.max, b.max), step: Math.max(a.step, b.step)} : b;

/// The control, with a button `force` that forces the number of its field. `update()` after each change. Without `settable` there is no slider.
export const setPoint = (app, index, result, settable) => {
  const symbol = app.plant.symbols[index];
  let span = null;
  const number = () => Number(app.store.values[index]);
  const range = () => { span = wider(span, spanOf(number(), symbol.type)); return span; };
  const read = (text) => {
    const {value, error} = readValue(text, symbol.type);
    if (error) throw new Error(error);
    return value;
  };
  const source = {key: () => index, name: () => symbol.name, unit: () => symbol.type, isSettable: () => true, may: () => app.may("symbols", index), range: settable ? range : () => null,
    number, text: () => String(app.store.values[index]), read, set: (value) => ({set: {[symbol.name]: value}})};
  const control = numberControl(app, source, result, settable);
  const force = actButton(app, result, "Force", () => ({force: {[symbol.name]: read(control.input.value)}}), {"aria-label": "Force " + symbol.name});
  return {...control, force};
};
