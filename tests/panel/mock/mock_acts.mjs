// The acts, explanations and exercises of the mock plant.

const kKinds = ["set", "state", "put", "take", "force", "release", "start", "stop", "run", "freeze", "step", "speed", "reset", "snapshot", "save", "restore",
  "forget", "exercise", "end", "session", "count", "acknowledge", "shelve", "unshelve", "silence"];

const indexOf = (list, name, what) => {
  const index = list.findIndex((entry) => entry.name === name);
  if (index < 0) throw new Error("`" + name + "` is not a " + what);
  return index;
};

const copy = (plant) => structuredClone({t: plant.t, devices: plant.devices, symbols: plant.symbols, malfunctions: plant.malfunctions, tracks: plant.tracks, places: plant.places,
  requirements: plant.requirements, moving: plant.moving});

const setMalfunction = (plant, name, active) => {
  const of = plant.malfunctionOf(name);
  if (!of) throw new Error("`" + name + "` is not a malfunction of this plant");
  plant.malfunctions = plant.malfunctions.filter(([other]) => other !== name);
  if (active) plant.malfunctions.push([name, plant.t, "hand"]);
  plant.changed.keys.add("malfunctions");
  if (of.symbol !== undefined) plant.set(of.symbol, {broken: active ? of.value : undefined});
  else plant.step(of.device);
};

const release = (plant, names) => {
  if (names === "all") plant.symbols.forEach(({forced}, index) => { if (forced !== undefined) plant.set(index, {forced: undefined}); });
  else for (const name of names) plant.set(indexOf(plant.description.symbols, name, "symbol"), {forced: undefined});
};

const setSymbols = (plant, values, key) => {
  for (const [name, value] of Object.entries(values)) {
    const index = indexOf(plant.description.symbols, name, "symbol");
    const {type, driver} = plant.description.symbols[index];
    if ((type === "BOOL") !== (typeof value === "boolean")) throw new Error("`" + name + "` is " + type + " and cannot have the value `" + value + "`");
    if (key === "plain" && driver === "device") throw new Error("`" + name + "` is driven by its device; use `state` to move the device, or `force`");
    plant.set(index, {[key]: value});
  }
};

const restore = (plant, name) => {
  const snapshot = plant.snapshots.find((entry) => entry.name === name);
  if (!snapshot) throw new Error("there is no snapshot `" + name + "`");
  Object.assign(plant, structuredClone(snapshot.state));
  jump(plant);
};

const jump = (plant) => {
  plant.log = [];
  plant.description.devices.forEach((_, index) => plant.changed.devices.add(index));
  plant.description.symbols.forEach((_, index) => plant.changed.symbols.add(index));
  for (const key of ["tracks", "places", "requirements"]) plant[key].forEach((_, index) => plant.changed[key].add(index));
  for (const key of ["malfunctions", "clock", "exercise"]) plant.changed.keys.add(key);
};

const at = (plant, text) => {
  const [name, position] = text.split("@");
  const index = indexOf(plant.description.locations, name, "track or place");
  return {location: plant.description.locations[index], index, position: position ? parseFloat(position) * (/mm/.test(position) ? 1e3 : 1e6) : null};
};

const put = (plant, {at: where, kind}) => {
  const {location, position} = at(plant, where);
  const of = indexOf(plant.description.part_kinds, kind, "kind of part");
  const rank = plant.description.locations.filter((other) => other.kind === location.kind).indexOf(location);
  plant.made = (plant.made ?? 50000) + 1;
  if (location.kind === "track") {
    const {length} = plant.description.part_kinds[of];
    plant.tracks[rank].parts.push([plant.made, of, Math.max(length, (position ?? 0) + length / 2), 0]);
    plant.changed.tracks.add(rank);
    return;
  }
  if (plant.places[rank].length >= location.holds) throw new Error("`" + location.name + "` has no room for a part");
  plant.places[rank].push([plant.made, of]);
  plant.changed.places.add(rank);
};

