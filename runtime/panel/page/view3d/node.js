// A node of a model that entries of `view3d.nodes` move and color: one or several.
import {Box3, Euler, Matrix4, Quaternion, Vector3} from "../build/three.module.js";
import {kOwnPose, sumOf} from "./binding.js";
import {mixed} from "./colors.js";

const kTint = .65;  // of a status on the colors of a model
const kHeat = .9;   // of a color by a value
const kRadians = Math.PI / 180;

export class BoundNode {
  constructor(object) {
    Object.assign(this, {object, bounds: [], meshes: [], colors: [], inner: [], shown: null, box: new Box3()});
    this.position = object.position.clone();
    this.rotation = object.quaternion.clone();
  }

  /// What moves with the node and is of no other one: its box, and separate materials if it has a status or a color. `nodeOf(object)`: the BoundNode
  /// of an object, or nothing. Before parts are below the object.
  own(nodeOf) {
    const toOwn = new Matrix4().getInverse(this.object.matrixWorld);
    const isColored = this.bounds.some(({device, entry}) => device !== null || entry.color?.by);
    const take = (object) => {
      if (object.isMesh) {
        object.geometry.computeBoundingBox();
        this.box.union(object.geometry.boundingBox.clone().applyMatrix4(object.matrixWorld.clone().premultiply(toOwn)));
        if (isColored) this.tint(object);
      }
      for (const child of object.children) {
        const other = nodeOf(child);
        if (other) this.inner.push(other);
        else take(child);
      }
    };
    take(this.object);
    for (const {location, entry: {from, to}} of this.bounds) {
      if (location !== null) for (const end of [from, to ?? from]) this.box.expandByPoint(new Vector3(...end));
    }
    if (this.box.isEmpty() && this.inner.length === 0) this.box.expandByPoint(new Vector3());
  }

  tint(mesh) {
    mesh.material = mesh.material.clone();
    this.meshes.push(mesh);
    this.colors.push(mesh.material.color.toArray());
  }

  /// The box of the node and what is below it, without parts, in the axes of the scene.
  worldBox() {
    this.object.updateWorldMatrix(true, false);
    const box = this.box.clone();
    if (!box.isEmpty()) box.applyMatrix4(this.object.matrixWorld);
    for (const other of this.inner) box.union(other.worldBox());
    return box;
  }

  /// To where it is at plant time `now`: what its entries add, in their order. Returns whether it has moved.
  move(now) {
    const movers = this.bounds.filter(({moves}) => moves);
    if (movers.length === 0) return false;
    const pose = movers.reduce((sum, bound) => sumOf(sum, bound.pose(now)), kOwnPose);
    const key = pose.move.concat(pose.turn).join();
    if (key === this.shown) return false;
    this.shown = key;
    this.object.position.set(...pose.move).add(this.position);
    this.object.quaternion.setFromEuler(new Euler(...pose.turn.map((degrees) => degrees * kRadians))).multiply(this.rotation);
    this.object.updateMatrix();
    return true;
  }

  /// `colorOf(device)`: the color of a device's status, or null. The first color counts, one by a value before that of a status.
  paint(colorOf) {
    const first = (colors) => colors.find((color) => color !== null) ?? null;
    const heat = first(this.bounds.map((bound) => bound.heat()));
    const own = heat ?? first(this.bounds.map(({device}) => device === null ? null : colorOf(device)));
    this.meshes.forEach(({material}, i) => material.color.setRGB(...(own ? mixed(this.colors[i], own, heat ? kHeat : kTint) : this.colors[i])));
  }
}
