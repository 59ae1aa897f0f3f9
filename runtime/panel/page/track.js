// A track in the line view: a strip to scale, on which parts move.
import {make, setAttribute, setText} from "./dom.js";
import {drivesText, driveText} from "./drive_words.js";
import {placeMarks, placeNames} from "./layout.js";
import {linkTo} from "./links_to.js";
import {SYMBOL} from "./store.js";
import {fitCanvas, reducedMotion} from "./theme.js";
import {drawBelt, drawMarks, drawMotors, drawParts, kCompact, kFull, measureNames, sensorAt, xOf} from "./track_draw.js";
import {count, isOn} from "./words.js";

/// What a sensor is called on its track: without the levels that it shares with the others.
const shortNames = (names) => {
  const parts = names.map((name) => name.split("_"));
  let common = 0;
  while (parts.every((levels) => levels.length > common + 2 && levels[common] === parts[0][common])) ++common;
  return parts.map((levels) => levels.slice(common).filter((level) => level !== "I").join(" "));
};

export class Track {
  /// `index` is that of the location. A compact strip is lower, without the names of sensors.
  constructor(app, index, compact) {
    const {plant, store} = app;
    Object.assign(this, {app, index, rank: store.rankOfLocation[index], location: plant.locations[index], width: 0,
      form: compact ? kCompact : kFull, hasMotors: plant.mode !== "recording", marksDirty: true, partsDirty: true});
    const names = shortNames(this.location.sensors.map(({symbol}) => plant.symbols[symbol].name));
    this.sensors = this.location.sensors.map(({symbol, at}, i) => ({symbol, at, text: names[i]}));
    this.transfers = plant.transfers.flatMap(({from, to}) => [
      ...(from.location === index ? [{at: from.at ?? this.location.length, into: false}] : []),
      ...(to.location === index ? [{at: to.at ?? 0, into: true}] : [])]);
    this.canvas = make("canvas", {"aria-hidden": "true", onclick: (event) => this.clicked(event),
      onpointermove: (event) => this.pointed(event)});
    this.strip = make("div", {class: "strip"}, this.canvas);
    this.still = document.createElement("canvas");
    this.parts = make("span", {class: "soft"});
    this.drives = make("span", {class: "drive"});
    this.element = make("section", {class: compact ? "track compact" : "track", "data-location": this.location.name},
      make("div", {class: "row track-head"}, linkTo("location", this.location.name), this.parts, this.drives, this.ends()), this.strip);
    this.size = new ResizeObserver(() => this.resize());
    this.size.observe(this.strip);
  }

  ends() {
    const to = this.location.ends.map(({to}) => to === null ? "out" : linkTo("location", this.app.names.name("location", to)));
    return make("span", {class: "soft"}, to.length === 0 ? "hard end" : "→ ", to.map((end, i) => [i > 0 ? ", " : "", end]));
  }

  close() { this.size.disconnect(); }

  resize() {
    const width = this.strip.clientWidth;
    if (width === this.width || width === 0) return;
    this.width = width;
    this.context = fitCanvas(this.canvas, width, this.form.height);
    this.redraw();
  }

  /// After a change of size or colors.
  redraw() {
    if (this.width === 0) return;
    const {height} = this.form;
    drawBelt(fitCanvas(this.still, this.width, height), this.location, this.width, this.form, this.transfers);
    this.context.clearRect(0, 0, this.width, height);
    this.context.drawImage(this.still, 0, 0, this.still.width, this.still.height, 0, 0, this.width, height);
    measureNames(this.context, this.sensors);
    placeMarks(this.sensors, (at) => xOf(this.location, this.width, at));
    placeNames(this.sensors, this.width);
    this.touchAll();
    this.app.frames.request();
  }

  touchAll() { this.marksDirty = this.partsDirty = true; }
  touchSensors() { this.marksDirty = true; }
  touchParts() { this.partsDirty = true; }

  /// A click on a sensor selects its symbol, another one the track.
  clicked({offsetX, offsetY}) {
    const {router, names} = this.app;
    const sensor = sensorAt(this.form, this.sensors, offsetX, offsetY);
    if (sensor) router.select("symbol", names.name("symbol", sensor.symbol));
    else router.select("location", this.location.name);
  }

  /// The name of a sensor that has no room for it is shown when the pointer is on it; the details of the track list all.
  pointed({offsetX, offsetY}) {
    const sensor = sensorAt(this.form, this.sensors, offsetX, offsetY);
    const {name, comment} = sensor ? this.app.plant.symbols[sensor.symbol] : {};
    setAttribute(this.canvas, "title", sensor ? [name, comment].filter((text) => text).join("\n") : null);
  }

  sensorState({symbol}) {
    const {plant, values, symbolFlags} = this.app.store;
    return {on: isOn(plant.symbols[symbol], values[symbol]), forced: (symbolFlags[symbol] & SYMBOL.forced) !== 0};
  }

  isMoving() {
    const track = this.app.store.tracks[this.rank];
    return Boolean(track) && (track.parts.some((part) => part[3] !== 0) || !reducedMotion.matches && track.drives.some((speed) => speed !== 0));
  }

  /// After a change of the track. A recording does not know its drives.
  writeTexts({parts, drives}) {
    setText(this.parts, count(parts.length, "part"));
    if (this.hasMotors) {
      setText(this.drives, drivesText(drives, this.form === kCompact));
      setAttribute(this.drives, "title", drives.map(driveText).join("; "));
    }
    this.drives.classList.toggle("runs", drives.some((speed) => speed !== 0));
  }

  /// Returns whether parts move on.
  draw(now) {
    if (this.width === 0) return false;
    const {store, plant} = this.app;
    const track = store.tracks[this.rank];
    const moving = this.isMoving();
    if (this.marksDirty) {
      this.marksDirty = false;
      drawMarks(this.context, this.still, this.location, this.width, this.form,
        this.sensors.map((sensor) => ({...sensor, ...this.sensorState(sensor)})));
    }
    if (this.partsDirty && track) this.writeTexts(track);
    if (moving || this.partsDirty) {
      this.partsDirty = false;
      const speeds = track?.drives ?? [];
      const seconds = reducedMotion.matches ? 0 : now / 1e9;
      if (this.hasMotors) drawMotors(this.context, this.still, this.location, this.width, this.form, speeds, seconds);
      drawParts(this.context, this.still, this.location, this.width, this.form, {parts: store.partsOn(this.rank, now), kinds: plant.part_kinds,
        speeds, stops: track?.stops ?? [], seconds});
    }
    return moving;
  }
}
