// Which symbols the I/O view shows. Pure functions.
import {SYMBOL} from "./store.js";

export const kLately = 10e9;  // "changed lately" is this plant time

/// { text, direction, lately, forced, unlinked, malfunction, undriven } as a function of a symbol's index.
export const symbolFilter = (filter, store) => {
  const {symbols} = store.plant;
  const words = filter.text.toLowerCase().split(/\s+/).filter((word) => word !== "");
  const texts = words.length > 0 ? symbols.map(({name, address, comment}) => (name + " " + (address ?? "") + " " + (comment ?? "")).toLowerCase()) : null;
  return (index) => {
    const symbol = symbols[index];
    if (filter.direction && symbol.direction !== filter.direction) return false;
    if (filter.forced && !(store.symbolFlags[index] & SYMBOL.forced)) return false;
    if (filter.malfunction && !(store.symbolFlags[index] & SYMBOL.malfunction)) return false;
    if (filter.unlinked && symbol.link !== null) return false;
    if (filter.undriven && symbol.driver !== "none") return false;
    if (filter.lately && !(store.symbolSince[index] > 0 && store.t - store.symbolSince[index] <= kLately)) return false;
    return texts === null || words.every((word) => texts[index].includes(word));
  };
};

/// The indexes of the symbols that pass.
export const filterSymbols = (filter, store) => {
  const passes = symbolFilter(filter, store);
  const found = [];
  for (let index = 0; index < store.plant.symbols.length; ++index) if (passes(index)) found.push(index);
  return found;
};
