// Plant time between two events of the stream, for animation.

const kMostAhead = 1500;  // ms without an event until plant time stops on the page: the stream sends one each second
const kSettling = 400;    // ms in which a small difference is corrected without a jump

/// The real speed is the mean of the last second: after a slower one was chosen it is still high, and time would run ahead.
const rateOf = ({speed, real_speed: real}) => speed === "max" ? real : Math.min(speed, real);

export class PlantClock {
  /// `wall` gives milliseconds of a clock that does not jump.
  constructor(wall = () => performance.now()) {
    this.wall = wall;
    this.t = 0;
    this.rate = 0;  // plant time per real time
    this.since = wall();
    this.ahead = 0;  // of what was shown when the last event came
  }

  /// From the stream: the plant time of an event, and the `clock` of the plant. `jump`: the plant was set back or on.
  set(t, clock, jump = false) {
    const rate = clock.state === "running" ? rateOf(clock) : 0;
    const shown = this.now();
    const ahead = shown - t;
    const smooth = !jump && rate > 0 && this.rate > 0 && Math.abs(ahead) < 2.5e8 * rate;
    this.ahead = smooth ? ahead : 0;
    this.t = t;
    this.rate = rate;
    this.since = this.wall();
  }

  get runs() { return this.rate > 0; }

  /// In nanoseconds.
  now() {
    if (this.rate === 0) return this.t;
    const passed = Math.min(this.wall() - this.since, kMostAhead);
    return this.t + passed * 1e6 * this.rate + this.ahead * Math.max(0, 1 - passed / kSettling);
  }
}
