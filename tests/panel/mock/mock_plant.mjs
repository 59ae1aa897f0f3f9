// A plant for the mock server: simple enough to be read, true enough for a page. It is no model of the engine.

const kTick = 40e6;
const kMove = 600e6;
const [kMoving, , kDisabled, , kBroken] = [1, 2, 4, 8, 16];

export class MockPlant {
  /// `activity`: motions per second that it starts by itself. `blocked(plant, device)`: why a device with a command does not move.
  constructor(description, {activity = 0, move = kMove, partsPerTrack = 0, exercises = []} = {}) {
    Object.assign(this, {description, activity, move, exercises, snapshots: [], listeners: new Set(), acts: [], findings: [], exercise: null, next: 0, log: []});
    this.clock = {state: "running", speed: 1, real_speed: 1, until: null};
    this.partsPerTrack = partsPerTrack;
    this.stations = description.stations.map(() => []);
    description.devices.forEach(({station}, index) => { if (station !== null) this.stations[station].push(index); });
    this.begin();
  }

  begin() {
    const {devices, symbols, locations, requirements} = this.description;
    this.t = 0;
    this.rev = (this.rev ?? 0) + 1;
    this.devices = devices.map((device) => {
      const initial = device.events.map((symbol) => symbols[symbol]).find(({type, initial}) => type === "BOOL" && initial === "TRUE");
      const state = initial ? Math.max(0, device.states.indexOf(initial.name.split("_").pop())) : 0;
      return {state, target: state, flags: 0, blocked: 0, since: 0, end: 0, whole: 0, left: 0};
    });
    this.symbols = symbols.map(({type, initial}) => ({plain: type === "BOOL" ? initial === "TRUE" : Number(initial), forced: undefined, broken: undefined, since: 0}));
    this.malfunctions = [];
    this.alarms = [];
    this.requirements = requirements.map(() => ["ok", 0, 0]);
    this.tracks = locations.filter(({kind}) => kind === "track").map((track, rank) => ({t: 0, stops: [false], drives: [0.5e6, 0.5e6],
      parts: Array.from({length: this.partsPerTrack}, (_, i) => [rank * 100 + i + 1, (rank + i) % this.description.part_kinds.length, Math.round(track.length * (.95 - i / this.partsPerTrack * .9)), 0.5e6])}));
    this.places = locations.filter(({kind}) => kind === "place").map(({holds}, rank) => Array.from({length: Math.floor(holds / 2)}, (_, i) => [9000 + rank * 100 + i, i % this.description.part_kinds.length]));
    this.moving = new Set();
    this.clean();
  }

  clean() {
    this.changed = {devices: new Set(), symbols: new Set(), tracks: new Set(), places: new Set(), requirements: new Set(), keys: new Set(), findings: [], acts: []};
  }

  value(index) {
    const {plain, forced, broken} = this.symbols[index];
    return forced ?? broken ?? plain;
  }

  set(index, change) {
    const before = this.value(index);
    Object.assign(this.symbols[index], change);
    this.changed.symbols.add(index);
    if (this.value(index) === before) return;
    this.symbols[index].since = this.t;
    this.note("s", index, [this.t, this.value(index)]);
    const {device} = this.description.symbols[index];
    if (device !== null) this.step(device);
  }

  note(kind, index, entry) {
    this.log.push([this.next++, kind + index, entry]);
    if (this.log.length > 200000) this.log.splice(0, 50000);
  }

  touch(index, change) {
    Object.assign(this.devices[index], change);
    this.changed.devices.add(index);
  }

  disabledBy(index) {
    const device = this.description.devices[index];
    if (device.operations.length === 0 || device.station === null) return null;
    const isAir = /CLAMP|PIN|LATCH|GRIPPER/.test(device.label);
    for (const other of this.stations[device.station]) {
      const {label, states} = this.description.devices[other];
      const guards = isAir ? /^AIR$/ : /^(DOOR\d|ESTOP\d|CURTAIN|GUARD)$/;
      if (guards.test(label) && states[this.devices[other].state]?.startsWith("NOT_")) return other;
    }
    return null;
  }

