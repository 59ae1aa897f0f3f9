// The paths on which parts pass from one track or place to another. Pure functions, without elements.
import {pointOn} from "./geometry.js";
import {passesOf} from "./model.js";

const kStub = .75;     // how far a path goes straight on before it turns
const kNearEnd = .85;  // of a track: parts that leave from here on leave at its end

const directionOf = (turn) => [[1, 0], [0, 1], [-1, 0], [0, -1]][turn / 90];

/// Where a path meets a place: the middle of the side that faces a point, and the direction out of it.
const meet = ({x, y, w, h}, [px, py]) => {
  const [dx, dy] = [px - x - w / 2, py - y - h / 2];
  if (Math.abs(dx) * h >= Math.abs(dy) * w) return {point: [dx < 0 ? x : x + w, y + h / 2], out: [Math.sign(dx) || 1, 0]};
  return {point: [x + w / 2, dy < 0 ? y : y + h], out: [0, Math.sign(dy)]};
};

const sideOf = ({width, turn}, [x, y], [px, py]) => {
  const [dx, dy] = directionOf(turn);
  const side = Math.sign((px - x) * -dy + (py - y) * dx) || 1;
  return {point: [x - dy * side * width / 2, y + dx * side * width / 2], out: [-dy * side, dx * side]};
};

/// One end of a path: where it meets a track or place, and the direction away from it. `at`: null for a place; `far`: a point of the other end.
const endOf = (placed, length, at, isFrom, far) => {
  if (placed.kind === "place") return meet(placed, far);
  const point = pointOn(placed, at, length);
  const [dx, dy] = directionOf(placed.turn);
  const ahead = ((far[0] - point[0]) * dx + (far[1] - point[1]) * dy) * (isFrom ? 1 : -1);
  const isAtEnd = isFrom ? at >= length : at <= 0;
  const isNearEnd = isFrom ? at >= kNearEnd * length : at <= (1 - kNearEnd) * length;
  const isLevel = Math.abs((far[0] - point[0]) * dy - (far[1] - point[1]) * dx) < placed.width;
  if (!isAtEnd && !(ahead > kStub && (isNearEnd || isLevel))) return sideOf(placed, point, far);
  return {point, out: isFrom ? [dx, dy] : [-dx, -dy]};
};

const middleOf = (placed, length, at) => placed.kind === "place" ? [placed.x + placed.w / 2, placed.y + placed.h / 2] : pointOn(placed, at, length);

/// A path of horizontal and vertical pieces between two ends.
const route = (from, to) => {
  const [a, b] = [from, to].map(({point: [x, y], out: [dx, dy]}) => [x + dx * kStub, y + dy * kStub]);
  const points = [from.point];
  const [ax, ay] = a;
  const [bx, by] = b;
  const isLine = (Math.abs(from.point[0] - to.point[0]) < 1e-6 && from.out[0] === 0 && to.out[0] === 0)
    || (Math.abs(from.point[1] - to.point[1]) < 1e-6 && from.out[1] === 0 && to.out[1] === 0);
  const isAhead = (to.point[0] - from.point[0]) * from.out[0] + (to.point[1] - from.point[1]) * from.out[1] > 0;
  if (isLine && isAhead) return [from.point, to.point];
  points.push(a);
  const isFlatFrom = from.out[1] === 0;
  const isFlatTo = to.out[1] === 0;
  if (isFlatFrom && isFlatTo) {
    const mid = from.out[0] === to.out[0] ? (from.out[0] > 0 ? Math.max(ax, bx) : Math.min(ax, bx)) : (bx - ax) * from.out[0] >= 0 ? (ax + bx) / 2 : null;
    if (mid !== null) points.push([mid, ay], [mid, by]);
    else points.push([ax, (ay + by) / 2], [bx, (ay + by) / 2]);
  } else if (!isFlatFrom && !isFlatTo) {
    const mid = from.out[1] === to.out[1] ? (from.out[1] > 0 ? Math.max(ay, by) : Math.min(ay, by)) : (by - ay) * from.out[1] >= 0 ? (ay + by) / 2 : null;
    if (mid !== null) points.push([ax, mid], [bx, mid]);
    else points.push([(ax + bx) / 2, ay], [(ax + bx) / 2, by]);
  } else points.push(isFlatFrom ? [bx, ay] : [ax, by]);
  points.push(b, to.point);
  return points.filter(([x, y], i) => i === 0 || Math.abs(x - points[i - 1][0]) + Math.abs(y - points[i - 1][1]) > 1e-6);
};

/// The joins of a plant whose locations are placed: { from, to, at, into, isEnd, points }.
export const joinsOf = (plant, placed) => passesOf(plant).map((pass) => {
  const {from, to, at, into} = pass;
  const [a, b] = [placed[from], placed[to]];
  const lengths = [plant.locations[from].length, plant.locations[to].length];
  const begin = endOf(a, lengths[0], at, true, middleOf(b, lengths[1], into));
  return {...pass, points: route(begin, endOf(b, lengths[1], into, false, begin.point))};
});
