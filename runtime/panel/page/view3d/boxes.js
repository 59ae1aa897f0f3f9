// The plant in 3D without a model: the plan with solids. Frames are areas on the floor, tracks are belts, places are trays.
import {Group} from "../build/three.module.js";
import {pointOn, slotOf} from "../plan/geometry.js";
import {levelOf, motionOf, runs, valuesByDevice} from "../plan/motion.js";
import {after, kSame, placed, shift, turn} from "./affine.js";
import {Batch} from "./batch.js";
import {deviceColors, litColor, sceneColors} from "./colors.js";
import {fixedLabels, middleOf} from "./fixed_labels.js";
import {partMatrix, Parts} from "./parts.js";
import {kLit, kSpinning, shapeOf} from "./shapes.js";
import {box, joined} from "./solids.js";
import {reducedMotion} from "../theme.js";

const kMostDetailed = 2500;  // devices; more are plain boxes
const kBelt = .3;            // its height
const kPartHigh = .3;
const kTurn = 8e8;           // ns of plant time of one turn of what spins
const kUnknownLevel = .5;    // of a tank without a value that says it

export class Boxes {
  constructor(app, layout) {
    Object.assign(this, {app, layout, selected: null, active: new Set(), isTranslucent: false, kept: null, colors: sceneColors()});
    const {devices} = app.plant;
    this.values = valuesByDevice(app.plant);
    this.floor = new Batch({polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1});
    this.housings = new Batch();
    this.movers = new Batch();
    this.parts = new Parts();
    this.makeFloor();
    this.locations = layout.locations.map((location, index) => this.makeLocation(location, index));
    this.devices = devices.map((device, index) => this.makeDevice(device, index, devices.length > kMostDetailed));
    for (const batch of [this.floor, this.housings, this.movers]) batch.finish();
    this.root = new Group();
    this.root.add(this.floor.mesh, this.housings.mesh, this.movers.mesh, this.parts.mesh);
    this.targets = [this.housings.mesh, this.movers.mesh];
    this.labels = fixedLabels(app.plant, layout).concat(layout.devices.map(({x, y}, device) => ({near: true, device, x, y: 1.05, z: y})));
    this.touchAll();
  }

  bounds() {
    const {x, y, w, h} = this.layout.bounds;
    return {min: [x, 0, y], max: [x + w, 1, y + h]};
  }

  makeFloor() {
    const {line, floor} = this.colors;
    for (const {x, y, w, h} of this.layout.frames) {
      this.floor.add(box(x + w / 2, -.04, y + h / 2, w, .02, h), line);
      this.floor.add(box(x + w / 2, -.02, y + h / 2, w - .16, .02, h - .16), floor);
    }
    for (const {points} of this.layout.joins) points.slice(1).forEach(([x, y], i) => {
      const [fromX, fromY] = points[i];
      const length = Math.hypot(x - fromX, y - fromY);
      const angle = Math.atan2(y - fromY, x - fromX) * 180 / Math.PI;
      this.floor.add(box(length / 2, 0, 0, length, .02, .12), line, after(shift(fromX, 0, fromY), turn("y", -angle)));
    });
  }

  makeLocation(location, index) {
    const tag = {kind: "location", index};
    if (location.kind === "track") {
      const {length, width} = location;
      const at = placed(location);
      this.housings.add(joined(box(length / 2, kBelt - .1, -width / 2, length, .14, .04), box(length / 2, kBelt - .1, width / 2, length, .14, .04),
        ...Array.from({length: Math.max(2, Math.round(length / 2))}, (_, i, {length: n} = {length: Math.max(2, Math.round(length / 2))}) =>
          box(.1 + (length - .2) * i / (n - 1), 0, 0, .08, kBelt - .1, width))), this.colors.housing, at, tag);
      this.housings.add(box(length / 2, kBelt - .08, 0, length, .06, width - .04), this.colors.belt, at, tag);
    } else {
      const {x, y, w, h} = location;
      this.housings.add(box(x + w / 2, 0, y + h / 2, w, .12, h), this.colors.belt, kSame, tag);
    }
    return location;
  }

  makeDevice(device, index, simple) {
    const shape = shapeOf(device.shape, simple);
    const place = placed(this.layout.devices[index]);
    const tag = {kind: "device", index};
    return {shape, place, kind: device.shape, values: this.values.get(index), at: null,
      body: this.housings.add(shape.body, this.colors.housing, place, tag),
      movers: shape.movers.map(({solid, at}) => ({at, slot: this.movers.add(solid, this.colors.mover, place, tag)}))};
  }

