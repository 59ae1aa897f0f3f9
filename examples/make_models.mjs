// Makes the GLB models of the examples: the cell and the harbour crane. A model is made of boxes and cylinders; each node that moves has a name.
//
// usage: node examples/make_models.mjs [FOLDER]   writes FOLDER/cell/cell.glb and FOLDER/harbour-crane/crane.glb; FOLDER is by default `examples`
import {mkdirSync, writeFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";
import {box, cylinder, Glb, group} from "./glb_writer.mjs";

/// A machine with a door, a store, a dock, a vehicle that carries a part, two stoppers. Meters; the vehicle is at the store.
const cell = () => {
  const glb = new Glb({floor: [.75, .77, .8], line: [.9, .72, .2], frame: [.35, .4, .46], body: [.85, .86, .88], blue: [.25, .42, .66], dark: [.2, .22, .25], steel: [.62, .65, .7], part: [.75, .5, .25], glass: [.55, .75, .85, .45]});
  return glb.pack(group("Cell", [0, 0, 0], [
    box("Floor", "floor", [3, -.05, 0], [11, .1, 5]),
    box("Lane", "line", [2.2, .005, 0], [7.4, .01, .06]),
    group("Store", [0, 0, -1.4], [box("Base", "frame", [0, 0, 0], [1.2, .7, .9]), box("Back", "frame", [0, .7, -.4], [1.2, 1, .1]),
      ...[-.35, 0, .35].map((x) => box("Part", "part", [x, .7, 0], [.26, .22, .3]))]),
    group("Dock", [6, 0, -1.2], [box("Pillar", "frame", [0, 0, 0], [.5, 1.3, .3]), box("Plug", "line", [0, .35, .2], [.3, .2, .1])]),
    group("AGV", [0, 0, 0], [box("Chassis", "blue", [0, .12, 0], [1.1, .3, .8]), box("Deck", "dark", [0, .42, 0], [1, .06, .7]), box("Carried", "part", [0, .48, 0], [.26, .22, .3]),
      ...[[-.38, -.36], [-.38, .36], [.38, -.36], [.38, .36]].map(([x, z]) => cylinder("Wheel", "dark", [x, .14, z], [.28, .08, .28], [90, 0, 0]))]),
    group("Machine", [3, 0, -1.6], [box("Table", "frame", [0, 0, 0], [2, .8, 1.4]), box("Column", "body", [0, .8, -.5], [2, 1.6, .4]), box("Left", "body", [-.95, .8, 0], [.1, 1.6, 1.4]),
      box("Right", "body", [.95, .8, 0], [.1, 1.6, 1.4]), box("Roof", "body", [0, 2.4, 0], [2, .1, 1.4]),
      group("Spindle", [0, 1.5, 0], [cylinder("Motor", "steel", [0, .2, 0], [.36, .6, .36]), cylinder("Tool", "dark", [0, -.25, 0], [.1, .45, .1])]),
      group("Door", [0, .8, .72], [box("Panel", "glass", [0, 0, 0], [1.76, 1.5, .04]), box("Handle", "steel", [0, .1, .04], [.5, .06, .06])]),
      cylinder("Lamp", "line", [.8, 2.5, -.4], [.12, .35, .12])]),
    ...[["Stopper1", 4.2], ["Stopper2", 5.1]].map(([name, x]) => group(name, [x, 0, .75], [box("Base", "frame", [0, 0, 0], [.3, .2, .3]), box("Pin", "steel", [0, .05, 0], [.14, .2, .14])])),
  ]));
};

/// A crane on a quay with a ship. Meters; it is as at the start: angle 0, radius 20, height 10. The ropes are four pieces that slide along each other.
const crane = () => {
  const glb = new Glb({quay: [.62, .62, .6], water: [.25, .42, .52], hull: [.3, .12, .12], hold: [.55, .5, .45], steel: [.85, .62, .15], dark: [.22, .24, .27], house: [.88, .88, .86], rope: [.1, .1, .1], load: [.45, .47, .5]});
  const legs = [[-5, -5], [-5, 5], [5, -5], [5, 5]];
  return glb.pack(group("Crane", [0, 0, 0], [
    box("Quay", "quay", [-9, -1.5, 0], [34, 1.5, 60]),
    box("Water", "water", [26, -3, 0], [36, .4, 60]),
    group("Ship", [22, -2.6, 0], [box("Hull", "hull", [0, 0, 0], [18, 7, 54]), box("Hold", "hold", [0, 7, 5], [13, .4, 34]), box("Bridge", "house", [0, 7, -21], [16, 11, 8])]),
    group("Portal", [0, 0, 0], [...legs.map(([x, z]) => box("Leg", "steel", [x, 0, z], [1.4, 15, 1.4])), box("Deck", "steel", [0, 15, 0], [12, 1.6, 12]), cylinder("Ring", "dark", [0, 16.6, 0], [7, 1, 7])]),
    group("Upper", [0, 17.6, 0], [
      box("House", "house", [-5, 0, 0], [9, 5, 6]), box("Cabin", "house", [2.5, 0, 3], [2.6, 3, 2.4]), box("Tower", "steel", [0, 0, 0], [2.4, 34, 2.4]),
      box("Jib", "steel", [15, 27.4, 0], [56, 1.6, 1.8]), box("Weight", "dark", [-12, 25, 0], [4, 4, 3.4]),
      cylinder("HoistBrake", "dark", [-8.5, 5, -2], [1.6, .8, 1.6]), cylinder("SlewBrake", "dark", [-5.5, 5, -2], [1.6, .8, 1.6]), cylinder("LuffBrake", "dark", [-2.5, 5, -2], [1.6, .8, 1.6]),
      group("Trolley", [20, 27.4, 0], [box("Winch", "dark", [0, 1.6, 0], [2.6, 3.6, 2.6]), box("Carriage", "dark", [0, -.6, 0], [3, .6, 3]),
        group("Sway", [0, 0, 0], [
          ...[1, 2, 3, 4].map((i) => group("Rope" + i, [0, -8 * (i - .5), 0], [box("Line", "rope", [0, -5.25, 0], [.22, 10.5, .22])])),
          group("Grab", [0, -35, 0], [box("Head", "dark", [0, 1.8, 0], [2.2, 1.2, 2.2]), group("Load", [0, -1.4, 0], [box("Shells", "load", [0, 0, 0], [3.4, 3.2, 3.4])])])])])]),
  ]));
};

const folder = process.argv[2] ?? dirname(fileURLToPath(import.meta.url));
for (const [path, model] of [["cell/cell.glb", cell()], ["harbour-crane/crane.glb", crane()]]) {
  mkdirSync(dirname(join(folder, path)), {recursive: true});
  writeFileSync(join(folder, path), model);
  console.log(join(folder, path) + ": " + model.length + " bytes");
}
