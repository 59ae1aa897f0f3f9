// What has a given position in a layout, and what is in frames that have one. Pure functions, without elements.
import {gridBlock} from "./blocks.js";
import {kFoot, kPitch, kSide} from "./cells.js";
import {makeInto, overlaps, rectOf} from "./geometry.js";
import {givenFor} from "./model.js";
import {kBelt, slotsOf} from "./tracks.js";

/// A frame reaches to the right and down as far as its tracks and places do that begin in it.
const enclose = (frame, rects) => {
  for (const {x, y, w, h} of rects) {
    if (x < frame.x || y < frame.y) continue;
    frame.w = Math.max(frame.w, x + w + kSide - frame.x);
    frame.h = Math.max(frame.h, y + h + kFoot - frame.y);
  }
};

/// What has a given position. Things of a frame with a given position that have none themselves fill its free cells.
export const putGiven = (plant, plan, model, kept, out) => {
  for (const {index, location, given, length} of model.locations) {
    if (!given) continue;
    const {columns, rows} = slotsOf(location);
    out.locations[index] = location.kind === "place" ? {kind: "place", x: given.x, y: given.y, w: columns, h: rows, columns}
      : {kind: "track", x: given.x, y: given.y, length: given.length ?? length, turn: given.turn ?? 0, width: kBelt};
  }
  const givenOf = ({device, symbol}) => {
    const given = device === undefined ? kept.get(symbol) : givenFor(plan.devices, plant.devices[device].name);
    return given?.x !== undefined ? given : null;
  };
  const fixed = [];  // centers of symbols
  for (const {given, things} of model.frames) if (given) fixed.push(...things.map(givenOf).filter((at) => at).map(({x, y}) => [given.x + x, given.y + y]));
  for (const thing of model.loose) {
    const at = givenOf(thing);
    if (!at) continue;
    out.put(thing, [at.x, at.y]);
    fixed.push([at.x, at.y]);
  }
  const belts = out.locations.filter((placed) => placed).map(rectOf);
  model.frames.forEach(({given, things}, frame) => {
    if (!given) return;
    const isFree = (x, y) => fixed.every(([ox, oy]) => Math.abs(ox - given.x - x) >= kPitch || Math.abs(oy - given.y - y) >= kPitch)
      && belts.every((belt) => !overlaps(belt, {x: given.x + x - 1, y: given.y + y - 1, w: kPitch, h: kPitch}));
    const block = gridBlock(things, frame, 1.6, things.map((thing) => {
      const at = givenOf(thing);
      return at ? [at.x, at.y] : null;
    }), isFree);
    block.emit(makeInto(1, given.x, given.y), out);
    enclose(out.frames[frame], model.locations.filter((location) => location.given && location.home === frame).map(({index}) => rectOf(out.locations[index])));
    fixed.push(...things.map(({device}) => device).filter((device) => device !== undefined).map((device) => [out.devices[device].x, out.devices[device].y]));
  });
};
