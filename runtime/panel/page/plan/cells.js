// The cells of a frame: devices, and symbols that a person operates, in rows and columns. Pure functions, without elements.

export const kPitch = 2;   // grid units between two cells: a symbol of one unit with its label
export const kHead = 1.5;    // above the first row, for the name of the frame
export const kSide = .5;   // left and right of the cells
export const kFoot = .5;   // below the last row

/// The cell of a symbol with its texts and badges.
export const cellOf = ({x, y}) => ({x: x - kPitch / 2, y: y - .55, w: kPitch, h: kPitch});

/// Centers (or null), moved together so that none is left of or above the cells of its frame.
export const shiftInto = (centers) => {
  const cells = centers.filter((center) => center).map(([x, y]) => cellOf({x, y}));
  const [left, top] = [Math.min(0, ...cells.map(({x}) => x)), Math.min(0, ...cells.map(({y}) => y))];
  const [dx, dy] = [left < 0 ? kSide - left : 0, top < 0 ? kHead - top : 0];
  return centers.map((center) => center && [center[0] + dx, center[1] + dy]);
};

/// The width of a frame with so many columns.
export const widthOf = (columns) => columns * kPitch + 2 * kSide;

/// How many columns `count` cells have in a block of this shape (width / height).
export const columnsFor = (count, shape) => Math.max(1, Math.round(Math.sqrt(count * shape)));

/// The centers of cells, row by row from a corner: [x, y].
export const gridCells = (count, columns, x, y) => Array.from({length: count}, (_, i) =>
  [x + (i % columns + .5) * kPitch, y + (Math.floor(i / columns) + .5) * kPitch]);

/// Free cells near what things act on: `wants` has the wished x of each thing, or null; `rows` are heights from the nearest one on. Returns the
/// centers, things without a wish in the order of `order` (rows from the top).
export const assignCells = (wants, columns, x, rows, order) => {
  const taken = new Set();
  const centers = new Array(wants.length);
  const take = (thing, column, row) => {
    taken.add(row * columns + column);
    centers[thing] = [x + (column + .5) * kPitch, rows[row]];
  };
  wants.forEach((wish, thing) => {
    if (wish === null) return;
    let best = null;
    let least = Infinity;
    for (let cell = 0; cell < columns * rows.length; ++cell) {
      const off = Math.abs(x + (cell % columns + .5) * kPitch - wish) + kPitch * Math.floor(cell / columns);
      if (off < least && !taken.has(cell)) [best, least] = [cell, off];
    }
    take(thing, best % columns, Math.floor(best / columns));
  });
  let next = 0;
  wants.forEach((wish, thing) => {
    if (centers[thing]) return;
    while (taken.has(order[Math.floor(next / columns)] * columns + next % columns)) ++next;
    take(thing, next % columns, order[Math.floor(next / columns)]);
  });
  return centers;
};

const key = (x, y) => Math.floor(x / kPitch) + "," + Math.floor(y / kPitch);

/// Centers for things of which some have a given center ([x, y], else null): the others fill free cells in `columns` columns. `isFree(x, y)`: whether
/// a symbol may be there.
export const fillCells = (given, columns, x, y, isFree = () => true) => {
  const near = new Map();
  const add = ([cx, cy]) => {
    const at = key(cx, cy);
    if (near.has(at)) near.get(at).push([cx, cy]);
    else near.set(at, [[cx, cy]]);
  };
  given.filter((center) => center).forEach(add);
  const collides = (cx, cy) => {
    for (const dx of [-kPitch, 0, kPitch]) for (const dy of [-kPitch, 0, kPitch]) {
      for (const [ox, oy] of near.get(key(cx + dx, cy + dy)) ?? []) if (Math.abs(ox - cx) < kPitch && Math.abs(oy - cy) < kPitch) return true;
    }
    return false;
  };
  let next = 0;
  return given.map((center) => {
    if (center) return center;
    for (;; ++next) {
      const cx = x + (next % columns + .5) * kPitch;
      const cy = y + (Math.floor(next / columns) + .5) * kPitch;
      if (collides(cx, cy) || !isFree(cx, cy)) continue;
      ++next;
      return [cx, cy];
    }
  });
};
