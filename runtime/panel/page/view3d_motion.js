// Where a device is between its states at a plant time. Pure functions, without three.js.

/// Mixes what each state has by the progress of the move: `of[state]` are numbers.
export const stateBetween = (store, index, now, of) => {
  const from = of[store.state[index]] ?? 0;
  const to = of[store.target[index]] ?? from;
  return from === to ? from : from + (to - from) * store.progress(index, now).done;
};
