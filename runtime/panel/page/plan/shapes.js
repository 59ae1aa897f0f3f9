// The symbols of devices on a canvas. Each draws in a square from -0.5 to 0.5 whose middle is the origin: what stays in `ink`, what moves in `color`, on `fill`.
// { amount, turn, on, spin, level }: see motion.js; `spin` is an angle.

const box = (c, x, y, w, h) => {
  c.fillRect(x, y, w, h);
  c.strokeRect(x, y, w, h);
};

const disc = (c, x, y, r) => {
  c.beginPath();
  c.arc(x, y, r, 0, 2 * Math.PI);
  c.fill();
  c.stroke();
};

const line = (c, ...points) => {
  c.beginPath();
  points.forEach(([x, y], i) => i === 0 ? c.moveTo(x, y) : c.lineTo(x, y));
  c.stroke();
};

const area = (c, ...points) => {
  c.beginPath();
  points.forEach(([x, y], i) => i === 0 ? c.moveTo(x, y) : c.lineTo(x, y));
  c.closePath();
  c.fill();
  c.stroke();
};

/// What moves: thicker, in the color of the status.
const moving = (c, {color}, draw) => {
  c.save();
  c.strokeStyle = c.fillStyle = color;
  c.lineWidth *= 1.6;
  draw();
  c.restore();
};

const spoke = (c, p, r, x = 0, y = 0) => moving(c, p, () => line(c, [x - Math.cos(p.spin) * r, y - Math.sin(p.spin) * r], [x + Math.cos(p.spin) * r, y + Math.sin(p.spin) * r]));

const cylinder = (c, p) => {
  const tip = .16 + .32 * p.amount;
  moving(c, p, () => {
    line(c, [.04, 0], [tip, 0]);
    line(c, [tip, -.22], [tip, .22]);
  });
  box(c, -.48, -.27, .52, .54);
  moving(c, p, () => line(c, [-.4 + .34 * p.amount, -.27], [-.4 + .34 * p.amount, .27]));
};

const clamp = (c, p) => {
  box(c, -.42, .2, .84, .2);
  box(c, -.4, -.1, .18, .3);
  const angle = -1.1 * (1 - p.amount);
  moving(c, p, () => {
    const [x, y] = [-.31 + Math.cos(angle) * .68, -.1 + Math.sin(angle) * .5];
    line(c, [-.31, -.1], [x, y], [x - Math.sin(angle) * .1, y + Math.cos(angle) * .22]);
  });
};

const gripper = (c, p) => {
  box(c, -.3, -.44, .6, .24);
  const open = .1 + .26 * (1 - p.amount);
  moving(c, p, () => {
    for (const side of [-1, 1]) line(c, [side * .2, -.2], [side * open, 0], [side * open, .42], [side * (open - .09), .42]);
  });
};

const robot = (c, p) => {
  box(c, -.4, .26, .5, .18);
  const angle = -1.9 + 1.2 * p.amount;
  const [x, y] = [-.15 + Math.cos(angle) * .46, .26 + Math.sin(angle) * .46];
  moving(c, p, () => line(c, [-.15, .26], [x, y], [x + .36, y + .12], [x + .36, y + .26]));
  disc(c, x, y, .07);
};

const motor = (c, p) => {
  disc(c, 0, 0, .4);
  line(c, [-.17, .17], [-.17, -.16], [0, .06], [.17, -.16], [.17, .17]);
  moving(c, p, () => {
    c.beginPath();
    c.arc(0, 0, .4, p.spin - .6, p.spin + .6);
    c.stroke();
  });
};

const conveyor = (c, p) => {
  c.beginPath();
  c.arc(-.26, 0, .24, Math.PI / 2, Math.PI * 1.5);
  c.arc(.26, 0, .24, -Math.PI / 2, Math.PI / 2);
  c.closePath();
  c.fill();
  c.stroke();
  for (const x of [-.26, .26]) {
    disc(c, x, 0, .14);
    spoke(c, p, .14, x);
  }
};

const turntable = (c, p) => {
  disc(c, 0, 0, .44);
  const angle = p.turn * 2 * Math.PI;
  moving(c, p, () => line(c, [0, 0], [Math.cos(angle) * .4, Math.sin(angle) * .4]));
  moving(c, {...p, color: c.strokeStyle}, () => disc(c, 0, 0, .05));
};

const lift = (c, p) => {
  line(c, [-.3, .44], [-.3, -.44]);
  line(c, [.3, .44], [.3, -.44]);
  line(c, [-.4, .44], [.4, .44]);
  moving(c, p, () => box(c, -.3, .28 - .62 * p.amount, .6, .07));
};

