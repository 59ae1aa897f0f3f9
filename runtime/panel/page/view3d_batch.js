// Many solids that are drawn in one call: their triangles are in one buffer, lit and colored here, so that the graphics need neither lights nor
// one call a solid. This is fast without a graphics card, too.
import {BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, MeshBasicMaterial, Sphere, Vector3, VertexColors} from "./build/three.module.js";
import {kSame} from "./view3d_affine.js";

const kLight = [.35, .85, .4];  // where light comes from
const shade = (x, y, z) => {
  const toward = (x * kLight[0] + y * kLight[1] + z * kLight[2]) / Math.hypot(...kLight) / (Math.hypot(x, y, z) || 1);
  return .62 + .38 * toward;
};

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
    slot.matrix = matrix;
    this.write(slot);
  }

  paint(slot, color) {
    if (slot.color === color) return;
    slot.color = color;
    this.write(slot);
  }

  write({first, solid: {positions, normals}, color, matrix: m}) {
    const to = this.positions.array;
    const tint = this.colors.array;
    for (let i = 0, at = first * 3; i < positions.length; i += 3, at += 3) {
      const [x, y, z] = [positions[i], positions[i + 1], positions[i + 2]];
      to[at] = m[0] * x + m[1] * y + m[2] * z + m[3];
      to[at + 1] = m[4] * x + m[5] * y + m[6] * z + m[7];
      to[at + 2] = m[8] * x + m[9] * y + m[10] * z + m[11];
      const [nx, ny, nz] = [normals[i], normals[i + 1], normals[i + 2]];
      const light = shade(m[0] * nx + m[1] * ny + m[2] * nz, m[4] * nx + m[5] * ny + m[6] * nz, m[8] * nx + m[9] * ny + m[10] * nz);
      tint[at] = color[0] * light;
      tint[at + 1] = color[1] * light;
      tint[at + 2] = color[2] * light;
    }
    this.positions.needsUpdate = true;
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