const take = (plant, where) => {
  const {location} = at(plant, where);
  const rank = plant.description.locations.filter((other) => other.kind === location.kind).indexOf(location);
  const parts = location.kind === "track" ? plant.tracks[rank].parts : plant.places[rank];
  if (parts.length === 0) throw new Error("`" + location.name + "` has no part");
  parts.shift();
  plant.changed[location.kind + "s"].add(rank);
};

const changeAlarms = (plant, names, change) => {
  const list = [names].flat();
  for (const name of list) if (!plant.alarms.some((alarm) => alarm.name === name)) throw new Error("alarm `" + name + "` is not in the list");
  plant.alarms = plant.alarms.map((alarm) => list.includes(alarm.name) ? change(alarm) : alarm);
  plant.changed.keys.add("alarms");
};

const setClock = (plant, change) => {
  plant.clock = {...plant.clock, ...change};
  plant.changed.keys.add("clock");
};

export class MockExercise {
  /// `file` is a scenario with `exercise` and steps `state` or `wait`, as examples/body-shop/no-air.json.
  constructor(name, file) {
    Object.assign(this, {name, file, step: 0, steps: file.steps.map(({text = ""}) => ({text, state: "pending", t: null})), points: [], state: "running", took: null});
  }

  advance(plant) {
    const before = this.step;
    while (this.step < this.file.steps.length) {
      const {state, wait} = this.file.steps[this.step];
      if (state) for (const [device, to] of Object.entries(state)) act(plant, {state: {[device]: to}});
      if (wait) {
        const [name, to] = wait.split(".");
        const index = indexOf(plant.description.devices, name, "device");
        const {states} = plant.description.devices[index];
        if (plant.devices[index].state !== states.indexOf(to) || plant.devices[index].target !== plant.devices[index].state) break;
        this.points.push({t: plant.t, points: this.file.exercise.score.expect, text: "expect"});
      }
      Object.assign(this.steps[this.step++], {state: "done", t: plant.t});
    }
    if (this.step < this.steps.length) this.steps[this.step].state = "active";
    else if (this.state === "running") {
      Object.assign(this, {state: "over", took: plant.t});
      this.points.push({t: plant.t, points: this.file.exercise.score.within.points, text: "within the time"});
    }
    if (before !== this.step) plant.changed.keys.add("exercise");
  }

  view() {
    const {title, text, score} = this.file.exercise;
    return {name: this.name, title, text, state: this.state, step: this.step, steps: this.steps, score: this.points.reduce((sum, {points}) => sum + points, 0),
      most: score.expect * this.file.steps.filter(({wait}) => wait).length + score.within.points, points: this.points, since: 0, took: this.took};
  }
}