const valve = (c, p) => {
  c.save();
  if (p.amount > .5) c.fillStyle = p.color;
  area(c, [-.44, -.26], [-.44, .26], [0, 0]);
  area(c, [.44, -.26], [.44, .26], [0, 0]);
  c.restore();
  const angle = -Math.PI / 2 * p.amount;
  moving(c, p, () => {
    line(c, [0, 0], [0, -.34]);
    line(c, [-Math.cos(angle) * .18, -.34 - Math.sin(angle) * .1], [Math.cos(angle) * .18, -.34 + Math.sin(angle) * .1]);
  });
};

const tank = (c, p) => {
  box(c, -.34, -.44, .68, .88);
  const level = p.level ?? p.amount;
  c.save();
  c.fillStyle = p.color;
  c.globalAlpha *= .55;
  c.fillRect(-.34, .44 - .88 * level, .68, .88 * level);
  c.restore();
  c.strokeRect(-.34, -.44, .68, .88);
};

const pump = (c, p) => {
  disc(c, 0, 0, .4);
  c.save();
  if (p.on) c.fillStyle = p.color;
  area(c, [-.2, -.3], [-.2, .3], [.36, 0]);
  c.restore();
  spoke(c, p, .12, -.04);
};

const door = (c, p) => {
  c.strokeRect(-.42, -.44, .84, .88);
  c.save();
  c.fillStyle = p.amount < .5 ? p.color : c.fillStyle;
  c.globalAlpha *= .6;
  c.fillRect(-.42, -.44, .84 - .7 * p.amount, .88);
  c.restore();
  moving(c, p, () => line(c, [.42 - .7 * p.amount, -.44], [.42 - .7 * p.amount, .44]));
};

const machine = (c, p) => {
  box(c, -.44, -.44, .88, .88);
  box(c, -.26, -.26, .52, .34);
  moving(c, p, () => line(c, [0, -.26], [0, -.16 + .14 * p.amount]));
  spoke(c, p, .1, 0, .24);
};

const vehicle = (c, p) => {
  const x = -.08 + .16 * p.amount;
  moving(c, p, () => line(c, [-.46, .38], [.46, .38]));
  box(c, x - .36, -.22, .72, .4);
  for (const wheel of [-.2, .2]) disc(c, x + wheel, .24, .1);
};

const sensor = (c, p) => {
  c.save();
  if (p.on) c.fillStyle = p.color;
  area(c, [-.36, -.3], [.36, -.3], [0, .36]);
  c.restore();
};

const lamp = (c, p) => {
  c.save();
  if (p.on) c.fillStyle = p.color;
  disc(c, 0, 0, .36);
  c.restore();
  if (p.on) for (let i = 0; i < 8; ++i) line(c, [Math.cos(i * .7854) * .4, Math.sin(i * .7854) * .4], [Math.cos(i * .7854) * .48, Math.sin(i * .7854) * .48]);
  else line(c, [-.25, -.25], [.25, .25]);
  if (!p.on) line(c, [-.25, .25], [.25, -.25]);
};

const button = (c, p) => {
  disc(c, 0, 0, .42);
  c.save();
  if (p.on) c.fillStyle = p.color;
  disc(c, 0, 0, .26 - (p.on ? .05 : 0));
  c.restore();
};

const selector = (c, p) => {
  disc(c, 0, 0, .4);
  const angle = -Math.PI * (.75 - .5 * p.amount);
  moving(c, p, () => line(c, [-Math.cos(angle) * .3, -Math.sin(angle) * .3], [Math.cos(angle) * .38, Math.sin(angle) * .38]));
};

const device = (c, p) => {
  box(c, -.42, -.3, .84, .6);
  c.save();
  c.fillStyle = p.color;
  c.fillRect(-.34, .12, .68 * p.amount, .1);
  c.restore();
  c.strokeRect(-.34, .12, .68, .1);
};

const kShapes = {cylinder, clamp, gripper, robot, motor, conveyor, turntable, lift, valve, tank, pump, door, machine, vehicle, sensor, lamp, button, selector, device};

/// Draws a symbol with its middle at x, y in pixels, `scale` pixels wide. `colors`: { ink, color, fill }; `dashed`: a disabled device.
export const drawShape = (context, shape, {x, y, turn}, scale, colors, motion, dashed) => {
  context.save();
  context.translate(x, y);
  if (turn) context.rotate(turn * Math.PI / 180);
  context.scale(scale, scale);
  context.lineWidth = Math.max(1, Math.min(2, scale / 22)) / scale;
  context.lineJoin = context.lineCap = "round";
  context.strokeStyle = colors.ink;
  context.fillStyle = colors.fill;
  if (dashed) context.setLineDash([.12, .08]);
  (kShapes[shape] ?? device)(context, {...motion, color: colors.color});
  context.restore();
};
