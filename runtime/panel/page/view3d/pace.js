// How sharp the 3D view is: without a graphics card, fewer pixels are drawn while something moves and frames are slow, all of them at rest.

const kSlow = 38;     // ms between two frames
const kSamples = 8;   // frames whose mean counts
const kLeast = .64;   // of the pixels of a side
const kStep = .8;
const kPause = 150;   // ms without a frame: it is at rest

export class Pace {
  constructor() { Object.assign(this, {moving: 1, last: -Infinity, sum: 0, count: 0}); }

  /// The part of the pixels of a side for a frame at `wall` (ms).
  ratio(wall) {
    const since = wall - this.last;
    this.last = wall;
    if (since > kPause) {
      Object.assign(this, {sum: 0, count: 0});
      return 1;
    }
    this.sum += since;
    if (++this.count < kSamples) return this.moving;
    if (this.sum / this.count > kSlow) this.moving = Math.max(kLeast, this.moving * kStep);
    Object.assign(this, {sum: 0, count: 0});
    return this.moving;
  }
}

/// After this time without a frame, one is sharp, in ms.
export const kRest = kPause + 50;