  /// After a change of a command or of what disables the device.
  step(index) {
    const description = this.description.devices[index];
    const device = this.devices[index];
    if (description.operations.length === 0) return;
    const wanted = description.operations.find(({symbol, to}) => to !== null && this.value(symbol) === true)?.to
      ?? (description.actuation === "spring" ? description.rest : device.target);
    const isStuck = this.malfunctions.some(([name]) => this.malfunctionOf(name)?.device === index && !/slow|sluggish/.test(name));
    const disabled = this.disabledBy(index) !== null;
    const flags = (disabled ? kDisabled : 0) | (this.malfunctions.some(([name]) => this.malfunctionOf(name)?.device === index) ? kBroken : 0);
    if (disabled || isStuck) {
      const left = this.moving.has(index) ? Math.max(0, device.end - this.t) : device.left;
      this.moving.delete(index);
      return this.touch(index, {flags: flags | (device.target !== device.state ? kMoving : 0), left, blocked: Number(wanted !== device.state)});
    }
    if (wanted === device.target && (wanted === device.state || this.moving.has(index))) return this.touch(index, {flags: flags | (this.moving.has(index) ? kMoving : 0), blocked: 0});
    const slow = this.malfunctions.some(([name]) => this.malfunctionOf(name)?.device === index) ? 3 : 1;
    if (wanted === device.state && device.target !== device.state) return this.arrive(index, wanted);
    const whole = this.move * slow;
    this.moving.add(index);
    this.switchEvents(index, -1);
    this.touch(index, {target: wanted, flags: flags | kMoving, blocked: 0, since: this.t, whole, end: this.t + whole, left: whole});
    this.note("d", index, [this.t, device.state, wanted]);
  }

  arrive(index, state) {
    this.moving.delete(index);
    this.touch(index, {state, target: state, flags: this.devices[index].flags & ~kMoving, since: this.t, left: 0, whole: 0, blocked: 0});
    this.note("d", index, [this.t, state, state]);
    this.switchEvents(index, state);
  }

  switchEvents(index, state) {
    const {events, states} = this.description.devices[index];
    for (const symbol of events) {
      const {type, name, driver} = this.description.symbols[symbol];
      if (type === "BOOL" && driver !== "parts") this.set(symbol, {plain: states[state] === name.split("_").pop()});
    }
  }

  setState(index, state) {
    this.arrive(index, state);
    const {station} = this.description.devices[index];
    if (station !== null) for (const other of this.stations[station]) if (other !== index) this.step(other);
  }

  /// { device } or { symbol, value } of a malfunction's name.
  malfunctionOf(name) {
    const described = this.description.malfunctions.find((malfunction) => malfunction.name === name);
    if (described) return {device: described.devices[0]};
    const [, of, kind] = /^(.*) (stuck on|stuck off|stuck|slow)$/.exec(name) ?? [];
    const device = this.description.devices.findIndex((entry) => entry.name === of);
    if (device >= 0) return {device};
    const symbol = this.description.symbols.findIndex((entry) => entry.name === of);
    return symbol >= 0 ? {symbol, value: kind === "stuck on"} : null;
  }

  finding(kind, of, text, severity = "warning") {
    const finding = {n: (this.found = (this.found ?? -1) + 1), t: this.t, finding: kind, of, severity, text};
    this.findings.push(finding);
    if (this.findings.length > 200) this.findings.shift();
    this.changed.findings.push(finding);
  }

  advance(wall = kTick) {
    if (this.clock.state !== "running") return;
    this.t += Math.round(wall * this.clock.real_speed);
    for (const index of this.moving) if (this.devices[index].end <= this.t) this.arrive(index, this.devices[index].target);
    this.carryOn(wall / 1e9);
    this.carryParts();
    this.exercise?.advance(this);
  }

  /// Commands by itself, as a PLC would.
  carryOn(seconds) {
    this.due = (this.due ?? 0) + this.activity * seconds;
    const {devices} = this.description;
    for (let tries = this.due * 3; this.due >= 1 && tries > 0; --tries) {
      const index = Math.floor(Math.random() * devices.length);
      const {operations} = devices[index];
      if (operations.length === 0 || this.moving.has(index)) continue;
      this.due -= 1;
      const others = operations.filter(({to}) => to !== this.devices[index].state);
      const next = others[Math.floor(Math.random() * others.length)] ?? operations[0];
      for (const {symbol} of operations) {
        if (this.description.symbols[symbol].type !== "BOOL") continue;
        const on = symbol === next.symbol && !(operations.length === 1 && this.value(symbol));
        if (this.symbols[symbol].plain !== on) this.set(symbol, {plain: on});
      }
      if (Math.random() < .002) this.finding("lost command", devices[index].name, "the command of " + devices[index].name + " was on for 2 ms and had no effect, since it already moves");
    }
    this.due = Math.min(this.due, 1000);
  }

