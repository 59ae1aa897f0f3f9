// Invented plants for the tests of the plan's layout, from a seed.

/// Numbers from 0 to 1 that depend on the seed only (xorshift).
export const randomFrom = (seed) => {
  let state = (seed * 2654435761 + 1) >>> 0 || 1;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    state >>>= 0;
    return state / 4294967296;
  };
};

const emptyPlant = (stations) => ({plant: "invented", mode: "live", stations: Array.from({length: stations}, (_, i) => ({name: "L S" + i, line: "L", process: "S" + i})),
  devices: [], symbols: [], locations: [], transfers: [], part_kinds: [], values: []});

export const addDevice = (plant, station, label) => plant.devices.push({name: (station === null ? "X_Y" : "L_S" + station) + "_" + label, label, station, states: ["A", "B"],
  operations: [], events: [], actuation: "latched", shape: "device"}) - 1;

export const addSensor = (plant, station, more = {}) => plant.symbols.push({name: "L_S" + station + "_EYE" + plant.symbols.length + "_I_ON", device: null, direction: "event",
  type: "BOOL", ...more}) - 1;

/// A track with a sensor in each of its stations, in their order.
export const addTrack = (plant, stations, length = 3e6) => plant.locations.push({name: "T" + plant.locations.length, kind: "track", length, drives: [{from: 0, until: length}],
  stops: [], ends: [], sensors: stations.map((station, i) => ({symbol: addSensor(plant, station), at: Math.round(length * (i + 1) / (stations.length + 1))}))}) - 1;

export const addPlace = (plant, station, holds) => plant.locations.push({name: "P" + plant.locations.length, kind: "place", holds,
  sensors: station === null ? [] : [{symbol: addSensor(plant, station)}]}) - 1;

/// A line of stations, each with a track that ends in the next one; `loop`: the last ends in the first.
export const lineOf = (stations, devices, loop = false) => {
  const plant = emptyPlant(stations);
  for (let station = 0; station < stations; ++station) {
    addTrack(plant, [station]);
    for (let i = 0; i < devices; ++i) addDevice(plant, station, "D" + i);
  }
  plant.locations.forEach((track, i) => { if (loop || i + 1 < stations) track.ends = [{to: (i + 1) % stations}]; });
  return plant;
};

/// Any plant: stations of many sizes, tracks in none, one or many of them, places, loops, branches, operators.
export const inventedPlant = (seed) => {
  const random = randomFrom(seed);
  const upTo = (most) => Math.floor(random() * (most + 1));
  const stations = 1 + upTo(12);
  const plant = emptyPlant(stations);
  for (let station = 0; station < stations; ++station) for (let i = upTo(random() < .2 ? 60 : 9); i > 0; --i) addDevice(plant, station, "D" + i);
  for (let i = upTo(4); i > 0; --i) addDevice(plant, null, "LOOSE" + i);
  for (let i = upTo(10); i > 0; --i) {
    if (random() < .3) addPlace(plant, random() < .6 ? upTo(stations - 1) : null, 1 + upTo(20));
    else addTrack(plant, Array.from({length: random() < .3 ? upTo(6) : random() < .8 ? 1 : 0}, () => upTo(stations - 1)), 1e5 + upTo(8e7));
  }
  const {length} = plant.locations;
  const tracks = plant.locations.filter(({kind}) => kind === "track");
  for (const track of tracks) if (random() < .7) track.ends = [{to: random() < .2 ? null : upTo(length - 1)}];
  for (let i = length > 0 ? upTo(8) : 0; i > 0; --i) {
    const [from, to] = [upTo(length - 1), upTo(length - 1)];
    const end = (index) => plant.locations[index].kind === "track" ? {location: index, at: upTo(plant.locations[index].length)} : {location: index};
    plant.transfers.push({name: "move " + i, from: end(from), to: random() < .2 ? {location: null} : plant.locations[to].kind === "track" && random() < .6 ? {location: to} : end(to)});
  }
  for (let i = upTo(5); i > 0; --i) addSensor(plant, upTo(stations), {operator: true});
  return plant;
};

/// Positions for some devices of frames without one: those of `placed`, moved in each frame by up to -40.
export const someNegative = (plant, placed, seed) => {
  const random = randomFrom(seed + 2000);
  const off = placed.frames.map(() => [-40 * random(), -40 * random()]);
  return {devices: Object.fromEntries(plant.devices.flatMap(({name}, i) => {
    const {x, y, frame} = placed.devices[i];
    return frame === null || random() < .5 ? [] : [[name, {x: x - placed.frames[frame].x + off[frame][0], y: y - placed.frames[frame].y + off[frame][1]}]];
  }))};
};

/// Positions for some of the things of a plant, none over another.
export const somePositions = (plant, placed, seed) => {
  const random = randomFrom(seed + 1000);
  const plan = {frames: {}, devices: {}, locations: {}};
  for (const {name, x, y} of placed.frames) if (random() < .3) plan.frames[name] = {x: x + 3, y: y - 2};
  plant.devices.forEach(({name}, i) => {
    const {x, y, frame} = placed.devices[i];
    const {x: fx, y: fy} = frame === null ? {x: 0, y: 0} : placed.frames[frame];
    if (random() < .2) plan.devices[name] = {x: x - fx, y: y - fy, turn: 90 * Math.floor(random() * 4)};
  });
  plant.locations.forEach(({name}, i) => {
    const {kind, x, y, length, turn} = placed.locations[i];
    if (random() < .2) plan.locations[name] = kind === "track" ? {x: x + 3, y: y - 2, length, turn} : {x: x + 3, y: y - 2};
  });
  return plan;
};
