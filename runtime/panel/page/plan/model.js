// What a layout needs to know of a plant: frames with their things, tracks and places, and where parts pass from one to another.
// Pure functions, without elements.
import {operatedSymbols, stationFinder} from "../layout.js";

/// What a plan gives for a name; undefined without.
export const givenFor = (map, name) => map && Object.hasOwn(map, name) ? map[name] : undefined;

/// Names without what people write differently: "push 1" is "PUSH1".
const plain = (name) => name.toLowerCase().replace(/[^a-z0-9]/g, "");

/// { at: { location, position } } by device: where it acts, as far as names and the operations of drives say so.
const whereDevicesAct = (plant) => {
  const tracks = new Map(plant.locations.map(({name}, index) => [name, index]));
  const named = new Map();
  for (const {name, from} of plant.transfers) named.set(plain(name), {location: from.location, position: from.at ?? plant.locations[from.location].length ?? 0});
  const byName = new Map(plant.locations.map(({name}, index) => [plain(name), {location: index, position: 0}]));
  const acts = plant.devices.map(({name, label}) => {
    const levels = name.split(/[_.]/);
    const tails = [label, levels.slice(-1)[0], levels.slice(-2).join(""), levels.slice(-1)[0] + (levels[1] ?? ""), name].map(plain);
    const tail = tails.find((text) => named.has(text)) ?? null;
    return tail !== null ? named.get(tail) : byName.get(tails.find((text) => byName.has(text))) ?? null;
  });
  for (const {device, drives} of plant.symbols) {
    if (device === null || acts[device]) continue;
    const track = (drives ?? []).map((text) => /^(?:track|place) (.*)$/.exec(text)?.[1]).find((name) => tracks.has(name));
    if (track !== undefined) acts[device] = {location: tracks.get(track), position: 0};
  }
  return acts;
};

/// Where parts pass on: { from, to, at, into }, positions in micrometers (null: of a place). `isEnd`: the end of a track, else a transfer.
export const passesOf = ({locations, transfers}) => {
  const known = (index) => index !== null && index !== undefined && locations[index] !== undefined;
  const ends = locations.flatMap(({ends, length}, from) => (ends ?? []).filter(({to}) => known(to))
    .map(({to, at}) => ({from, to, at: length, into: locations[to].kind === "track" ? at ?? 0 : null, isEnd: true})));
  const moved = transfers.filter(({from, to}) => known(from.location) && known(to.location)).map(({from, to}) => ({
    from: from.location, to: to.location, at: locations[from.location].kind === "track" ? from.at ?? locations[from.location].length : null,
    into: locations[to.location].kind === "track" ? to.at ?? 0 : null, isEnd: false}));
  return [...ends, ...moved];
};

/// By location: a map from each of its stations to where on it the station is (micrometers; 0 if unknown).
const stationsAlong = (plant, acts) => {
  const find = stationFinder(plant);
  const along = plant.locations.map(({sensors, name}) => {
    const sums = new Map();
    const own = find(name);
    if (own !== null) sums.set(own, [0, 0]);
    for (const {symbol, at} of sensors) {
      const station = find(plant.symbols[symbol].name);
      if (station === null) continue;
      const [sum, count] = sums.get(station) ?? [0, 0];
      sums.set(station, [sum + (at ?? 0), count + 1]);
    }
    return new Map([...sums].map(([station, [sum, count]]) => [station, count > 0 ? sum / count : 0]));
  });
  acts.forEach((act, device) => {
    const {station} = plant.devices[device];
    if (act && station !== null && !along[act.location].has(station)) along[act.location].set(station, act.position);
  });
  return along;
};

/// Locations in no station get the one station with which they exchange parts.
const adopt = (along, passes) => {
  for (let again = true; again;) {
    again = false;
    const near = along.map(() => new Set());
    for (const {from, to} of passes) {
      if (along[from].size === 0) for (const station of along[to].size === 0 ? [null] : along[to].keys()) near[from].add(station);
      if (along[to].size === 0) for (const station of along[from].size === 0 ? [null] : along[from].keys()) near[to].add(station);
    }
    near.forEach((stations, location) => {
      if (along[location].size > 0 || stations.size !== 1 || stations.has(null)) return;
      along[location].set([...stations][0], 0);
      again = true;
    });
  }
};

/// Frames: of stations that have something, and of the groups of the plan. `things` are { device } and { symbol }.
const framesOf = (plant, plan, along) => {
  const frames = plant.stations.map(({name}, station) => ({name, station, things: []}));
  const groups = new Map();
  const loose = [];
  plant.devices.forEach(({name, station}, device) => {
    const group = givenFor(plan.devices, name)?.group;
    if (group !== undefined && !groups.has(group)) {
      const known = frames.findIndex((frame) => frame.name === group && frame.station !== null);
      groups.set(group, known >= 0 ? known : frames.push({name: group, station: null, things: []}) - 1);
    }
    const frame = group !== undefined ? groups.get(group) : station;
    if (frame === null) loose.push({device});
    else frames[frame].things.push({device});
  });
  for (const [station, symbols] of operatedSymbols(plant)) {
    (station === null ? loose : frames[station].things).push(...symbols.map((symbol) => ({symbol})));
  }
  const hasTracks = new Set(along.flatMap((stations) => [...stations.keys()]));
  const kept = frames.map(({things, station}) => things.length > 0 || hasTracks.has(station));
  const index = [];
  let next = 0;
  kept.forEach((keeps, old) => { index[old] = keeps ? next++ : null; });
  return {frames: frames.filter((_, old) => kept[old]), loose, frameOfStation: (station) => index[station]};
};

/// The model of a plant with a plan (what *Edit layout* wrote): what layOut() works on.
export const modelOf = (plant, plan) => {
  const acts = whereDevicesAct(plant);
  const passes = passesOf(plant);
  const along = stationsAlong(plant, acts);
  adopt(along, passes);
  const {frames, loose, frameOfStation} = framesOf(plant, plan, along);
  for (const frame of frames) {
    frame.given = givenFor(plan.frames, frame.name) ?? null;
    frame.isPlain = frame.given !== null || frame.station === null || frame.things.some(({device}) => device !== undefined && givenFor(plan.devices, plant.devices[device].name)?.x !== undefined);
  }
  const locations = plant.locations.map((location, index) => ({index, location, given: givenFor(plan.locations, location.name) ?? null,
    home: along[index].size === 1 ? frameOfStation([...along[index].keys()][0]) : null,
    along: new Map([...along[index]].map(([station, at]) => [frameOfStation(station), at]).filter(([frame]) => !frames[frame].isPlain))}));
  return {frames, loose, locations, passes, acts};
};
