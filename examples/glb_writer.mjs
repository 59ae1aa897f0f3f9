// Writes GLB files of boxes and cylinders: one cube and one cylinder for each color, which nodes place and scale.

/// A box on the height y around x and z; `size` is width, height, depth.
export const box = (name, color, [x, y, z], size) => ({name, mesh: "box " + color, translation: [x, y, z], scale: size});

/// An upright cylinder; `size` is diameter, height, diameter. `turn`: degrees about x, y and z (one of them).
export const cylinder = (name, color, [x, y, z], size, turn = null) => ({name, mesh: "cylinder " + color, translation: [x, y, z], scale: size, ...(turn ? {rotation: quaternion(turn)} : {})});

/// Nodes that move together.
export const group = (name, translation, children) => ({name, translation, children});

const round = (value) => Math.round(value * 1e6) / 1e6;

const quaternion = (degrees) => {
  const half = degrees.map((each) => each * Math.PI / 360);
  return [...half.map((each) => round(Math.sin(each))), round(half.reduce((product, each) => product * Math.cos(each), 1))];
};

const cubeFaces = [[0, 1], [0, -1], [1, 1], [1, -1], [2, 1], [2, -1]];

/// A cube of the size 1 on the floor: { positions, normals, indices }.
const cube = () => {
  const shape = {positions: [], normals: [], indices: []};
  for (const [axis, sign] of cubeFaces) {
    const first = shape.positions.length / 3;
    for (const [a, b] of [[-.5, -.5], [.5, -.5], [.5, .5], [-.5, .5]]) {
      const point = [0, 0, 0];
      point[axis] = sign * .5;
      point[(axis + 1) % 3] = a * sign;
      point[(axis + 2) % 3] = b;
      shape.positions.push(point[0], point[1] + .5, point[2]);
      shape.normals.push(...[0, 1, 2].map((k) => k === axis ? sign : 0));
    }
    shape.indices.push(...[0, 1, 2, 0, 2, 3].map((corner) => first + corner));
  }
  return shape;
};

/// A cylinder of the diameter and height 1 on the floor.
const tube = (sides = 20) => {
  const shape = {positions: [], normals: [], indices: []};
  const add = (x, y, z, normal) => {
    shape.positions.push(...[x, y, z].map(round));
    shape.normals.push(...normal.map(round));
  };
  for (let i = 0; i <= sides; ++i) {
    const angle = i / sides * 2 * Math.PI;
    const [x, z] = [Math.cos(angle), Math.sin(angle)];
    for (const y of [0, 1]) add(x / 2, y, z / 2, [x, 0, z]);
    if (i < sides) shape.indices.push(...[0, 1, 2, 1, 3, 2].map((corner) => i * 2 + corner));
  }
  for (const y of [0, 1]) {
    const middle = shape.positions.length / 3;
    add(0, y, 0, [0, y * 2 - 1, 0]);
    for (let i = 0; i <= sides; ++i) {
      const angle = i / sides * 2 * Math.PI;
      add(Math.cos(angle) / 2, y, Math.sin(angle) / 2, [0, y * 2 - 1, 0]);
      if (i < sides) shape.indices.push(middle, ...(y === 1 ? [middle + i + 2, middle + i + 1] : [middle + i + 1, middle + i + 2]));
    }
  }
  return shape;
};

const bytesOf = (array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength);
const padded = (bytes, filler) => Buffer.concat([bytes, Buffer.alloc((4 - bytes.length % 4) % 4, filler)]);

export class Glb {
  /// `colors`: by name, [red, green, blue] and maybe the opacity, 0 to 1.
  constructor(colors) {
    this.colors = Object.entries(colors);
    this.json = {asset: {version: "2.0", generator: "make_models.mjs"}, scene: 0, scenes: [{nodes: [0]}], nodes: [], meshes: [], materials: [], accessors: [], bufferViews: [], buffers: []};
    this.pieces = [];
    this.size = 0;
    this.meshes = new Map();
    this.shapes = new Map();
  }

  view(array, target) {
    const bytes = padded(bytesOf(array), 0);
    this.json.bufferViews.push({buffer: 0, byteOffset: this.size, byteLength: array.byteLength, target});
    this.pieces.push(bytes);
    this.size += bytes.length;
    return this.json.bufferViews.length - 1;
  }

  vectors(numbers) {
    const each = (k) => numbers.filter((_, i) => i % 3 === k);
    this.json.accessors.push({bufferView: this.view(Float32Array.from(numbers), 34962), componentType: 5126, count: numbers.length / 3, type: "VEC3",
      min: [0, 1, 2].map((k) => Math.fround(Math.min(...each(k)))), max: [0, 1, 2].map((k) => Math.fround(Math.max(...each(k))))});
    return this.json.accessors.length - 1;
  }

  shape(kind) {
    if (!this.shapes.has(kind)) {
      const {positions, normals, indices} = kind === "box" ? cube() : tube();
      const attributes = {POSITION: this.vectors(positions), NORMAL: this.vectors(normals)};
      this.json.accessors.push({bufferView: this.view(Uint16Array.from(indices), 34963), componentType: 5123, count: indices.length, type: "SCALAR"});
      this.shapes.set(kind, {attributes, indices: this.json.accessors.length - 1});
    }
    return this.shapes.get(kind);
  }

  material(name) {
    const found = this.json.materials.findIndex((each) => each.name === name);
    if (found >= 0) return found;
    const [red, green, blue, opacity = 1] = this.colors.find(([key]) => key === name)[1];
    this.json.materials.push({name, pbrMetallicRoughness: {baseColorFactor: [red, green, blue, opacity], metallicFactor: 0, roughnessFactor: .8}, ...(opacity < 1 ? {alphaMode: "BLEND"} : {})});
    return this.json.materials.length - 1;
  }

  mesh(key) {
    if (!this.meshes.has(key)) {
      const [kind, color] = key.split(" ");
      this.json.meshes.push({name: key, primitives: [{...this.shape(kind), material: this.material(color)}]});
      this.meshes.set(key, this.json.meshes.length - 1);
    }
    return this.meshes.get(key);
  }

  /// Adds a tree of nodes; returns the index of its root.
  add({mesh, children = [], ...node}) {
    const index = this.json.nodes.push({...node, ...(mesh ? {mesh: this.mesh(mesh)} : {})}) - 1;
    if (children.length > 0) this.json.nodes[index].children = children.map((child) => this.add(child));
    return index;
  }

  /// The bytes of a file with this root.
  pack(root) {
    this.add(root);
    this.json.buffers.push({byteLength: this.size});
    const chunk = (kind, bytes) => {
      const head = Buffer.alloc(8);
      head.writeUInt32LE(bytes.length, 0);
      head.write(kind, 4, "latin1");
      return Buffer.concat([head, bytes]);
    };
    const chunks = Buffer.concat([chunk("JSON", padded(Buffer.from(JSON.stringify(this.json)), " ")), chunk("BIN\0", Buffer.concat(this.pieces))]);
    const head = Buffer.alloc(12);
    head.write("glTF", 0, "latin1");
    head.writeUInt32LE(2, 4);
    head.writeUInt32LE(12 + chunks.length, 8);
    return Buffer.concat([head, chunks]);
  }
}
