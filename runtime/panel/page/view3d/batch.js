// Many solids that are drawn in one call: their triangles are in one buffer, lit and colored here, so that the graphics need neither lights nor
// one call a solid. This is fast without a graphics card, too.
import {BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, MeshBasicMaterial, Sphere, Vector3, VertexColors} from "../build/three.module.js";
import {kSame} from "./affine.js";

const kLight = [.35, .85, .4].map((value) => value / Math.sqrt(.35 * .35 + .85 * .85 + .4 * .4));  // where light comes from
const [kDark, kBright] = [.62, .38];

/// How bright a face is after a matrix.
const lightOn = (m, x, y, z) => {
  const nx = m[0] * x + m[1] * y + m[2] * z;
  const ny = m[4] * x + m[5] * y + m[6] * z;
  const nz = m[8] * x + m[9] * y + m[10] * z;
  const length = Math.sqrt(nx * nx + ny * ny + nz * nz) || 1;
  return kDark + kBright * (nx * kLight[0] + ny * kLight[1] + nz * kLight[2]) / length;
};

/// Whether both turn and stretch alike: then the light is the same.
const turnsAlike = (a, b) => a[0] === b[0] && a[1] === b[1] && a[2] === b[2] && a[4] === b[4] && a[5] === b[5] && a[6] === b[6] && a[8] === b[8] && a[9] === b[9] && a[10] === b[10];

export class Batch {
  constructor(kept = {}) {
    this.slots = [];
    this.size = 0;
    this.material = new MeshBasicMaterial({vertexColors: VertexColors, ...kept});
    this.mesh = new Mesh(new BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
  }

  /// A slot for a solid. `tag` is what it belongs to. It is seen after finish().
  add(solid, color, matrix = kSame, tag = null) {
    const slot = {first: this.size, solid, color, matrix, tag};
    this.slots.push(slot);
    this.size += solid.positions.length / 3;
    return slot;
  }

  finish() {
    this.positions = new BufferAttribute(new Float32Array(this.size * 3), 3).setUsage(DynamicDrawUsage);
    this.colors = new BufferAttribute(new Float32Array(this.size * 3), 3).setUsage(DynamicDrawUsage);
    this.mesh.geometry.dispose();
    this.mesh.geometry = new BufferGeometry();
    this.mesh.geometry.setAttribute("position", this.positions);
    this.mesh.geometry.setAttribute("color", this.colors);
    this.mesh.geometry.boundingSphere = new Sphere(new Vector3(), Infinity);  // a ray looks at each triangle
    for (const slot of this.slots) this.write(slot);
    return this;
  }

  move(slot, matrix) {
    const isLitAlike = turnsAlike(slot.matrix, matrix);
    slot.matrix = matrix;
    this.place(slot);
    if (!isLitAlike) this.light(slot);
  }

  paint(slot, color) {
    if (slot.color === color) return;
    slot.color = color;
    this.light(slot);
  }

  write(slot) {
    this.place(slot);
    this.light(slot);
  }

  place({first, solid: {positions}, matrix: m}) {
    const to = this.positions.array;
    for (let i = 0, at = first * 3; i < positions.length; i += 3, at += 3) {
      const x = positions[i];
      const y = positions[i + 1];
      const z = positions[i + 2];
      to[at] = m[0] * x + m[1] * y + m[2] * z + m[3];
      to[at + 1] = m[4] * x + m[5] * y + m[6] * z + m[7];
      to[at + 2] = m[8] * x + m[9] * y + m[10] * z + m[11];
    }
    this.positions.needsUpdate = true;
  }

  /// A triangle has one normal.
  light({first, solid: {normals}, color, matrix: m}) {
    const tint = this.colors.array;
    for (let i = 0, at = first * 3; i < normals.length; i += 9) {
      const light = lightOn(m, normals[i], normals[i + 1], normals[i + 2]);
      for (let corner = 0; corner < 3; ++corner, at += 3) {
        tint[at] = color[0] * light;
        tint[at + 1] = color[1] * light;
        tint[at + 2] = color[2] * light;
      }
    }
    this.colors.needsUpdate = true;
  }

  /// The tag of the solid with this triangle.
  tagOf(face) {
    const vertex = face * 3;
    return this.slots.find(({first, solid}) => vertex >= first && vertex < first + solid.positions.length / 3)?.tag ?? null;
  }

  setTranslucent(on) {
    Object.assign(this.material, {transparent: on, opacity: on ? .22 : 1, depthWrite: !on, needsUpdate: true});
  }

  dispose() {
    this.mesh.parent?.remove(this.mesh);
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}
