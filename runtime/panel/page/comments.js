// Comments of symbols and of devices, as texts. Without elements.

/// The words with which all comments begin, without signs at the end; "" if they have none in common. Empty ones do not count.
export const commonWords = (comments) => {
  const lists = comments.filter((comment) => comment).map((comment) => comment.split(/\s+/));
  if (lists.length === 0) return "";
  let common = 0;
  while (lists.every((words) => common < words.length && words[common] === lists[0][common])) ++common;
  return lists[0].slice(0, common).join(" ").replace(/[\s,;:./_-]+$/u, "");
};

/// The symbols of a device: operations, then events.
export const symbolsOf = ({operations, events}) => [...operations.map(({symbol}) => symbol), ...events];

/// What the comments of a device's symbols have in common: the symbol list has no comments of devices.
export const deviceComment = (plant, device) => commonWords(symbolsOf(device).map((symbol) => plant.symbols[symbol].comment));

/// The comment of what is selected; "" for none.
export const commentOf = (plant, kind, index) => kind === "device" ? deviceComment(plant, plant.devices[index])
  : kind === "symbol" ? plant.symbols[index].comment ?? "" : "";

/// The name of a device with the comments of its symbols, a line each.
export const deviceTitle = (plant, device) => {
  const lines = symbolsOf(device).map((symbol) => plant.symbols[symbol]).filter(({comment}) => comment)
    .map(({name, comment}) => (name.startsWith(device.name) ? name.slice(device.name.length + 1) : name) + ": " + comment);
  return [device.name, ...lines].join("\n");
};
