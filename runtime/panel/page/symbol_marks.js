// Marks of symbols: that one is inverted.
import {hidden, make} from "./dom.js";

const kInverted = "inverted: its bit is 0 when it is on";

/// A small mark of an inverted symbol; null for another one.
export const invertedMark = ({inverted}) => inverted
  ? make("span", {class: "inverted", title: kInverted}, make("span", {"aria-hidden": "true"}, "inv"), hidden("inverted")) : null;

/// One mark for several symbols, [text, symbol]: it says which of them are inverted. null if none is.
export const invertedMarkOf = (symbols) => {
  const names = symbols.filter(([, {inverted}]) => inverted).map(([text]) => text).join(", ");
  return names === "" ? null : make("span", {class: "inverted", title: "inverted: " + names}, make("span", {"aria-hidden": "true"}, "inv"),
    hidden(", inverted: " + names));
};
