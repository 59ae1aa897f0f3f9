// An entry of `view3d.nodes`: what binds a node of a model to a device, a value, a track or a place.
import {poseAt} from "../motion.js";
import {heatOf, kOwnPose, mixPoses, numberOfSymbol, poseByValue, posesOf, sumOf} from "./binding.js";

export class Bound {
  /// `node`: its BoundNode.
  constructor(app, key, entry, node) {
    Object.assign(this, {app, key, entry, node, device: app.names.index("device", key)});
    this.location = this.device === null && entry.from ? app.names.index("location", key) : null;
    this.poses = this.device === null ? null : posesOf(entry, app.plant.devices[this.device].states);
    this.moves = Boolean(this.poses || entry.move?.by || entry.turn?.by);
    /// Of a value or a numeric symbol.
    this.numberOf = (name) => app.store.numbers[app.names.index("value", name)] ?? numberOfSymbol(app.store.values[app.names.index("symbol", name)] ?? null);
  }

  /// What it adds to the node's pose in the model, at plant time `now`.
  pose(now) {
    const byValue = poseByValue(this.entry, this.numberOf);
    return this.poses ? sumOf(poseAt(this.app.store, this.device, now, (state) => this.poses[state] ?? kOwnPose, mixPoses), byValue) : byValue;
  }

  /// The color by a value; null: it has none.
  heat() { return this.entry.color?.by ? heatOf(this.entry.color, this.numberOf(this.entry.color.by)) : null; }
}