  carryParts() {
    const tracks = this.description.locations.filter(({kind}) => kind === "track");
    tracks.forEach(({length, sensors, stops}, rank) => {
      const track = this.tracks[rank];
      const passed = (this.t - track.t) / 1e9;
      const at = ([, , x, v]) => x + v * passed;
      const holds = Math.floor(this.t / 3e9 + rank) % 3 === 0;
      const parts = track.parts.map((part) => [part[0], part[1], Math.round(at(part)), 0]);
      for (const part of parts) if (part[2] >= length) part[2] = this.description.part_kinds[part[1]].length;
      parts.sort((a, b) => b[2] - a[2]);
      let limit = Infinity;
      for (const part of parts) {
        const stopped = holds && part[2] <= stops[0].at && stops[0].at - part[2] < 3e4;
        part[3] = stopped || limit - part[2] < 3e4 ? 0 : 0.5e6;
        limit = part[2] - this.description.part_kinds[part[1]].length - 2e4;
      }
      const speeds = (list) => list.map((part) => part[0] + ":" + part[3]).join();
      const wrapped = parts.some((part, i) => part[0] !== track.parts[i][0]);
      if (wrapped || speeds(parts) !== speeds(track.parts) || holds !== track.stops[0]) {
        Object.assign(track, {t: this.t, parts, stops: [holds]});
        this.changed.tracks.add(rank);
      }
      for (const {symbol, at: where} of sensors) {
        const on = parts.some((part) => part[2] >= where && part[2] - this.description.part_kinds[part[1]].length <= where);
        if (this.symbols[symbol].plain !== on) this.set(symbol, {plain: on});
      }
    });
  }

  entry(index) {
    const {state, target, flags, blocked, since, end, whole, left} = this.devices[index];
    return [state, target, flags, blocked, since, this.moving.has(index) ? Math.max(0, end - this.t) : left, whole];
  }
  symbolEntry(index) {
    const {forced, broken, since} = this.symbols[index];
    return [this.value(index), (forced !== undefined ? 1 : 0) | (broken !== undefined ? 2 : 0), since];
  }
  trackEntry(rank) {
    const {t, parts, stops, drives} = this.tracks[rank];
    return [t, parts, stops, drives];
  }
  linkStates() {
    return this.description.links.map(() => ({state: "connected", requests: Math.floor(this.t / 2e7), rate: 50, last: 0.02, losses: 0}));
  }
  cycle() {
    if (this.description.links.length === 0) return null;
    const cycles = Math.floor(this.t / 1e6);
    return {cycles, overruns: 2, slipped: 0, late: {p50: 4200, p99: 21000, p999: 48000, max: 310000}, work: {p50: 61000, p99: 93000, p999: 120000, max: 402000},
      histogram: [[1000, 0], [2000, cycles / 9 | 0], [5000, cycles / 2 | 0], [10000, cycles / 4 | 0], [50000, cycles / 12 | 0], [100000, 0], [500000, 2], [1000000, 0]]};
  }

  /// The key `alarms`, whole. The horn of the mock is on while an alarm of high priority waits.
  alarmList() {
    return {all: true, horn: this.alarms.some(({priority, state}) => priority === "high" && ["active", "gone"].includes(state)), dropped: 0, list: this.alarms, left: []};
  }

  picture() {
    return {layout: 1, camera: null, alarms: this.alarmList(), rev: this.rev, t: this.t, clock: this.clock, devices: this.devices.map((_, index) => this.entry(index)), symbols: this.symbols.map((_, index) => this.symbolEntry(index)),
      tracks: this.tracks.map((_, rank) => this.trackEntry(rank)), places: this.places, malfunctions: this.malfunctions, findings: this.findings,
      requirements: this.requirements, links: this.linkStates(), cycle: this.cycle(), acts: this.acts.slice(-200),
      snapshots: this.snapshots.map(({name, t, kind, file}) => ({name, t, kind, file})), exercise: this.exercise?.view(this) ?? null};
  }

  /// What changed since the last call, or null.
  changes(second) {
    const {devices, symbols, tracks, places, requirements, keys, findings, acts} = this.changed;
    const event = {rev: ++this.rev, t: this.t};
    if (devices.size > 0) event.devices = [...devices].map((index) => [index, ...this.entry(index)]);
    if (symbols.size > 0) event.symbols = [...symbols].map((index) => [index, ...this.symbolEntry(index)]);
    if (tracks.size > 0) event.tracks = [...tracks].map((rank) => [rank, ...this.trackEntry(rank)]);
    if (places.size > 0) event.places = [...places].map((rank) => [rank, this.places[rank]]);
    if (requirements.size > 0) event.requirements = [...requirements].map((index) => [index, ...this.requirements[index]]);
    if (findings.length > 0) event.findings = findings;
    if (acts.length > 0) event.acts = acts;
    const all = {alarms: this.alarmList(), clock: this.clock, malfunctions: this.malfunctions, exercise: this.exercise?.view(this) ?? null,
      snapshots: this.snapshots.map(({name, t, kind, file}) => ({name, t, kind, file}))};
    for (const key of keys) if (key in all) event[key] = all[key];
    if (second) Object.assign(event, {links: this.linkStates(), cycle: this.cycle()});
    const any = Object.keys(event).length > 2;
    this.clean();
    return any ? event : null;
  }
}
