// One status for each device and each station: what an engineer must see first. Never shown by color alone: each has a letter.
import {DEVICE} from "./store.js";
import {isOn} from "./words.js";

const kFindingTime = 60e9;  // a finding marks its device for a minute of plant time

/// In the order of urgency, the least first.
export const STATUSES = [
  {key: "rest", letter: "–", text: "at rest", short: "at rest"},
  {key: "contact", letter: "N", text: "no operation moves it: a person sets it", short: "set by hand"},
  {key: "commanded", letter: "=", text: "in its commanded state", short: "as commanded"},
  {key: "waits", letter: "W", text: "waits for a command", short: "waits"},
  {key: "moving", letter: "▶", text: "moving", short: "moving"},
  {key: "stopped", letter: "S", text: "stopped midway", short: "stopped midway"},
  {key: "disabled", letter: "D", text: "disabled", short: "disabled"},
  {key: "blocked", letter: "B", text: "has a command and does not move", short: "blocked"},
  {key: "frozen", letter: "L", text: "frozen in a loop", short: "loop"},
  {key: "malfunction", letter: "M", text: "a malfunction acts on it", short: "malfunction"},
  {key: "finding", letter: "!", text: "a finding in the last minute", short: "finding"},
];
export const rank = Object.fromEntries(STATUSES.map(({key}, index) => [key, index]));

const kColors = {rest: "waits", contact: "waits", commanded: "waits", waits: "waits", frozen: "malfunction"};

/// The name of a status's color in the style sheet; its tint is called NAME-tint, but "waits" has none.
export const colorOf = (key) => kColors[key] ?? key;

export class Statuses {
  constructor(store, names) {
    this.store = store;
    this.names = names;
    const {devices, stations, symbols} = store.plant;
    this.settled = devices.map(({operations, events}) => operations.length > 0 ? rank.waits
      : events.every((symbol) => symbols[symbol].driver === "none") ? rank.contact : rank.rest);
    this.commands = new Map();  // the devices that an operation commands, for each of its symbols
    devices.forEach(({operations}, index) => operations.forEach(({symbol}) => {
      this.commands.set(symbol, [...this.commands.get(symbol) ?? [], index]);
    }));
    this.of = new Uint8Array(devices.length);
    this.foundAt = new Float64Array(devices.length).fill(-Infinity);
    this.stations = stations.map(() => new Uint32Array(STATUSES.length));
    this.loose = new Uint32Array(STATUSES.length);  // of devices in no station
    this.marked = new Set();  // devices with a finding in the last minute
    this.lastFinding = -1;
    devices.forEach((_, index) => { this.counts(index)[0] += 1; });
  }

  counts(device) {
    const {station} = this.store.plant.devices[device];
    return station === null ? this.loose : this.stations[station];
  }

  compute(device) {
    const {flags, blocked, t} = this.store;
    const bits = flags[device];
    if (t - this.foundAt[device] < kFindingTime) return rank.finding;
    if (bits & DEVICE.malfunction) return rank.malfunction;
    if (bits & DEVICE.frozen) return rank.frozen;
    if (blocked[device]) return rank.blocked;
    if (bits & DEVICE.disabled) return rank.disabled;
    if (bits & DEVICE.stopped) return rank.stopped;
    if (bits & DEVICE.moving) return rank.moving;
    return this.isCommanded(device) ? rank.commanded : this.settled[device];
  }

  /// Whether an operation that is on commands the state in which the device is.
  isCommanded(device) {
    const {plant, state, values} = this.store;
    return plant.devices[device].operations.some(({symbol, to}) => to === state[device] && isOn(plant.symbols[symbol], values[symbol]));
  }

  refresh(device, changed) {
    const status = this.compute(device);
    if (status === this.of[device]) return;
    const counts = this.counts(device);
    counts[this.of[device]] -= 1;
    counts[status] += 1;
    this.of[device] = status;
    changed.add(device);
  }

  deviceOf(name) {
    const found = this.names.find(name);
    if (!found) return null;
    if (found.kind === "device") return found.index;
    return found.kind === "symbol" ? this.store.plant.symbols[found.index].device : null;
  }

  mark(findings, touched) {
    for (const {n, t, of} of findings) {
      if (n <= this.lastFinding) continue;
      this.lastFinding = n;
      const device = this.deviceOf(of);
      if (device === null) continue;
      this.foundAt[device] = t;
      this.marked.add(device);
      touched.add(device);
    }
  }

  /// After an event of the stream: the devices whose status changed.
  update(change) {
    const changed = new Set();
    const touched = new Set(change.devices);
    for (const symbol of change.symbols) for (const device of this.commands.get(symbol) ?? []) touched.add(device);
    if (change.all || change.jumped) {
      for (const device of this.marked) touched.add(device);
      this.foundAt.fill(-Infinity);
      this.marked.clear();
      if (change.all) this.lastFinding = -1;
    }
    if (change.all || change.keys.has("findings")) this.mark(this.store.findings, touched);
    for (const device of this.marked) {
      if (this.store.t - this.foundAt[device] < kFindingTime) continue;
      this.marked.delete(device);
      touched.add(device);
    }
    if (change.all) for (let device = 0; device < this.of.length; ++device) this.refresh(device, changed);
    else for (const device of touched) this.refresh(device, changed);
    return changed;
  }

  /// The most urgent status of a station.
  worst(counts) {
    for (let status = STATUSES.length - 1; status > 0; --status) if (counts[status] > 0) return status;
    return 0;
  }
}
