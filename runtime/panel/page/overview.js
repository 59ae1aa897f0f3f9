// The stations of a large plant as small tiles. Each shows its most urgent status, by a letter and a color, and its counts.
import {make, setText} from "./dom.js";
import {stationAddress} from "./links_to.js";
import {STATUSES} from "./status.js";
import {count} from "./words.js";

const kPause = 250;  // ms between two updates of texts: faster ones cannot be read

class Card {
  constructor(name, devices) {
    this.letter = make("span", {class: "letter", "aria-hidden": "true"});
    this.word = make("span", {class: "worst"});
    this.counts = make("span", {class: "counts"});
    this.element = make("a", {class: "card", href: stationAddress(name), title: name},
      make("span", {class: "top"}, make("span", {class: "label"}, name), this.letter),
      this.word, this.counts, make("span", {class: "soft"}, count(devices, "device")));
    this.shown = "";
  }

  update(counts, worst) {
    const texts = [];
    for (let status = STATUSES.length - 1; status >= 0; --status) {
      if (counts[status] > 0) texts.push(STATUSES[status].letter + " " + counts[status]);
    }
    const shown = texts.join("  ");
    if (shown === this.shown) return;
    this.shown = shown;
    setText(this.counts, shown);
    const {key, letter, short} = STATUSES[worst];
    this.element.className = "card s-" + key;
    setText(this.letter, letter);
    setText(this.word, short);
  }
}

export class Overview {
  /// `groups` as groupDevices() returns them; `nameOf(station)`.
  constructor(app, groups, nameOf) {
    this.app = app;
    this.last = -Infinity;
    this.dirty = new Set();
    this.cards = new Map(groups.map(({station, devices}) => [station, new Card(nameOf(station), devices.length)]));
    this.element = make("section", {"aria-label": "Stations", class: "overview"}, [...this.cards.values()].map(({element}) => element));
    this.touchAll();
    this.draw();
  }

  close() {}
  selected() {}
  touch(device) { this.dirty.add(this.app.plant.devices[device].station); }
  touchAll() { for (const station of this.cards.keys()) this.dirty.add(station); }

  /// Returns whether something is left to be drawn.
  draw(_, wall = performance.now()) {
    if (this.dirty.size === 0) return false;
    if (wall - this.last < kPause) return true;
    this.last = wall;
    const {statuses} = this.app;
    for (const station of this.dirty) {
      const counts = station === null ? statuses.loose : statuses.stations[station];
      this.cards.get(station)?.update(counts, statuses.worst(counts));
    }
    this.dirty.clear();
    return false;
  }
}
