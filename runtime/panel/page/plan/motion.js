// What a symbol shows of its device's state: how far a rod is out, whether a motor runs. Names of states are words of the plant; what no
// word says follows from the order of the states. Without elements.
import {poseAt} from "../motion.js";
import {partOf, hasRange} from "../value_words.js";

const kOne = /^(OUT|ADV|EXT|FRONT|FORWARD|FWD|CLOSE|CLOSED|SHUT|CLAMP|CLAMPED|GRIP|LOCK|LOCKED|UP|TOP|RUN|ON|PUSH|PRESSED|SEEN|FULL)\d*$/;
const kZero = /^(BACK|RET|HOME|OPEN|OPENED|UNCLAMP|RELEASE|FREE|UNLOCK|DOWN|BOTTOM|STOP|STOPPED|OFF|IDLE)\d*$/;
const kOpening = /^(NOT_)?(OPEN|OPENED|CLOSE|CLOSED|SHUT)\d*$/;
const kOpens = new Set(["door", "valve"]);  // 1: open

/// 0 or 1 by a word; null without one. NOT_X is the other end of X, or 0 if X is no known word.
const sideOf = (name) => {
  if (name.startsWith("NOT_")) return 1 - (sideOf(name.slice(4)) ?? 1);
  return kOne.test(name) ? 1 : kZero.test(name) ? 0 : null;
};

/// Where a state is between the two ends of a device, 0 to 1.
export const amountOf = ({states, shape}, state) => {
  const name = states[state] ?? "";
  const side = sideOf(name) ?? (states.length > 1 ? state / (states.length - 1) : 0);
  return kOpens.has(shape) && kOpening.test(name) ? 1 - side : side;
};

/// Angle of a turntable, in turns: each state is its part of the whole turn.
const turnOf = ({states}, state) => state / Math.max(1, states.length);

const mix = (a, b, part) => a + (b - a) * part;

/// Between two angles in turns; backward only by up to half a turn.
const mixTurns = (a, b, part) => mix(a, b - a < -.5 ? b + 1 : b, part);

/// { amount, turn, on }: the amount at plant time `now`, during a move between those of both states.
export const motionOf = (store, index, now) => {
  const device = store.plant.devices[index];
  return {amount: poseAt(store, index, now, (state) => amountOf(device, state), mix), turn: poseAt(store, index, now, (state) => turnOf(device, state), mixTurns),
    on: amountOf(device, store.state[index]) >= .5};
};

const kRuns = new Set(["motor", "conveyor", "pump", "machine"]);

/// Whether a device's symbol turns although its state stays.
export const runs = (store, index) => {
  const device = store.plant.devices[index];
  return kRuns.has(device.shape) && store.state[index] === store.target[index] && device.states.length > 1 && /^(RUN|ON|FORWARD|FWD|UP|DOWN|LEFT|RIGHT|FAST|SLOW|CW|CCW)\d*$/
    .test(device.states[store.state[index]] ?? "");
};

/// The values that are shown at each device: its own, and those whose name begins with its label ("hoist.height" of PORT_C1_HOIST).
export const valuesByDevice = (plant) => {
  const labels = new Map();
  plant.devices.forEach(({label}, device) => {
    const key = label.toLowerCase();
    labels.set(key, labels.has(key) ? null : device);
  });
  const found = new Map();
  plant.values.forEach(({name, device}, value) => {
    const of = device ?? labels.get(name.split(/[.[]/)[0].toLowerCase()) ?? null;
    if (of !== null) found.set(of, [...found.get(of) ?? [], value]);
  });
  return found;
};

/// How full a tank is, 0 to 1, by the first of its values that has a range; null without one, or if it is not known.
export const levelOf = (store, values) => {
  const value = (values ?? []).find((at) => hasRange(store.plant.values[at]));
  return value === undefined || Number.isNaN(store.numbers[value]) ? null : partOf(store.plant.values[value], store.numbers[value]);
};
