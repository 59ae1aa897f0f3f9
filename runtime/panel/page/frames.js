// One loop of frames for everything that moves or has changed; without need it rests.

const kLeast = 28;  // ms between two frames: about 30 in a second

export class Frames {
  constructor() {
    this.painters = new Set();
    this.asked = false;
    this.last = -kLeast;
    this.count = 0;  // of frames that were drawn
    this.step = this.step.bind(this);
  }

  /// `painter()` draws what changed, and returns whether it wants a further frame. Returns what ends it.
  add(painter) {
    this.painters.add(painter);
    this.request();
    return () => this.painters.delete(painter);
  }

  request() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(this.step);
  }

  step(time) {
    this.asked = false;
    if (time - this.last < kLeast - 2) return this.request();
    this.last = time;
    this.count += 1;
    let again = false;
    for (const painter of this.painters) again = painter() || again;
    if (again) this.request();
  }
}
