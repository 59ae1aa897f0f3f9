// What a device looks like without a model, by its shape: a housing that stays, and what moves with its state. One cell is 1 x 1.
import {after, kSame, shift, stretch, turn} from "./affine.js";
import {box, cylinder, joined, moved} from "./solids.js";

const lying = (x, y, z, radius, length) => moved(after(shift(x, y, z), turn("z", -90)), cylinder(0, 0, 0, radius, length));
const bowTie = () => joined(moved(after(shift(-.3, .35, 0), turn("z", -90)), cylinder(0, 0, 0, .2, .3, .04)),
  moved(after(shift(.3, .35, 0), turn("z", 90)), cylinder(0, 0, 0, .2, .3, .04)));
const posts = (size, high) => [[-1, -1], [-1, 1], [1, -1], [1, 1]].map(([x, z]) => box(x * size, 0, z * size, .06, high, .06));
const level = (part, floor) => after(shift(0, floor, 0), after(stretch(1, Math.max(.02, part), 1), shift(0, -floor, 0)));

/// { body, movers: [{ solid, at(p) }] }: `at` gives the matrix of what moves; `p` is 0 to 1: between its ends, of a turntable the part of a turn, of a tank its level.
const kMakers = {
  cylinder: () => ({body: joined(box(-.15, 0, 0, .6, .12, .3), lying(-.42, .26, 0, .14, .54)),
    movers: [{solid: joined(lying(-.1, .26, 0, .05, .3), box(.2, .1, 0, .07, .32, .32)), at: (p) => shift(.24 * p, 0, 0)}]}),
  clamp: () => ({body: joined(box(-.2, 0, 0, .3, .5, .3), box(.2, 0, 0, .4, .18, .3)),
    movers: [{solid: box(.12, .46, 0, .6, .12, .18), at: (p) => turn("z", 75 * (1 - p), [-.18, .5, 0])}]}),
  gripper: () => ({body: joined(box(0, .5, 0, .5, .2, .3), box(0, .7, 0, .16, .3, .16)),
    movers: [{solid: box(-.28, .12, 0, .1, .4, .24), at: (p) => shift(.16 * p, 0, 0)}, {solid: box(.28, .12, 0, .1, .4, .24), at: (p) => shift(-.16 * p, 0, 0)}]}),
  robot: () => ({body: joined(cylinder(0, 0, 0, .3, .12), cylinder(0, .12, 0, .2, .22)),
    movers: [{solid: joined(cylinder(0, .34, 0, .17, .16), box(0, .44, 0, .14, .62, .14), moved(turn("z", -20, [0, 1, 0]), box(.28, .98, 0, .62, .12, .12)),
      box(.56, .62, 0, .08, .28, .08)), at: (p) => turn("y", 60 - 120 * p)}]}),
  motor: () => ({body: joined(box(-.05, 0, 0, .5, .1, .34), lying(-.32, .3, 0, .2, .5)), movers: [{solid: joined(lying(.18, .3, 0, .06, .22), box(.32, .2, 0, .06, .2, .2)),
    at: (p) => turn("x", 360 * p, [0, .3, 0])}]}),
  conveyor: () => ({body: joined(...posts(.4, .2), box(0, .2, 0, .96, .1, .7)), movers: [{solid: joined(...[-.36, -.12, .12, .36].map((x) => box(x, .3, 0, .1, .03, .6))), at: () => kSame}]}),
  turntable: () => ({body: cylinder(0, 0, 0, .46, .2, .46, 20), movers: [{solid: joined(cylinder(0, .2, 0, .42, .06, .42, 20), box(0, .26, .22, .8, .06, .06),
    box(0, .26, -.22, .8, .06, .06)), at: (p) => turn("y", -360 * p)}]}),
  lift: () => ({body: joined(...posts(.42, 1.3)), movers: [{solid: box(0, .08, 0, .8, .1, .8), at: (p) => shift(0, p, 0)}]}),
  valve: () => ({body: joined(bowTie(), cylinder(0, .35, 0, .05, .35)), movers: [{solid: box(0, .68, 0, .5, .07, .1), at: (p) => turn("y", 90 - 90 * p)}]}),
  tank: () => ({body: joined(cylinder(0, 0, 0, .44, .08, .44, 20), ...posts(.33, 1.2), cylinder(0, 1.2, 0, .44, .06, .44, 20)),
    movers: [{solid: cylinder(0, .08, 0, .38, 1.1, .38, 20), at: (p) => level(p, .08)}]}),
  pump: () => ({body: joined(box(0, 0, 0, .7, .1, .4), lying(-.36, .32, 0, .17, .4), moved(after(shift(.2, .32, .16), turn("x", -90)), cylinder(0, 0, 0, .24, .32))),
    movers: [{solid: moved(after(shift(.2, .32, .2), turn("x", 90)), joined(box(0, 0, 0, .36, .05, .08), box(0, 0, 0, .08, .05, .36))), at: (p) => turn("z", 360 * p, [.2, .32, 0])}]}),
  door: () => ({body: joined(box(-.44, 0, 0, .1, 1.1, .14), box(.44, 0, 0, .1, 1.1, .14), box(0, 1.1, 0, .98, .1, .14)),
    movers: [{solid: box(0, .02, 0, .78, 1.04, .06), at: (p) => shift(0, .92 * p, 0)}]}),
  machine: () => ({body: joined(box(0, 0, -.1, .96, 1, .72), box(.36, 0, .34, .2, .7, .2)), movers: [{solid: box(-.1, .35, .28, .55, .4, .04), at: () => kSame}]}),
  vehicle: () => ({body: box(0, 0, 0, .98, .03, .5), movers: [{solid: joined(box(0, .1, 0, .5, .16, .4), box(-.17, .26, 0, .1, .2, .36),
    ...[[-.16, -.2], [-.16, .2], [.16, -.2], [.16, .2]].map(([x, z]) => box(x, .03, z, .12, .1, .06))), at: (p) => shift(.44 * p - .22, 0, 0)}]}),
  sensor: () => ({body: box(0, 0, 0, .08, .5, .08), movers: [{solid: box(0, .5, .02, .18, .16, .24), at: () => kSame}]}),
  lamp: () => ({body: joined(cylinder(0, 0, 0, .2, .06), cylinder(0, .06, 0, .05, .5)), movers: [{solid: cylinder(0, .56, 0, .14, .28), at: () => kSame}]}),
  button: () => ({body: joined(box(0, 0, 0, .4, .5, .3), box(0, .5, 0, .4, .06, .3)), movers: [{solid: cylinder(0, .56, 0, .13, .12), at: (p) => shift(0, -.08 * p, 0)}]}),
  selector: () => ({body: box(0, 0, 0, .4, .5, .3), movers: [{solid: joined(cylinder(0, .5, 0, .14, .06), box(0, .56, 0, .06, .07, .26)), at: (p) => turn("y", 45 - 90 * p)}]}),
  device: () => ({body: box(0, 0, 0, .6, .5, .5), movers: [{solid: box(0, .5, 0, .3, .12, .3), at: () => kSame}]}),
};

const made = new Map();
/// The shape of this name; a plain box if there is no such shape. `simple`: for very many devices.
export const shapeOf = (name, simple = false) => {
  const key = simple ? "simple" : name in kMakers ? name : "device";
  if (!made.has(key)) made.set(key, simple ? {body: box(0, 0, 0, .6, .5, .5), movers: []} : kMakers[key]());
  return made.get(key);
};

/// Shapes whose color says whether they are on, and those that turn while the device runs.
export const kLit = new Set(["lamp", "sensor", "button"]);
export const kSpinning = new Set(["motor", "pump"]);
