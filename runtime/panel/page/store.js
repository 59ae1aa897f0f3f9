// What the page knows about the plant: its description, and its state as of the last event of the stream.
import {AlarmState} from "./alarm_state.js";
import {pathAfter} from "./motion.js";

/// Flags of a device.
export const DEVICE = {moving: 1, stopped: 2, disabled: 4, frozen: 8, malfunction: 16};
/// Flags of a symbol.
export const SYMBOL = {forced: 1, malfunction: 2};
/// Flags of a value.
export const VALUE = {held: 1};

const kMostFindings = 1000;
const kMostActs = 1000;
const kMostMessages = 50;
const kWhole = ["clock", "malfunctions", "links", "cycle", "snapshots", "scenario", "exercise", "allowed", "training", "layout", "camera"];  // replaced if they change

const kJumps = ["reset", "restore", "exercise"];  // acts after which plant time may be any

/// What an event changed. `all`: everything; else indexes, and `keys` names further keys of the event. `jumped`: the plant was
/// reset or restored.
const noChange = () => ({all: false, jumped: false, devices: [], symbols: [], values: [], tracks: [], places: [], requirements: [], keys: new Set()});

export class Store {
  constructor(plant) {
    this.plant = plant;
    const devices = plant.devices.length;
    this.state = new Int32Array(devices);
    this.target = new Int32Array(devices);
    this.flags = new Uint8Array(devices);
    this.blocked = new Uint8Array(devices);
    this.since = new Float64Array(devices);
    this.remaining = new Float64Array(devices);
    this.whole = new Float64Array(devices);
    this.at = new Float64Array(devices);  // the time of `remaining`
    this.paths = new Array(devices).fill(null);  // of moves, see motion.js
    this.values = new Array(plant.symbols.length).fill(false);
    this.symbolFlags = new Uint8Array(plant.symbols.length);
    this.symbolSince = new Float64Array(plant.symbols.length);
    this.numbers = new Float64Array(plant.values?.length ?? 0).fill(NaN);  // NaN: not known
    this.valueFlags = new Uint8Array(this.numbers.length);
    this.tracks = [];
    this.places = [];
    this.requirements = [];
    this.alarms = new AlarmState();
    Object.assign(this, {rev: -1, t: 0, forced: 0, clock: {state: "frozen", speed: 1, real_speed: 0, until: null},
      malfunctions: [], links: [], cycle: null, snapshots: [], scenario: null, exercise: null, allowed: null, training: null, layout: null, camera: null, findings: [], acts: [],
      messages: []});
    this.valuesOfDevice = new Map();
    (plant.values ?? []).forEach(({device}, index) => {
      if (device !== null) this.valuesOfDevice.set(device, [...this.valuesOf(device), index]);
    });
    this.trackLocations = [];
    this.placeLocations = [];
    plant.locations.forEach(({kind}, index) => (kind === "track" ? this.trackLocations : this.placeLocations).push(index));
    this.rankOfLocation = new Int32Array(plant.locations.length);
    for (const list of [this.trackLocations, this.placeLocations]) list.forEach((index, rank) => { this.rankOfLocation[index] = rank; });
    this.listeners = new Set();
  }

