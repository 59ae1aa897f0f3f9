// Until when the server may do an act, by the server's clock.

export const kActTime = 3000;  // ms: an act without an answer is then shown as not done
const kForAnswer = 1000;  // ms of them, which the answer has left

export class ActClock {
  constructor() { this.ahead = -Infinity; }  // ms by which the server's clock is ahead of the page's, or less

  /// An event of the stream, which came some time after the server's clock showed its `now`. With `begins` the stream is a new
  /// one.
  hear({now}, begins, here = performance.now()) {
    if (now === undefined) return;
    this.ahead = Math.max(begins ? -Infinity : this.ahead, now - here);
  }

  /// The latest time for an act that is sent now, as a key of the request; none if the server's clock is not known.
  limit(here = performance.now()) {
    return Number.isFinite(this.ahead) ? {until: Math.floor(here + this.ahead + kActTime - kForAnswer)} : {};
  }
}