const acts = {
  set: (plant, values) => setSymbols(plant, values, "plain"),
  force: (plant, values) => setSymbols(plant, values, "forced"),
  release,
  state: (plant, states) => {
    for (const [name, state] of Object.entries(states)) {
      const index = indexOf(plant.description.devices, name, "device");
      const to = plant.description.devices[index].states.indexOf(state);
      if (to < 0) throw new Error("`" + name + "` has no state `" + state + "`");
      plant.setState(index, to);
    }
  },
  put: (plant, parts) => [parts].flat().forEach((part) => put(plant, part)),
  take: (plant, places) => [places].flat().forEach((place) => take(plant, place)),
  start: (plant, names) => [names].flat().forEach((name) => setMalfunction(plant, name, true)),
  stop: (plant, names) => [names].flat().forEach((name) => setMalfunction(plant, name, false)),
  run: (plant) => setClock(plant, {state: "running"}),
  freeze: (plant) => setClock(plant, {state: "frozen"}),
  step: (plant) => {
    setClock(plant, {state: "running"});
    plant.advance(1e7);
    setClock(plant, {state: "frozen"});
  },
  speed: (plant, speed) => setClock(plant, {speed, real_speed: speed === "max" ? 500 : speed}),
  reset: (plant) => {
    plant.begin();
    jump(plant);
  },
  snapshot: (plant, name) => {
    if (!/^[\w -][\w .-]{0,63}$/.test(name)) throw new Error("a name has 1 to 64 letters, digits, blanks, `_`, `-` and `.`");
    plant.snapshots = [...plant.snapshots.filter((entry) => entry.name !== name), {name, t: plant.t, kind: "snapshot", file: false, state: copy(plant)}];
    plant.changed.keys.add("snapshots");
  },
  save: (plant, name) => {
    plant.snapshots.find((entry) => entry.name === name).file = true;
    plant.changed.keys.add("snapshots");
  },
  restore,
  forget: (plant, name) => {
    plant.snapshots = plant.snapshots.filter((entry) => entry.name !== name);
    plant.changed.keys.add("snapshots");
  },
  exercise: (plant, name) => {
    const file = plant.exercises.find((entry) => entry.name === name);
    if (!file) throw new Error("`" + name + "` is not an exercise");
    plant.begin();
    jump(plant);
    plant.exercise = new MockExercise(name, file.file);
    plant.changed.keys.add("exercise");
  },
  end: (plant) => {
    plant.exercise = null;
    plant.changed.keys.add("exercise");
  },
  session: () => {},
  count: () => {},
  acknowledge: (plant, names) => {
    changeAlarms(plant, names === "all" ? plant.alarms.map(({name}) => name) : names, (alarm) => ({...alarm, state: "acknowledged"}));
    plant.alarms = plant.alarms.filter(({state, on}) => state !== "acknowledged" || on);
  },
  shelve: (plant, names) => changeAlarms(plant, names, (alarm) => ({...alarm, state: "shelved", until: plant.t + 6e11})),
  unshelve: (plant, names) => changeAlarms(plant, names, (alarm) => ({...alarm, state: "active", until: null})),
  silence: () => {},
};

/// Throws what is wrong; then nothing was done.
export const act = (plant, of) => {
  const key = kKinds.find((kind) => kind in of);
  if (!key) throw new Error("`" + Object.keys(of)[0] + "` is not an act");
  acts[key](plant, of[key]);
  const entry = {n: plant.acts.length, t: plant.t, by: "hand", act: of};
  plant.acts.push(entry);
  plant.changed.acts.push(entry);
};

const tree = (sentence, about, because = []) => ({sentence, about: about ? [about] : [], because});

export const why = (plant, name) => {
  const {devices, symbols} = plant.description;
  const answer = (sentence, about, because) => ({text: sentence, trees: [tree(sentence, about, because)]});
  const seconds = (t) => t / 1e9 + " s";
  const index = devices.findIndex((device) => device.name === name);
  if (index < 0) {
    const symbol = symbols.findIndex((entry) => entry.name === name);
    if (symbol < 0) return answer(name + " is as it is", null, []);
    const value = plant.value(symbol);
    const text = name + " is " + (value === true ? "on" : value === false ? "off" : value) + " since " + seconds(plant.symbols[symbol].since);
    const {device} = symbols[symbol];
    return answer(text, {symbol: name}, device === null ? [] : [tree("it is an event of " + devices[device].name, {device: devices[device].name})]);
  }
  const {operations, states} = devices[index];
  const device = plant.devices[index];
  const commands = operations.filter(({symbol}) => plant.value(symbol) === true);
  const because = commands.map(({symbol}) => tree(symbols[symbol].name + " is on since " + seconds(plant.symbols[symbol].since), {symbol: symbols[symbol].name}));
  const by = plant.disabledBy(index);
  if (by !== null) {
    const other = devices[by];
    because.push(tree(other.name + " is in " + other.states[plant.devices[by].state] + " and disables it", {device: other.name},
      other.events.map((symbol) => tree(symbols[symbol].name + " is off", {symbol: symbols[symbol].name}))));
  }
  for (const [active] of plant.malfunctions) if (plant.malfunctionOf(active)?.device === index) because.push(tree("the malfunction " + active + " acts on it", null));
  const text = device.blocked ? name + " waits in " + states[device.state] + ": " + because.map((cause) => cause.sentence).join(", but ")
    : device.target !== device.state ? name + " moves to " + states[device.target] : name + " is in " + (states[device.state] ?? "no state") + " since " + seconds(device.since);
  return answer(text, {device: name}, because);
};
