// How nodes of a model follow the plant: poses by state, by progress and by values, colors by values. Pure functions, without three.js.

const kOwn = new Set(["node", "move", "turn", "color", "from", "to"]);
export const kOwnPose = {move: [0, 0, 0], turn: [0, 0, 0]};  // the model's own
const kAxes = {x: 0, y: 1, z: 2};

const mix = (a, b, part) => a.map((value, i) => value + (b[i] - value) * part);

/// Of an entry of `view3d.nodes`: for each state its pose { move, turn } (meters, degrees); null: no state has one.
export const posesOf = (entry, states) => {
  const has = states.some((state) => !kOwn.has(state) && entry[state] !== undefined);
  return has ? states.map((state) => kOwn.has(state) ? kOwnPose : {...kOwnPose, ...entry[state]}) : null;
};

/// Between two poses.
export const mixPoses = (a, b, part) => ({move: mix(a.move, b.move, part), turn: mix(a.turn, b.turn, part)});

const along = (axis, amount) => [0, 0, 0].map((_, i) => i === kAxes[axis] ? amount : 0);

/// The number of a value of a symbol; NaN if it is not known or no number.
export const numberOfSymbol = (value) => value === null || typeof value === "boolean" ? NaN : Number(value);

/// What a value adds: number * scale + offset, in meters or degrees along or about an axis. A number that is not finite adds nothing.
export const amountOf = ({scale = 1, offset = 0}, number) => Number.isFinite(number) ? number * scale + offset : 0;

/// The pose of an entry with `move` or `turn` by a value. `numberOf(name)`: the number of a value.
export const poseByValue = ({move, turn}, numberOf) => ({
  move: move?.by ? along(move.axis ?? "y", amountOf(move, numberOf(move.by))) : kOwnPose.move,
  turn: turn?.by ? along(turn.axis ?? "y", amountOf(turn, numberOf(turn.by))) : kOwnPose.turn,
});

export const sumOf = (a, b) => ({move: a.move.map((value, i) => value + b.move[i]), turn: a.turn.map((value, i) => value + b.turn[i])});

/// Blue to red by a value between `from` and `to`: [red, green, blue], 0 to 1.
export const heatOf = ({from = 0, to = 1}, number) => {
  const part = Number.isFinite(number) ? Math.max(0, Math.min(1, (number - from) / ((to - from) || 1))) : 0;
  return [Math.min(1, part * 2), 1 - Math.abs(part * 2 - 1) * .85, Math.min(1, 2 - part * 2)].map((value) => .15 + .75 * value);
};

/// The nodes of a glTF file: { names, parents }. A parent is the index of the nearest ancestor with a name, null of a node without one, and undefined of a
/// node that its scene does not show.
export const treeOf = ({nodes = [], scenes = [], scene = 0}) => {
  const names = nodes.map(({name}) => name ?? "");
  const parents = new Array(nodes.length).fill(undefined);
  const open = (scenes[scene]?.nodes ?? []).map((index) => [index, null]);
  while (open.length > 0) {
    const [index, parent] = open.pop();
    parents[index] = parent;
    for (const child of nodes[index].children ?? []) open.push([child, names[index] === "" ? parent : index]);
  }
  return {names, parents};
};

/// Whether a node and its ancestors are a path: null, "end" if ancestors are left out, else "whole".
const match = ({names, parents}, node, path) => {
  let end = path.length;
  for (let at = node; at !== null; at = parents[at]) {
    const name = names[at];
    if (name === "" || !path.endsWith(name, end)) return null;
    end -= name.length;
    if (end <= 0) return parents[at] === null ? "whole" : "end";
    if (path[--end] !== "/") return null;
  }
  return null;
};

/// The index of the node of a path: names of ancestors and its own, joined by "/". Leading ancestors may be left out if that is unique, and those without a name
/// are. An Error says what is wrong.
export const nodeAt = (tree, path) => {
  const found = {whole: [], end: []};
  tree.parents.forEach((parent, node) => { if (parent !== undefined) found[match(tree, node, path)]?.push(node); });
  const best = found.whole.length > 0 ? found.whole : found.end;
  if (best.length === 0) throw new Error("it has no node `" + path + "`");
  if (best.length > 1) throw new Error("it has " + best.length + " nodes `" + path + "`: name more of their ancestors");
  return best[0];
};
