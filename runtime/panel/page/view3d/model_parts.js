// Parts on a track or place of a model: boxes at the node that is bound to it.
import {after, kSame, shift} from "./affine.js";
import {partMatrix, Parts} from "./parts.js";

const kPart = 2e5;   // um, of a part without a kind
const kSide = .3;    // meters

/// The matrix that turns the x axis into a direction.
const toward = (direction) => {
  const length = Math.hypot(...direction);
  if (length < 1e-6) return kSame;
  const [x, y, z] = direction.map((value) => value / length);
  const flat = Math.hypot(x, z);
  const [sx, sz] = flat < 1e-6 ? [0, 1] : [-z / flat, x / flat];  // to the side, level
  const up = [-y * sz, sz * x - sx * z, sx * y];
  return [x, up[0], sx, 0, y, up[1], 0, 0, z, up[2], sz, 0];
};

export class ModelParts {
  constructor(app, location, {from, to}, object) {
    Object.assign(this, {app, location, from, rank: app.store.rankOfLocation[location], length: app.plant.locations[location].length, isTrack: app.plant.locations[location].kind === "track", parts: new Parts()});
    const way = (to ?? from).map((value, i) => value - from[i]);
    this.way = way;
    this.turned = toward(way);
    this.scale = this.isTrack ? Math.hypot(...way) / this.length : 1e-6;
    object.add(this.parts.mesh);
  }

  at(part) { return this.from.map((value, i) => value + this.way[i] * part); }

  /// Returns whether something moves on.
  draw(now, colors) {
    const {store, plant} = this.app;
    if (!this.isTrack) {
      const parts = (store.places[this.rank] ?? []).map(([, kind], i) => ({color: colors.kinds(kind), matrix: after(shift(0, kSide * i * 1.1, 0), partMatrix(this.from, kSame, kSide, kSide, kSide))}));
      this.parts.draw(parts);
      return false;
    }
    let moves = false;
    this.parts.draw(store.partsOn(this.rank, now).map(([, kind, at, speed]) => {
      moves ||= speed !== 0;
      const long = Math.min(plant.part_kinds[kind]?.length ?? kPart, Math.max(at, 1));
      return {color: colors.kinds(kind), matrix: partMatrix(this.at((at - long / 2) / this.length), this.turned, long * this.scale, kSide, kSide)};
    }));
    return moves;
  }
}
