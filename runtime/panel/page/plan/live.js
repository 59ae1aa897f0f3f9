// The layer of the plan that follows the plant. Only what changed or moves is drawn again, in its own cell, unless cells lie over each other.
import {runs, valuesByDevice} from "./motion.js";
import {cellOf} from "./cells.js";
import {rectOf} from "./geometry.js";
import {kMiddle} from "./draw.js";
import {paintDevice, paintOperator, paintPlace, paintTrack} from "./things.js";
import {reducedMotion} from "../theme.js";

/// The band of a track with sensors and motors, or a place with its sensors.
const bandOf = (placed) => {
  const {x, y, w, h} = rectOf(placed);
  if (placed.kind === "place") return {x: x - .2, y: y - .2, w: w + .4, h: placed.h + .4};
  return placed.turn % 180 === 0 ? {x: x - .5, y: y - .6, w: w + 1, h: h + 1.2} : {x: x - .6, y: y - .5, w: w + 1.2, h: h + 1};
};

export class PlanLive {
  constructor(app, camera) {
    Object.assign(this, {app, camera, all: true, devices: new Set(), locations: new Set(), operators: new Set(), moving: new Set(), movingTracks: new Set()});
    const {plant, store} = app;
    this.values = valuesByDevice(plant);
    this.deviceOfValue = new Map([...this.values].flatMap(([device, list]) => list.map((value) => [value, device])));
    this.ofSensor = new Map();
    plant.locations.forEach(({sensors}, index) => sensors.forEach(({symbol}) => this.ofSensor.set(symbol, [...this.ofSensor.get(symbol) ?? [], index])));
    this.isTrackMoving = (index) => {
      const track = store.tracks[store.rankOfLocation[index]];
      return Boolean(track) && (track.parts.some((part) => part[3] !== 0) || !reducedMotion.matches && camera.scale >= kMiddle / 2 && track.drives.some((speed) => speed !== 0));
    };
  }

  /// After a new layout.
  place(placed) {
    Object.assign(this, {placed, isApart: isApart(placed)});
    this.operatorOf = new Map(placed.operators.map(({symbol}, i) => [symbol, i]));
    this.touchAll();
  }

  touchAll() { this.all = true; }

  /// After an event of the stream; `statusChanged` is a set of devices.
  change(change, statusChanged) {
    const {plant, store} = this.app;
    if (change.all) return this.touchAll();
    for (const device of statusChanged) this.devices.add(device);
    for (const device of change.devices) this.devices.add(device);
    for (const symbol of change.symbols) {
      if (plant.symbols[symbol].device !== null) this.devices.add(plant.symbols[symbol].device);
      for (const location of this.ofSensor.get(symbol) ?? []) this.locations.add(location);
      if (this.operatorOf.has(symbol)) this.operators.add(this.operatorOf.get(symbol));
    }
    for (const value of change.values) if (this.deviceOfValue.has(value)) this.devices.add(this.deviceOfValue.get(value));
    for (const rank of change.tracks) this.locations.add(store.trackLocations[rank]);
    for (const rank of change.places) this.locations.add(store.placeLocations[rank]);
  }

  isMoving(device) {
    const {store} = this.app;
    if (this.camera.scale < kMiddle) return false;
    return store.moves(device) || !reducedMotion.matches && runs(store, device);
  }

  clear(context, rect) {
    const [left, top] = this.camera.toScreen([rect.x, rect.y]).map(Math.floor);
    const [right, bottom] = this.camera.toScreen([rect.x + rect.w, rect.y + rect.h]).map(Math.ceil);
    context.clearRect(left, top, right - left, bottom - top);
  }

  paintDevice(context, device, now, clears) {
    const placed = this.placed.devices[device];
    const cell = cellOf(placed);
    if (!this.camera.sees(cell)) return this.moving.delete(device);
    if (clears) this.clear(context, cell);
    paintDevice(context, this.camera, this.app, device, placed, this.values.get(device), now);
    if (this.isMoving(device)) this.moving.add(device);
    else this.moving.delete(device);
  }

  paintLocation(context, index, now, clears) {
    const placed = this.placed.locations[index];
    const band = bandOf(placed);
    if (!this.camera.sees(band)) return this.movingTracks.delete(index);
    if (clears) this.clear(context, band);
    if (placed.kind === "place") return paintPlace(context, this.camera, this.app, index, placed);
    context.save();
    context.beginPath();
    const [x, y] = this.camera.toScreen([band.x, band.y]);
    context.rect(x, y, band.w * this.camera.scale, band.h * this.camera.scale);
    context.clip();
    paintTrack(context, this.camera, this.app, index, placed, now);
    context.restore();
    if (this.isTrackMoving(index)) this.movingTracks.add(index);
    else this.movingTracks.delete(index);
  }

  paintOperator(context, i, clears) {
    const placed = this.placed.operators[i];
    if (!this.camera.sees(cellOf(placed))) return;
    if (clears) this.clear(context, cellOf(placed));
    paintOperator(context, this.camera, this.app, placed);
  }

  /// Draws what changed; returns whether something moves on.
  draw(context, now) {
    const {placed} = this;
    const clears = !this.all && this.isApart;
    if (this.all || (!clears && this.isDirty())) {
      context.clearRect(0, 0, this.camera.wide, this.camera.high);
      this.moving.clear();
      this.movingTracks.clear();
      for (let i = 0; i < placed.locations.length; ++i) this.paintLocation(context, i, now, false);
      for (let i = 0; i < placed.devices.length; ++i) this.paintDevice(context, i, now, false);
      for (let i = 0; i < placed.operators.length; ++i) this.paintOperator(context, i, false);
    } else if (clears) {
      for (const index of [...new Set([...this.movingTracks, ...this.locations])]) this.paintLocation(context, index, now, true);
      for (const device of [...new Set([...this.moving, ...this.devices])]) this.paintDevice(context, device, now, true);
      for (const i of this.operators) this.paintOperator(context, i, true);
    }
    this.all = false;
    for (const set of [this.devices, this.locations, this.operators]) set.clear();
    return this.moving.size + this.movingTracks.size > 0;
  }

  isDirty() { return this.devices.size + this.locations.size + this.operators.size + this.moving.size + this.movingTracks.size > 0; }
}

/// Whether no cell of a layout lies over another, so that each can be drawn alone.
export const isApart = ({devices, operators, locations}) => {
  const cells = [...[...devices, ...operators].map(cellOf), ...locations.map(bandOf)];
  const near = new Map();
  const kSize = 4;
  const clash = (a, b) => a.x < b.x + b.w - .2 && b.x < a.x + a.w - .2 && a.y < b.y + b.h - .2 && b.y < a.y + a.h - .2;
  for (const cell of cells) {
    for (let gx = Math.floor(cell.x / kSize); gx <= (cell.x + cell.w) / kSize; ++gx) for (let gy = Math.floor(cell.y / kSize); gy <= (cell.y + cell.h) / kSize; ++gy) {
      const key = gx + "," + gy;
      const others = near.get(key) ?? [];
      if (others.some((other) => clash(cell, other))) return false;
      near.set(key, [...others, cell]);
    }
  }
  return true;
};
