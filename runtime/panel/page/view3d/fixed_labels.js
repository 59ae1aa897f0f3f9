// Names in the 3D view that stay where they are: of frames, tracks and places.
import {pointOn} from "../plan/geometry.js";

/// The middle of a track or place in the plan.
export const middleOf = (of) => of.kind === "track" ? pointOn(of, .5, 1) : [of.x + of.w / 2, of.y + of.h / 2];

/// Stations without their line if it is the same for all.
export const fixedLabels = (plant, {frames, locations}) => {
  const [line] = (frames[0]?.name ?? "").split(" ");
  const isShared = frames.length > 1 && frames.every(({name}) => name.startsWith(line + " "));
  const ofFrames = frames.map(({name, x, y, h}) => ({key: "frame " + name, text: isShared ? name.slice(line.length + 1) : name, strong: true, x: x + 1, y: .05, z: y + h}));
  const ofLocations = locations.map((of, index) => {
    const [x, z] = middleOf(of);
    return {key: "location " + index, text: plant.locations[index].name, near: true, x, y: .75, z};
  });
  return [...ofFrames, ...ofLocations];
};