  /// Where the device is between its ends, at plant time `now`.
  where(index, now) {
    const {store} = this.app;
    const {kind, values} = this.devices[index];
    if (kind === "tank") return levelOf(store, values) ?? kUnknownLevel;
    if (kSpinning.has(kind)) return this.spins(index) && !reducedMotion.matches ? now % kTurn / kTurn : 0;
    const {amount, turn: turned} = motionOf(store, index, now);
    return kind === "turntable" ? turned : amount;
  }

  spins(index) { return kSpinning.has(this.devices[index].kind) && runs(this.app.store, index); }

  touch(index) {
    const device = this.devices[index];
    const {body, mover} = deviceColors(this.colors, this.app.statuses.of[index]);
    this.housings.paint(device.body, body);
    const isOn = kLit.has(device.kind) && this.where(index, this.app.store.t) > .5;
    for (const {slot} of device.movers) this.movers.paint(slot, isOn ? litColor(this.app.plant.devices[index]) : device.kind === "tank" ? this.colors.liquid : mover);
    device.at = null;
    this.active.add(index);
    if (this.kept && this.selected.kind === "device" && this.selected.index === index) for (const slot of this.kept.slots) this.kept.paint(slot, body);
  }

  touchAll() { this.devices.forEach((_, index) => this.touch(index)); }

  /// Moves what has moved until plant time `now`; returns whether something moves on.
  draw(now) {
    const {store, clock} = this.app;
    let again = this.drawParts(now);
    for (const index of this.active) {
      const device = this.devices[index];
      const p = device.movers.length > 0 ? this.where(index, now) : null;
      const [moves, spins] = [store.moves(index), this.spins(index)];
      again ||= moves || (spins && clock.runs && !reducedMotion.matches);
      if (!moves && !spins && device.kind !== "tank") this.active.delete(index);
      if (p === device.at) continue;
      device.at = p;
      for (const {slot, at} of device.movers) this.movers.move(slot, after(device.place, at(p)));
    }
    return again;
  }

  drawParts(now) {
    const {store, plant} = this.app;
    let again = false;
    const parts = [];
    store.trackLocations.forEach((index, rank) => {
      const track = this.layout.locations[index];
      const scale = track.length / plant.locations[index].length;
      const turned = turn("y", -track.turn);
      for (const [, kind, at, speed] of store.partsOn(rank, now)) {
        const long = Math.min((plant.part_kinds[kind]?.length ?? 2e5), at) * scale;
        const [x, y] = pointOn(track, at - long / scale / 2, plant.locations[index].length);
        parts.push({matrix: partMatrix([x, kBelt, y], turned, Math.max(.05, long - .03), kPartHigh, track.width * .7), color: this.colors.kinds(kind)});
        again ||= speed !== 0;
      }
    });
    store.placeLocations.forEach((index, rank) => {
      (store.places[rank] ?? []).forEach(([, kind], i) => {
        const [x, y] = slotOf(this.layout.locations[index], i);
        parts.push({matrix: partMatrix([x, .12, y], kSame, .5, kPartHigh, .5), color: this.colors.kinds(kind)});
      });
    });
    this.parts.draw(parts);
    return again;
  }

  /// Names to show: { x, y, z, near } and, of a device, its index, else { key, text, strong }. `near`: only if the camera is near enough.
  names() { return this.labels; }

  /// { center, size } of a device or location.
  outline({kind, index}) {
    if (kind === "device") {
      const {x, y} = this.layout.devices[index];
      return {center: [x, .6, y], size: [1.04, 1.24, 1.04], turn: 0};
    }
    const of = this.layout.locations[index];
    const [x, z] = middleOf(of);
    return of.kind === "track" ? {center: [x, .3, z], size: [of.length + .1, .64, of.width + .16], turn: of.turn} : {center: [x, .3, z], size: [of.w + .1, .64, of.h + .1], turn: 0};
  }

  /// What is selected stays as it is while the rest is translucent. `tag` is { kind, index } or null.
  select(tag) {
    this.kept?.dispose();
    this.kept = null;
    this.selected = tag;
    const slots = tag === null ? [] : this.housings.slots.filter((slot) => slot.tag?.kind === tag.kind && slot.tag.index === tag.index);
    if (slots.length === 0) return;
    this.kept = new Batch();
    for (const {solid, color, matrix} of slots) this.kept.add(solid, color, matrix);
    this.kept.finish();
    this.kept.mesh.visible = this.isTranslucent;
    this.root.add(this.kept.mesh);
  }

  /// What was hit: { kind, index } or null.
  tagOf({object, faceIndex}) {
    const batch = [this.housings, this.movers].find(({mesh}) => mesh === object);
    return batch ? batch.tagOf(faceIndex) : null;
  }

  setTranslucent(on) {
    this.isTranslucent = on;
    this.housings.setTranslucent(on);
    if (this.kept) this.kept.mesh.visible = on;
  }

  dispose() { for (const each of [this.floor, this.housings, this.movers, this.parts, this.kept]) each?.dispose(); }
}
