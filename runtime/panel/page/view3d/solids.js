// Simple solids as lists of triangles: { positions, normals }, each nine numbers a triangle. Pure functions, without three.js.
import {pointAt} from "./affine.js";

const kSides = 12;  // of a cylinder

const solid = (triangles) => {
  const positions = new Float32Array(triangles.length * 9);
  const normals = new Float32Array(triangles.length * 9);
  triangles.forEach(({points, normal}, i) => points.forEach((point, k) => {
    positions.set(point, i * 9 + k * 3);
    normals.set(normal, i * 9 + k * 3);
  }));
  return {positions, normals};
};

const quad = ([a, b, c, d], normal) => [{points: [a, b, c], normal}, {points: [a, c, d], normal}];

/// A box on the height `y`, around `x` and `z`.
export const box = (x, y, z, wide, high, deep) => {
  const [left, right, front, back, top] = [x - wide / 2, x + wide / 2, z + deep / 2, z - deep / 2, y + high];
  return solid([
    ...quad([[left, y, front], [right, y, front], [right, top, front], [left, top, front]], [0, 0, 1]),
    ...quad([[right, y, back], [left, y, back], [left, top, back], [right, top, back]], [0, 0, -1]),
    ...quad([[left, y, back], [left, y, front], [left, top, front], [left, top, back]], [-1, 0, 0]),
    ...quad([[right, y, front], [right, y, back], [right, top, back], [right, top, front]], [1, 0, 0]),
    ...quad([[left, top, front], [right, top, front], [right, top, back], [left, top, back]], [0, 1, 0]),
    ...quad([[left, y, back], [right, y, back], [right, y, front], [left, y, front]], [0, -1, 0])]);
};

/// A cylinder, or a cone that ends with another radius, upright on the height `y`.
export const cylinder = (x, y, z, radius, high, end = radius, sides = kSides) => {
  const triangles = [];
  const at = (i, r, height) => [x + r * Math.cos(i / sides * 2 * Math.PI), height, z - r * Math.sin(i / sides * 2 * Math.PI)];
  for (let i = 0; i < sides; ++i) {
    const middle = (i + .5) / sides * 2 * Math.PI;
    triangles.push(...quad([at(i, radius, y), at(i + 1, radius, y), at(i + 1, end, y + high), at(i, end, y + high)], [Math.cos(middle), 0, -Math.sin(middle)]),
      {points: [at(i, end, y + high), at(i + 1, end, y + high), [x, y + high, z]], normal: [0, 1, 0]},
      {points: [at(i + 1, radius, y), at(i, radius, y), [x, y, z]], normal: [0, -1, 0]});
  }
  return solid(triangles);
};

/// A solid moved and turned by a matrix without sizes.
export const moved = (matrix, {positions, normals}) => {
  const result = {positions: new Float32Array(positions.length), normals: new Float32Array(normals.length)};
  const [ox, oy, oz] = pointAt(matrix, 0, 0, 0);
  for (let i = 0; i < positions.length; i += 3) {
    result.positions.set(pointAt(matrix, ...positions.subarray(i, i + 3)), i);
    const [x, y, z] = pointAt(matrix, ...normals.subarray(i, i + 3));
    result.normals.set([x - ox, y - oy, z - oz], i);
  }
  return result;
};

/// Several solids as one.
export const joined = (...solids) => {
  const join = (key) => {
    const all = new Float32Array(solids.reduce((sum, each) => sum + each[key].length, 0));
    let at = 0;
    for (const each of solids) {
      all.set(each[key], at);
      at += each[key].length;
    }
    return all;
  };
  return {positions: join("positions"), normals: join("normals")};
};
