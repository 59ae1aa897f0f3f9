// Parts on tracks and places: boxes in the color of their kind, all in one call.
import {after, shift, stretch} from "./affine.js";
import {Batch} from "./batch.js";
import {box} from "./solids.js";

const kBox = box(0, 0, 0, 1, 1, 1);
const kHidden = stretch(0, 0, 0);

/// Draws the parts that each call of draw() gives it.
export class Parts {
  constructor() {
    this.batch = new Batch();
    this.batch.finish();
    this.shown = 0;
  }

  get mesh() { return this.batch.mesh; }

  /// `parts` are { matrix, color }: the matrix of a cube of the size 1 that is on the floor.
  draw(parts) {
    if (parts.length > this.batch.slots.length) {
      for (let more = Math.max(32, parts.length) * 2; this.batch.slots.length < more;) this.batch.add(kBox, [0, 0, 0], kHidden);
      this.batch.finish();
    }
    parts.forEach(({matrix, color}, i) => {
      const slot = this.batch.slots[i];
      this.batch.move(slot, matrix);
      this.batch.paint(slot, color);
    });
    for (let i = parts.length; i < this.shown; ++i) this.batch.move(this.batch.slots[i], kHidden);
    this.shown = parts.length;
  }

  dispose() { this.batch.dispose(); }
}

/// The matrix of a part: on a point, along a direction in the plan of `turn` degrees clockwise.
export const partMatrix = ([x, y, z], turned, long, high, wide) => after(shift(x, y, z), after(turned, stretch(long, high, wide)));
