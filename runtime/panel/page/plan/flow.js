// A layered layout: boxes that pass parts on are in columns from left to right; a long line is folded into rows, every second of which runs to the left.
// Pure functions, without elements. Time: O(r * (n + e) * log n) for n boxes, e edges and at most kMostRows rows r.

const kColumnGap = 2;
const kRowGap = 2;
const kBoxGap = 1;  // between boxes of a column
const kMostRows = 12;
const kLegible = 28;    // grid units in the height of a screen
const kMeanJoin = .4;  // what the mean and the greatest length of a join cost, against the size of the whole
const kLongJoin = .15;

/// Edges without those that close a cycle, each as [from, to], found by a depth-first search that begins at boxes without an incoming edge.
const withoutCycles = (count, edges) => {
  const out = Array.from({length: count}, () => []);
  const incoming = new Int32Array(count);
  for (const [from, to] of edges) {
    if (from === to) continue;
    out[from].push(to);
    incoming[to] += 1;
  }
  const state = new Uint8Array(count);  // 1: on the path, 2: done
  const kept = [];
  const order = [];
  const visit = (root) => {
    const path = [[root, 0]];
    state[root] = 1;
    while (path.length > 0) {
      const top = path[path.length - 1];
      const to = out[top[0]][top[1]++];
      if (to === undefined) {
        state[top[0]] = 2;
        order.push(top[0]);
        path.pop();
      } else if (state[to] !== 1) {
        kept.push([top[0], to]);
        if (state[to] === 0) {
          state[to] = 1;
          path.push([to, 0]);
        }
      }
    }
  };
  for (let box = 0; box < count; ++box) if (incoming[box] === 0) visit(box);
  for (let box = 0; box < count; ++box) if (state[box] === 0) visit(box);
  return {kept, order: order.reverse()};
};

/// The column of each box: after all from which parts come, and a source directly before the first that it feeds.
const columnsOf = (count, edges) => {
  const {kept, order} = withoutCycles(count, edges);
  const after = Array.from({length: count}, () => []);
  const column = new Int32Array(count);
  const hasBefore = new Uint8Array(count);
  for (const [from, to] of kept) {
    after[from].push(to);
    hasBefore[to] = 1;
  }
  for (const box of order) for (const to of after[box]) column[to] = Math.max(column[to], column[box] + 1);
  for (const box of order) if (!hasBefore[box] && after[box].length > 0) column[box] = Math.min(...after[box].map((to) => column[to])) - 1;
  const columns = [];
  for (let box = 0; box < count; ++box) (columns[column[box]] ??= []).push(box);
  return columns.filter((boxes) => boxes);
};

/// Moves boxes, { want, size } in order, apart so that none overlaps the next one; as little as possible. Returns where each begins.
export const spread = (boxes, gap) => {
  const runs = [];
  for (const {want, size} of boxes) {
    let run = {sum: want, count: 1, size, offsets: [0]};
    while (runs.length > 0) {
      const last = runs[runs.length - 1];
      if (last.sum / last.count + last.size + gap <= run.sum / run.count + 1e-9) break;
      runs.pop();
      const shift = last.size + gap;
      run = {sum: last.sum + run.sum - run.count * shift, count: last.count + run.count, size: last.size + gap + run.size,
        offsets: [...last.offsets, ...run.offsets.map((offset) => offset + shift)]};
    }
    runs.push(run);
  }
  return runs.flatMap(({sum, count, offsets}) => offsets.map((offset) => sum / count + offset));
};

