// How nodes of a model follow the plant: poses by state, by progress and by values, colors by values. Pure functions, without three.js.

const kOwn = new Set(["node", "move", "turn", "color", "from", "to"]);
const kNone = {move: [0, 0, 0], turn: [0, 0, 0]};
const kAxes = {x: 0, y: 1, z: 2};

const mix = (a, b, part) => a.map((value, i) => value + (b[i] - value) * part);

/// Of an entry of `view3d.nodes`: for each state its pose { move, turn } (meters, degrees); null: no state has one.
export const posesOf = (entry, states) => {
  const has = states.some((state) => !kOwn.has(state) && entry[state] !== undefined);
  return has ? states.map((state) => kOwn.has(state) ? kNone : {...kNone, ...entry[state]}) : null;
};

/// Between the poses of a state and a target, `done` 0 to 1. A target that is no state is where the device is.
export const poseBetween = (poses, state, target, done) => {
  const from = poses[state] ?? kNone;
  const to = poses[target] ?? from;
  return {move: mix(from.move, to.move, done), turn: mix(from.turn, to.turn, done)};
};

const along = (axis, amount) => [0, 0, 0].map((_, i) => i === kAxes[axis] ? amount : 0);

/// What a value adds: number * scale + offset, in meters or degrees along or about an axis. A number that is not finite adds nothing.
export const amountOf = ({scale = 1, offset = 0}, number) => Number.isFinite(number) ? number * scale + offset : 0;

/// The pose of an entry with `move` or `turn` by a value. `numberOf(name)`: the number of a value.
export const poseByValue = ({move, turn}, numberOf) => ({
  move: move?.by ? along(move.axis ?? "y", amountOf(move, numberOf(move.by))) : kNone.move,
  turn: turn?.by ? along(turn.axis ?? "y", amountOf(turn, numberOf(turn.by))) : kNone.turn,
});

export const sumOf = (a, b) => ({move: a.move.map((value, i) => value + b.move[i]), turn: a.turn.map((value, i) => value + b.turn[i])});

/// Blue to red by a value between `from` and `to`: [red, green, blue], 0 to 1.
export const heatOf = ({from = 0, to = 1}, number) => {
  const part = Number.isFinite(number) ? Math.max(0, Math.min(1, (number - from) / ((to - from) || 1))) : 0;
  return [Math.min(1, part * 2), 1 - Math.abs(part * 2 - 1) * .85, Math.min(1, 2 - part * 2)].map((value) => .15 + .75 * value);
};

/// The names from a root to each node of a glTF file, joined by "/".
export const pathsOf = ({nodes = [], scenes = [], scene = 0}) => {
  const paths = new Array(nodes.length).fill(null);
  const walk = (index, before) => {
    paths[index] = before + (nodes[index].name ?? "");
    for (const child of nodes[index].children ?? []) walk(child, paths[index] + "/");
  };
  for (const root of scenes[scene]?.nodes ?? []) walk(root, "");
  return paths;
};

/// The index of the node of a path, which may leave out leading ancestors if that is unique; an Error says what is wrong.
export const nodeAt = (paths, path) => {
  const exact = paths.flatMap((each, index) => each === path ? [index] : []);
  const found = exact.length > 0 ? exact : paths.flatMap((each, index) => each?.endsWith("/" + path) ? [index] : []);
  if (found.length === 0) throw new Error("it has no node `" + path + "`");
  if (found.length > 1) throw new Error("it has " + found.length + " nodes `" + path + "`: name more of their ancestors");
  return found[0];
};
