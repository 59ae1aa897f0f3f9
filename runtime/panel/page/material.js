// Tracks and places, as a part of the line view. Only those that can be seen are drawn.
import {make} from "./dom.js";
import {kindLegend} from "./kinds.js";
import {Place} from "./place.js";
import {onTheme} from "./theme.js";
import {Track} from "./track.js";

export class Material {
  /// `locations` are indexes of the plant's locations. Compact tracks are low.
  constructor(app, locations, compact) {
    const {plant} = app;
    this.app = app;
    this.items = locations.map((index) => plant.locations[index].kind === "track" ? new Track(app, index, compact) : new Place(app, index));
    this.itemOf = new Map(this.items.map((item) => [item.element, item]));
    this.ofSensor = new Map();
    for (const item of this.items) for (const {symbol} of item.location.sensors) {
      this.ofSensor.set(symbol, [...this.ofSensor.get(symbol) ?? [], item]);
    }
    this.ofLocation = new Map(this.items.map((item) => [item.index, item]));
    this.seen = new Set();
    const of = (kind) => this.items.filter(({location}) => location.kind === kind).map(({element}) => element);
    this.element = make("section", {"aria-label": "Tracks and places", class: "material"}, kindLegend(plant),
      make("div", {class: "tracks"}, of("track")), make("div", {class: "places"}, of("place")));
    this.observer = new IntersectionObserver((entries) => this.observed(entries), {rootMargin: "80px"});
    for (const item of this.items) this.observer.observe(item.element);
    this.endTheme = onTheme(() => this.items.forEach((item) => item.redraw()));
  }

  close() {
    this.observer.disconnect();
    this.endTheme();
    for (const item of this.items) item.close();
  }

  observed(entries) {
    for (const {target, isIntersecting} of entries) {
      const item = this.itemOf.get(target);
      if (isIntersecting) this.seen.add(item);
      else this.seen.delete(item);
      item.touchAll();
    }
    this.app.frames.request();
  }

  change(change) {
    const {trackLocations, placeLocations} = this.app.store;
    if (change.all) this.items.forEach((item) => item.touchAll());
    for (const rank of change.tracks) this.ofLocation.get(trackLocations[rank])?.touchParts();
    for (const rank of change.places) this.ofLocation.get(placeLocations[rank])?.touchParts();
    for (const symbol of change.symbols) for (const item of this.ofSensor.get(symbol) ?? []) item.touchSensors();
  }

  /// Returns whether something moves.
  draw(now) {
    let again = false;
    for (const item of this.seen) again = item.draw(now) || again;
    return again;
  }
}