/// Where the boxes of a row are: { w, h, at: Map(box -> [x, y]) } with the row's top at 0. `into` are the edges by box: [from, y of both ends].
const placeRow = (nodes, columns, into) => {
  const at = new Map();
  let x = 0;
  let top = Infinity;
  let bottom = -Infinity;
  for (const boxes of columns) {
    const wanted = boxes.map((box) => {
      const ends = into[box].filter(({from}) => at.has(from));
      const want = ends.length === 0 ? -nodes[box].axis : ends.reduce((sum, {from, fy, ty}) => sum + at.get(from)[1] + fy - ty, 0) / ends.length;
      return {box, want, size: nodes[box].h};
    }).sort((a, b) => a.want + a.size / 2 - b.want - b.size / 2 || a.box - b.box);
    const wide = Math.max(...boxes.map((box) => nodes[box].w));
    spread(wanted, kBoxGap).forEach((y, i) => {
      const {box, size} = wanted[i];
      at.set(box, [x, Math.round(y * 2) / 2]);
      top = Math.min(top, Math.floor(y * 2) / 2);
      bottom = Math.max(bottom, Math.ceil((y + size) * 2) / 2);
    });
    x += wide + kColumnGap;
  }
  for (const place of at.values()) place[1] -= top;
  return {w: x - kColumnGap, h: bottom - top, at};
};

/// The columns in about `count` rows of one width.
const fold = (nodes, columns, count) => {
  const widths = columns.map((boxes) => Math.max(...boxes.map((box) => nodes[box].w)) + kColumnGap);
  const most = widths.reduce((sum, width) => sum + width, 0) / count;
  const rows = [];
  let used = Infinity;
  columns.forEach((boxes, i) => {
    if (used + widths[i] / 2 > most * (1 + 1e-9) && (rows.length < count || used === Infinity)) {
      rows.push([]);
      used = 0;
    }
    rows[rows.length - 1].push(boxes);
    used += widths[i];
  });
  return rows;
};

/// Rows under each other; every second one is mirrored and begins where the one above ends.
const stackRows = (nodes, rows, into) => {
  const boxes = new Array(nodes.length);
  let y = 0;
  let left = 0;
  let right = 0;
  let least = Infinity;
  let greatest = -Infinity;
  rows.forEach((columns, index) => {
    const {w, h, at} = placeRow(nodes, columns, into);
    const mirrored = index % 2 === 1;
    if (mirrored) left = right - w;
    else right = left + w;
    for (const [box, [bx, by]] of at) boxes[box] = {x: mirrored ? right - bx - nodes[box].w : left + bx, y: y + by, mirrored};
    least = Math.min(least, left);
    greatest = Math.max(greatest, right);
    y += h + kRowGap;
  });
  for (const box of boxes) box.x -= least;
  return {w: greatest - least, h: y - kRowGap, boxes};
};

const joinCost = (nodes, edges, boxes) => {
  let sum = 0;
  let most = 0;
  for (const {from, to, fy, ty} of edges) {
    const end = boxes[from].x + (boxes[from].mirrored ? 0 : nodes[from].w);
    const begin = boxes[to].x + (boxes[to].mirrored ? nodes[to].w : 0);
    const length = Math.abs(end - begin) + Math.abs(boxes[from].y + fy - boxes[to].y - ty);
    sum += length;
    most = Math.max(most, length);
  }
  return kMeanJoin * sum / Math.max(1, edges.length) + kLongJoin * most;
};

/// What a size costs on a screen of this shape (width / height): how large it is, but little below what is legible on any screen.
export const sizeCost = (shape, w, h) => {
  const size = Math.max(w / shape, h);
  return Math.max(size, kLegible) + .05 * size;
};

/// Places boxes { w, h, axis } (axis: the height at which parts come and go if an edge does not say otherwise) with the edges
/// { from, to, fy, ty } (heights in the boxes at which parts leave and arrive). Returns { w, h, joinCost, boxes: [{ x, y, mirrored }] }.
export const layered = (nodes, edges, shape) => {
  const columns = columnsOf(nodes.length, edges.map(({from, to}) => [from, to]));
  const into = nodes.map(() => []);
  for (const edge of edges) if (edge.from !== edge.to) into[edge.to].push(edge);
  let best = null;
  let least = Infinity;
  for (let count = 1; count <= Math.min(columns.length, kMostRows); ++count) {
    const placed = stackRows(nodes, fold(nodes, columns, count), into);
    placed.joinCost = joinCost(nodes, edges, placed.boxes);
    const cost = sizeCost(shape, placed.w, placed.h) + placed.joinCost;
    if (cost < least - 1e-9) [best, least] = [placed, cost];
  }
  return best;
};
