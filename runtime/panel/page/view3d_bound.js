// A node of a model that is bound to a device, a value, a track or a place.
import {Euler, Quaternion} from "./build/three.module.js";
import {heatOf, poseBetween, poseByValue, posesOf, sumOf} from "./view3d_binding.js";
import {mixed} from "./view3d_colors.js";

const kTint = .65;  // of a status on the colors of a model
const kRadians = Math.PI / 180;

export class Bound {
  /// `device`: its index, or null. `parts`: the batch of a track or place, or null.
  constructor(app, key, entry, object, device) {
    Object.assign(this, {app, key, entry, object, device, meshes: [], colors: [], shown: null, parts: null});
    this.position = object.position.clone();
    this.rotation = object.quaternion.clone();
    this.poses = device === null ? null : posesOf(entry, app.plant.devices[device].states);
    this.byValue = Boolean(entry.move?.by || entry.turn?.by);
    /// Of a value or a numeric symbol.
    this.numberOf = (name) => Number(app.store.numbers[app.names.index("value", name)] ?? app.store.values[app.names.index("symbol", name)] ?? NaN);
  }

  /// What moves with the node and is of no other bound node gets materials of its own.
  own(isBound) {
    const take = (object) => {
      if (object.isMesh) {
        object.material = object.material.clone();
        this.meshes.push(object);
        this.colors.push(object.material.color.toArray());
      }
      for (const child of object.children) if (!isBound(child)) take(child);
    };
    take(this.object);
  }

  /// Returns whether it has moved.
  move(now) {
    if (!this.poses && !this.byValue) return false;
    const {store} = this.app;
    const byState = this.poses ? poseBetween(this.poses, store.state[this.device], store.target[this.device], store.progress(this.device, now).done) : {move: [0, 0, 0], turn: [0, 0, 0]};
    const pose = sumOf(byState, poseByValue(this.entry, this.numberOf));
    const key = pose.move.concat(pose.turn).join();
    if (key === this.shown) return false;
    this.shown = key;
    this.object.position.set(...pose.move).add(this.position);
    this.object.quaternion.setFromEuler(new Euler(...pose.turn.map((degrees) => degrees * kRadians))).multiply(this.rotation);
    this.object.updateMatrix();
    return true;
  }

  /// `status`: the color of the device's status, or null.
  paint(status) {
    const heat = this.entry.color?.by ? heatOf(this.entry.color, this.numberOf(this.entry.color.by)) : null;
    const own = heat ?? status;
    this.meshes.forEach(({material}, i) => material.color.setRGB(...(own ? mixed(this.colors[i], own, heat ? .9 : kTint) : this.colors[i])));
  }
}