  /// `listener(change)` is called after each event. Returns what ends it.
  listen(listener) {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  setDevice(index, entry, from, t) {
    if (!(index < this.state.length)) return false;
    const before = {state: this.state[index], target: this.target[index], done: this.progress(index, t).done};
    this.state[index] = entry[from];
    this.target[index] = entry[from + 1];
    this.flags[index] = entry[from + 2];
    this.blocked[index] = entry[from + 3];
    this.since[index] = entry[from + 4];
    this.remaining[index] = entry[from + 5];
    this.whole[index] = entry[from + 6];
    this.at[index] = t;
    this.paths[index] = pathAfter(this.paths[index], before, {state: this.state[index], target: this.target[index], done: this.progress(index, t).done});
    return true;
  }

  setSymbol(index, value, flags, since) {
    if (!(index < this.values.length)) return false;
    this.forced += (flags & SYMBOL.forced) - (this.symbolFlags[index] & SYMBOL.forced);
    this.values[index] = value;
    this.symbolFlags[index] = flags;
    this.symbolSince[index] = since;
    return true;
  }

  setValue(index, number, flags) {
    if (!(index < this.numbers.length)) return false;
    this.numbers[index] = number ?? NaN;
    this.valueFlags[index] = flags;
    return true;
  }

  /// The values whose name begins with that of a device.
  valuesOf(device) { return this.valuesOfDevice.get(device) ?? []; }

  setTrack(rank, [t, parts, stops, drives]) { this.tracks[rank] = {t, parts, stops: stops ?? [], drives: drives ?? []}; }

  /// The event `picture`: the state of everything.
  picture(event) {
    const jumped = event.t < this.t;
    this.rev = event.rev;
    this.t = event.t;
    event.devices.forEach((entry, index) => this.setDevice(index, entry, 0, event.t));
    this.paths.fill(null);
    event.symbols.forEach(([value, flags, since], index) => this.setSymbol(index, value, flags, since));
    (event.values ?? []).forEach(([number, flags], index) => this.setValue(index, number, flags));
    this.tracks = [];
    (event.tracks ?? []).forEach((entry, rank) => this.setTrack(rank, entry));
    this.places = event.places ?? [];
    this.requirements = event.requirements ?? [];
    for (const key of kWhole) this[key] = event[key] ?? (Array.isArray(this[key]) ? [] : null);
    this.findings = event.findings ?? [];
    this.acts = event.acts ?? [];
    this.messages = event.messages ?? [];
    this.alarms.apply(event.alarms ?? {all: true});
    this.publish({...noChange(), all: true, jumped});
  }

  /// The event `changes`: only what changed.
  changes(event) {
    const change = noChange();
    change.jumped = event.t < this.t || (event.acts ?? []).some(({act}) => kJumps.some((key) => key in act));
    this.rev = event.rev;
    this.t = event.t;
    for (const entry of event.devices ?? []) if (this.setDevice(entry[0], entry, 1, event.t)) change.devices.push(entry[0]);
    if (change.jumped) this.paths.fill(null);
    for (const [index, value, flags, since] of event.symbols ?? []) {
      if (this.setSymbol(index, value, flags, since)) change.symbols.push(index);
    }
    for (const [index, number, flags] of event.values ?? []) if (this.setValue(index, number, flags)) change.values.push(index);
    for (const [rank, ...entry] of event.tracks ?? []) {
      this.setTrack(rank, entry);
      change.tracks.push(rank);
    }
    for (const [rank, parts] of event.places ?? []) {
      this.places[rank] = parts;
      change.places.push(rank);
    }
    for (const [index, ...entry] of event.requirements ?? []) {
      this.requirements[index] = entry;
      change.requirements.push(index);
    }
    for (const key of kWhole) {
      if (!(key in event)) continue;
      this[key] = event[key];
      change.keys.add(key);
    }
    if (event.alarms) {
      this.alarms.apply(event.alarms);
      change.keys.add("alarms");
    }
    this.append("findings", event.findings, kMostFindings, change);
    this.append("acts", event.acts, kMostActs, change);
    this.append("messages", event.messages, kMostMessages, change);
    this.publish(change);
  }

  append(key, added, most, change) {
    if (!added || added.length === 0) return;
    change.keys.add(key);
    this[key] = [...this[key], ...added].slice(-most);
  }

  publish(change) {
    for (const listener of this.listeners) listener(change);
  }

  /// Whether the device's move goes on with plant time.
  moves(index) {
    return (this.flags[index] & (DEVICE.moving | DEVICE.stopped | DEVICE.disabled | DEVICE.frozen)) === DEVICE.moving;
  }

  /// How much of a move is done at plant time `now`, 0 to 1, and what is left in nanoseconds.
  progress(index, now) {
    const left = Math.max(0, this.remaining[index] - (this.moves(index) ? Math.max(0, now - this.at[index]) : 0));
    const whole = this.whole[index];
    return {left, done: whole > 0 ? Math.min(1, 1 - left / whole) : 0};
  }

  /// The parts on a track at plant time `now`: [number, kind, x, v] from the front, `x` at that time.
  partsOn(rank, now) {
    const track = this.tracks[rank];
    if (!track) return [];
    const end = this.plant.locations[this.trackLocations[rank]].length;
    const passed = Math.max(0, now - track.t) / 1e9;
    return track.parts.map(([number, kind, x, v]) => [number, kind, Math.max(0, Math.min(end, x + v * passed)), v]);
  }
}
