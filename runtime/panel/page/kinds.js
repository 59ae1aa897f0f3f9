// Kinds of parts: each has a color, the same everywhere, and its name is always next to it.
import {make, setText} from "./dom.js";

export const kKindColors = 8;

/// The name of a kind's color in the style sheet: "kind3". The ninth kind has that of the first.
export const kindColor = (kind) => "kind" + kind % kKindColors;

/// Shows a kind on an element: its name on its color; null removes both.
export const showKind = (element, kinds, kind) => {
  const color = kind === null ? "" : kindColor(kind);
  if ((element.dataset.partKind ?? "") !== color) {
    if (color === "") delete element.dataset.partKind;
    else element.dataset.partKind = color;
  }
  setText(element, kind === null ? "" : kinds[kind]?.name ?? "?");
};

/// The name of a kind on its color.
export const kindChip = (kinds, kind) => {
  const chip = make("span", {class: "kind"});
  showKind(chip, kinds, kind);
  return chip;
};

/// All kinds of the plant with their colors; null if it has none.
export const kindLegend = ({part_kinds: kinds}) => kinds.length === 0 ? null
  : make("div", {class: "row kinds", role: "group", "aria-label": "Kinds of parts"}, make("span", {class: "soft"}, "Kinds of parts:"),
    kinds.map((_, kind) => kindChip(kinds, kind)));
