// What part of the plan is seen: a scale and an offset. Without elements.

const kLeast = 2;     // pixels for a grid unit
const kMost = 240;
const kFit = 64;      // when a station or the whole is shown: a small plant does not become huge
const kAbove = .35;   // of the free height
const kStep = 1.25;   // of a zoom by key

export class Camera {
  constructor() { Object.assign(this, {scale: 20, x: 0, y: 0, wide: 1, high: 1, isWhole: true}); }

  /// The pixels of a point of the plan.
  toScreen([x, y]) { return [(x - this.x) * this.scale, (y - this.y) * this.scale]; }
  toPlan([x, y]) { return [x / this.scale + this.x, y / this.scale + this.y]; }
  sees({x, y, w, h}) {
    return x < this.x + this.wide / this.scale && x + w > this.x && y < this.y + this.high / this.scale && y + h > this.y;
  }

  /// Shows a rectangle of the plan, a little above the middle.
  show({x, y, w, h}, most = kFit) {
    this.scale = Math.max(kLeast, Math.min(most, this.wide / w, this.high / h));
    this.x = x + w / 2 - this.wide / this.scale / 2;
    this.y = y - (this.high / this.scale - h) * (this.high / this.scale > h ? kAbove : .5);
    this.isWhole = false;
  }

  whole(bounds) {
    this.show(bounds);
    this.isWhole = true;
  }

  /// Zooms by a factor; the point of the screen stays where it is.
  zoom(factor, [px, py] = [this.wide / 2, this.high / 2]) {
    const [x, y] = this.toPlan([px, py]);
    this.scale = Math.max(kLeast, Math.min(kMost, this.scale * factor));
    this.x = x - px / this.scale;
    this.y = y - py / this.scale;
    this.isWhole = false;
  }

  step(sign) { this.zoom(kStep ** sign); }

  pan(dx, dy) {
    this.x -= dx / this.scale;
    this.y -= dy / this.scale;
    this.isWhole = false;
  }

  /// Moves as little as possible so that a rectangle is seen.
  follow({x, y, w, h}) {
    const [right, bottom] = [this.wide / this.scale, this.high / this.scale];
    const to = (from, at, size, seen) => at < from ? at : at + size > from + seen ? at + size - seen : from;
    const [nextX, nextY] = [to(this.x, x, w, right), to(this.y, y, h, bottom)];
    if (nextX === this.x && nextY === this.y) return false;
    Object.assign(this, {x: nextX, y: nextY, isWhole: false});
    return true;
  }
}
