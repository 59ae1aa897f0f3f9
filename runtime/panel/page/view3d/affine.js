// Positions and turns in 3D as affine matrices: 12 numbers, three rows of four. Pure functions, without three.js.

export const kSame = Object.freeze([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]);

export const shift = (x, y, z) => [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z];

/// Sizes along the axes; 0 hides.
export const stretch = (x, y, z) => [x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0];

/// `a` after `b`.
export const after = (a, b) => {
  const product = new Array(12);
  for (let row = 0; row < 12; row += 4) {
    for (let column = 0; column < 4; ++column) {
      product[row + column] = a[row] * b[column] + a[row + 1] * b[4 + column] + a[row + 2] * b[8 + column] + (column === 3 ? a[row + 3] : 0);
    }
  }
  return product;
};

const kTurns = {
  x: (c, s) => [1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0],
  y: (c, s) => [c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0],
  z: (c, s) => [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0],
};

/// Degrees about an axis through a point, counterclockwise as seen from its positive end.
export const turn = (axis, degrees, [x, y, z] = [0, 0, 0]) => {
  const angle = degrees * Math.PI / 180;
  return after(shift(x, y, z), after(kTurns[axis](Math.cos(angle), Math.sin(angle)), shift(-x, -y, -z)));
};

export const pointAt = (m, x, y, z) => [m[0] * x + m[1] * y + m[2] * z + m[3], m[4] * x + m[5] * y + m[6] * z + m[7], m[8] * x + m[9] * y + m[10] * z + m[11]];

/// Where what is made around the origin is in the plan: x to the right, y is z in 3D; degrees clockwise as seen from above.
export const placed = ({x, y, turn: clockwise = 0}) => after(shift(x, 0, y), turn("y", -clockwise));
