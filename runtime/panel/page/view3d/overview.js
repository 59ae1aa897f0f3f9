// The camera from which a box is seen as large as possible. Pure functions, without three.js.

const kMargin = 1.04;

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/// { from, to } for a box { min, max }; `fov`: degrees from the lower to the upper edge; `slope`: the height of the view over the floor, per length.
export const overviewOf = ({min, max}, fov, aspect, slope = 1.4) => {
  const length = Math.hypot(slope, 1);
  const back = [0, slope / length, 1 / length];
  const up = [0, 1 / length, -slope / length];
  const half = Math.tan(fov * Math.PI / 360) / kMargin;
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((corner) => min.map((value, k) => corner >> k & 1 ? max[k] : value));
  const middle = min.map((value, k) => (value + max[k]) / 2);
  // A corner is seen if its distance from the axis is at most `half` times its depth. Up and down: the axis can be between them.
  const spans = corners.map((point) => point.map((value, k) => value - middle[k])).map((point) => ({side: Math.abs(point[0]), up: dot(point, up), near: dot(point, back)}));
  const high = Math.max(...spans.map((at) => at.up + half * at.near));
  const low = Math.max(...spans.map((at) => -at.up + half * at.near));
  const shift = (high - low) / 2;
  const distance = Math.max((high + low) / 2 / half, ...spans.map((at) => at.side / (half * aspect) + at.near));
  const to = middle.map((value, k) => value + up[k] * shift);
  return {from: to.map((value, k) => value + back[k] * distance), to};
};
