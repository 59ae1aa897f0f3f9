// Checks of a GLB file: the tree of its nodes.
import {checkIndex, isIndex, listOf, refuse, whole} from "./glb_words.js";

const kMostNodes = 20000;
const kMostDepth = 64;
const kMostVertices = 5000000;
const kMostCalls = 20000;  // pieces that are drawn one by one
const kMostName = 1000;  // bytes
const kFarthest = 1e5;
const kTransforms = {matrix: 16, translation: 3, rotation: 4, scale: 3};

const nameOf = (index, {name}) => "its node " + (typeof name === "string" && name !== "" ? "`" + name.slice(0, 60) + "`" : index);

const checkNode = (index, node, nodes, meshes) => {
  const what = nameOf(index, node);
  if (node.name !== undefined && typeof node.name !== "string") refuse(what + " has an invalid name");
  if (new TextEncoder().encode(node.name ?? "").length > kMostName) refuse(what + " has a name of more than " + whole(kMostName) + " bytes");
  checkIndex(node.mesh, meshes, what);
  for (const [key, length] of Object.entries(kTransforms)) {
    const numbers = node[key];
    if (numbers === undefined) continue;
    if (!Array.isArray(numbers) || numbers.length !== length || !numbers.every((number) => typeof number === "number" && Math.abs(number) <= kFarthest)) {
      refuse(what + " has an invalid `" + key + "`");
    }
  }
  if (node.children !== undefined && !(Array.isArray(node.children) && node.children.every((child) => isIndex(child, nodes.length)))) refuse(what + " has invalid children");
};

/// The parent of each node; null of a root.
const parentsOf = (nodes) => {
  const parents = new Array(nodes.length).fill(null);
  nodes.forEach(({children = []}, index) => {
    for (const child of children) {
      if (parents[child] !== null) refuse(nameOf(child, nodes[child]) + " has two parents");
      parents[child] = index;
    }
  });
  return parents;
};

/// Fails on a cycle, and on a tree that is too deep.
const checkDepths = (nodes, parents) => {
  const depths = new Array(nodes.length).fill(0);
  nodes.forEach((_, index) => {
    const chain = [];
    let at = index;
    for (; at !== null && depths[at] === 0; at = parents[at]) {
      if (chain.length > kMostDepth) {
        if (chain.includes(at)) refuse("its nodes form a cycle at " + nameOf(at, nodes[at]).slice(4));
        refuse("its nodes are nested more than " + kMostDepth + " levels deep");
      }
      chain.push(at);
    }
    let depth = at === null ? 0 : depths[at];
    for (const each of chain.reverse()) depths[each] = ++depth;
    if (depth > kMostDepth) refuse("its nodes are nested more than " + kMostDepth + " levels deep");
  });
};

/// `meshes`: what each draws, { vertices, calls }.
export const checkNodes = (json, meshes) => {
  const nodes = listOf(json, "nodes", kMostNodes);
  const scenes = listOf(json, "scenes", kMostNodes);
  nodes.forEach((node, index) => checkNode(index, node, nodes, meshes));
  const parents = parentsOf(nodes);
  checkDepths(nodes, parents);
  if (!isIndex(json.scene ?? 0, scenes.length)) refuse("it has no scene");
  const roots = scenes[json.scene ?? 0].nodes ?? [];
  if (!Array.isArray(roots) || roots.length === 0 || new Set(roots).size !== roots.length) refuse("its scene has no nodes, or one twice");
  for (const root of roots) {
    if (!isIndex(root, nodes.length)) refuse("its scene names the node " + JSON.stringify(root) + " of " + whole(nodes.length));
    if (parents[root] !== null) refuse(nameOf(root, nodes[root]) + " is in the scene and has a parent");
  }
  const drawnBy = (key) => nodes.reduce((sum, {mesh}) => sum + (mesh === undefined ? 0 : meshes[mesh][key]), 0);
  const drawn = drawnBy("vertices");
  if (drawn === 0) refuse("it has nothing to show");
  if (drawn > kMostVertices) refuse("it draws " + whole(drawn) + " vertices, and " + whole(kMostVertices) + " are possible");
  if (drawnBy("calls") > kMostCalls) refuse("it draws " + whole(drawnBy("calls")) + " pieces, and " + whole(kMostCalls) + " are possible: join meshes of one material");
};
