// Boxes without joins on shelves, in their order. Pure functions, without elements.

const kGap = 2;

/// Places boxes { w, h } in rows of at most `wide`. Returns { w, h, at: [[x, y]], heights: of the row of each box }.
export const shelves = (boxes, wide) => {
  const at = [];
  const heights = [];
  let x = 0;
  let y = 0;
  let high = 0;
  let most = 0;
  let first = 0;
  const end = () => {
    for (let i = first; i < at.length; ++i) heights[i] = high;
    first = at.length;
  };
  for (const {w, h} of boxes) {
    if (x > 0 && x + w > wide + 1e-9) {
      end();
      y += high + kGap;
      x = high = 0;
    }
    at.push([x, y]);
    x += w + kGap;
    most = Math.max(most, x - kGap);
    high = Math.max(high, h);
  }
  end();
  return {w: most, h: boxes.length > 0 ? y + high : 0, at, heights};
};

/// Widths of shelves that are worth a try: of one row, two rows and so on.
export const shelfWidths = (boxes) => {
  const all = boxes.reduce((sum, {w}) => sum + w + kGap, 0);
  const widest = Math.max(0, ...boxes.map(({w}) => w));
  const widths = new Set();
  for (let rows = 1; rows <= boxes.length; rows = Math.max(rows + 1, Math.floor(rows * 1.2))) widths.add(Math.max(widest, all / rows));
  return [...widths];
};
