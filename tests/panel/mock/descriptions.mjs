// Descriptions of plants for the mock server, in the form of GET /api/v1/plant: from a symbol list, and invented large ones.
import {readFileSync} from "node:fs";

const emptyPlant = (name) => ({"symplant-panel": 1, version: "mock", role: "trainer", run: "", plant: name, model_hash: "0123456789abcdef", mode: "live", acts: true,
  with_plc: false, end: 0, files: true, stations: [], devices: [], symbols: [], locations: [], transfers: [], part_kinds: [], requirements: [],
  malfunctions: [], ordinary: {device: ["stuck", "slow"], event: ["stuck on", "stuck off"]}, exercises: [], programs: [], links: []});

const stationOf = (plant, line, process) => {
  const name = line + " " + process;
  const found = plant.stations.findIndex((station) => station.name === name);
  return found >= 0 ? found : plant.stations.push({name, line, process}) - 1;
};

/// Adds a symbol LINE_PROCESS_DEVICE_DIRECTION_TASK to its device.
const addSymbol = (plant, devices, name, address, type, initial, list) => {
  const [line, process, label, direction, task] = name.split("_");
  const key = [line, process, label].join("_");
  if (!devices.has(key)) {
    devices.set(key, plant.devices.push({name: key, label, station: stationOf(plant, line, process), states: [], rest: null, actuation: "latched", operations: [],
      events: []}) - 1);
  }
  const index = devices.get(key);
  const device = plant.devices[index];
  const isEvent = direction === "I";
  const symbol = plant.symbols.push({name, address, type, direction: isEvent ? "event" : "operation", device: index, driver: isEvent ? "none" : null,
    link: null, list, inverted: false, initial}) - 1;
  if (isEvent) device.events.push(symbol);
  else device.operations.push({symbol, to: null});
  if (type === "BOOL" && !device.states.includes(task)) device.states.push(task);
};

/// States, targets of operations and drivers of events, once all symbols are known.
const finish = (plant) => {
  for (const device of plant.devices) {
    device.shape = "device";
    if (device.states.length === 1) device.states.unshift("NOT_" + device.states[0]);
    for (const operation of device.operations) {
      const to = device.states.indexOf(plant.symbols[operation.symbol].name.split("_").pop());
      operation.to = to >= 0 ? to : null;
    }
    for (const symbol of device.events) {
      if (device.operations.length > 0 && plant.symbols[symbol].type === "BOOL") plant.symbols[symbol].driver = "device";
    }
  }
  return plant;
};

export const bodyShop = (project) => {
  const plant = emptyPlant("body-shop");
  const devices = new Map();
  readFileSync(project + "/examples/body-shop/body-shop.csv", "utf8").trim().split("\n").forEach((row, i) => {
    const [, name, mit, iec, type, initial] = row.split(",");
    if (i > 0) addSymbol(plant, devices, name, mit || iec, type, initial, "body-shop.csv:" + (i + 1));
  });
  finish(plant);
  plant.requirements = plant.stations.slice(0, 10).flatMap(({process}) => [
    {name: process + ": robot 1 works only in closed clamps", kind: "never"}, {name: process + ": clamps close on raised pins", kind: "never"}]);
  plant.malfunctions = [{name: "clamp 1 sluggish", kind: "slower", devices: [plant.devices.findIndex(({name}) => name === "BODY_UNDER10_CLAMP1")], symbols: []},
    {name: "air hose burst", kind: "stuck", devices: [plant.devices.findIndex(({name}) => name === "BODY_UNDER10_AIR")], symbols: []}];
  addTracks(plant, ["UNDER", "SIDE", "FRAMING", "ROOF"].map((name) => "SHUTTLE_" + name), 36e6, 4.5e6, "BODY_UNDER10_PART1_I_SEEN");
  return plant;
};

/// Tracks of one length with sensors, a stop and an end each; the first sensor of the first track is an existing symbol.
const addTracks = (plant, names, length, partLength, existing) => {
  if (plant.part_kinds.length === 0) plant.part_kinds = [{name: "floor", length: partLength}, {name: "body", length: partLength * 1.1}];
  names.forEach((name, rank) => {
    const sensors = [.1, .35, .6, .85].map((part, i) => {
      const known = rank + i === 0 && existing ? plant.symbols.findIndex((symbol) => symbol.name === existing) : -1;
      const symbol = known >= 0 ? known : plant.symbols.push({name: name + "_PE" + (i + 1) + "_I_PART", address: "%IX" + (9000 + 8 * rank + i), type: "BOOL", direction: "event",
        device: null, driver: "parts", link: null, list: "tracks.csv:" + (4 * rank + i + 2), inverted: false, initial: "FALSE"}) - 1;
      plant.symbols[symbol].driver = "parts";
      return {symbol, at: Math.round(length * part)};
    });
    plant.locations.push({name, kind: "track", length, drives: [{from: 0, until: Math.round(length / 2)}, {from: Math.round(length / 2), until: length}],
      stops: [{at: Math.round(length * .8)}], sensors, ends: [{to: null}]});
  });
};

export const material = (tracks = 25) => {
  const plant = emptyPlant("material");
  const devices = new Map();
  plant.part_kinds = [{name: "box", length: 300000}, {name: "tall box", length: 400000}, {name: "tray", length: 600000}];
  for (let i = 0; i < tracks; ++i) {
    const station = "CONV_S" + String(i).padStart(2, "0");
    for (const device of ["CV1", "STP1", "PSH1"]) {
      for (const [direction, task] of [["O", "RUN"], ["I", "RUN"]]) {
        addSymbol(plant, devices, station + "_" + device + "_" + direction + "_" + task, "%" + (direction === "I" ? "I" : "Q") + "X" + plant.symbols.length, "BOOL", "FALSE", "material.csv:" + plant.symbols.length);
      }
    }
  }
  finish(plant);
  addTracks(plant, [...Array(tracks).keys()].map((i) => "CONV_S" + String(i).padStart(2, "0") + "_BELT"), 8e6, 300000, null);
  for (const [name, holds] of [["FIXTURE", 1], ["BUFFER", 6], ["MAGAZINE", 40]]) plant.locations.push({name, kind: "place", holds, sensors: []});
  plant.transfers = [{name: "pick", from: {location: 0, at: 7800000}, to: {location: tracks}}, {name: "store", from: {location: tracks}, to: {location: tracks + 2}},
    {name: "put back", from: {location: tracks + 1}, to: {location: 1, at: 2000000}}];
  return plant;
};

/// `count` devices with two operations and two events each, 30 to a station; symbols up to `symbols`, if it is given.
export const large = (count, symbols = 0, tracks = 0) => {
  const plant = emptyPlant("large");
  const devices = new Map();
  for (let i = 0; i < count; ++i) {
    const name = "LINE" + (1 + Math.floor(i / 900)) + "_ST" + String(Math.floor(i / 30)).padStart(3, "0") + "_CYL" + i % 30;
    for (const [direction, task] of [["O", "ADV"], ["O", "RET"], ["I", "RET"], ["I", "ADV"]]) {
      if (symbols && plant.symbols.length >= symbols - 4 * tracks) break;
      addSymbol(plant, devices, name + "_" + direction + "_" + task, (direction === "I" ? "X" : "Y") + plant.symbols.length.toString(16).toUpperCase().padStart(4, "0"), "BOOL",
        direction + task === "IRET" ? "TRUE" : "FALSE", "large.csv:" + plant.symbols.length);
    }
  }
  finish(plant);
  if (tracks > 0) addTracks(plant, [...Array(tracks).keys()].map((i) => "BELT" + i), 8e6, 300000, null);
  plant.links = [{name: "modbus-tcp-server://127.0.0.1:1502", controller: "PLC1"}];
  return plant;
};

const kShapes = ["cylinder", "clamp", "gripper", "robot", "motor", "conveyor", "turntable", "lift", "valve", "tank", "pump", "door", "machine", "vehicle", "sensor", "lamp", "button",
  "selector", "device"];

/// The same plant with devices of all shapes.
export const shaped = (plant) => {
  plant.devices.forEach((device, i) => { device.shape = kShapes[i % kShapes.length]; });
  return plant;
};

/// A small cell with a spring, a numeric symbol, positions from plant.json and a link.
export const cell = () => {
  const plant = emptyPlant("cell");
  const devices = new Map();
  const rows = ["EXLINE_MB_AGV_I_P1 TRUE", "EXLINE_MB_AGV_I_P2", "EXLINE_MB_AGV_O_P2", "EXLINE_MB_AGV_O_P1", "EXLINE_MB_DOOR_I_OPEN1 TRUE", "EXLINE_MB_DOOR_I_SHUT2",
    "EXLINE_MB_DOOR_O_OPEN1", "EXLINE_MB_DOOR_O_SHUT2", "EXLINE_MC_SPINDLE_O_RUN", "EXLINE_MC_SPINDLE_I_RUN", "EXLINE_MC_GUARD_I_SHUT TRUE"];
  rows.forEach((row, i) => {
    const [name, initial = "FALSE"] = row.split(" ");
    addSymbol(plant, devices, name, (name.includes("_I_") ? "%IX" : "%QX") + i, "BOOL", initial, "cell.csv:" + (i + 2));
  });
  addSymbol(plant, devices, "EXLINE_MC_SPINDLE_O_SPEED", "%QW4", "INT", "0", "cell.csv:20");
  addSymbol(plant, devices, "EXLINE_MC_SPINDLE_I_LOAD", "%IW4", "REAL", "0", "cell.csv:21");
  finish(plant);
  plant.devices[0].view = {x: 0, y: 0};
  plant.devices[1].view = {x: 1.5, y: .5};
  plant.devices[2].actuation = "spring";
  plant.devices[2].rest = 0;
  plant.symbols.forEach((symbol) => { symbol.link = symbol.device === 3 ? null : 0; });
  plant.links = [{name: "modbus-tcp-server://127.0.0.1:1502", controller: "PLC1"}];
  return plant;
};

/// What a person operates: contacts, buttons in no device, a motor with a set point, a pump that a PLC writes, comments, inverted
/// symbols, sensors at one position.
export const operated = () => {
  const plant = emptyPlant("operated");
  const devices = new Map();
  const add = (name, comment, more = {}, type = "BOOL", initial = "FALSE") => {
    const index = plant.symbols.length;
    addSymbol(plant, devices, "LINE_S1_" + name, (name.includes("_I_") ? "X" : "Y") + index.toString(16).padStart(4, "0"), type, initial, "operated.csv:" + (index + 2));
    Object.assign(plant.symbols[index], comment ? {comment} : {}, more);
    return index;
  };
  add("CLAMP1_O_CLOSE", "Clamp 1 left side, close", {inverted: true}, "BOOL", "TRUE");
  add("CLAMP1_O_OPEN", "Clamp 1 left side, open");
  add("CLAMP1_I_CLOSE", "Clamp 1 left side, is closed");
  add("CLAMP1_I_OPEN", "Clamp 1 left side, is open", {}, "BOOL", "TRUE");
  add("MOTOR_O_RUN", "Spindle motor");
  add("MOTOR_I_RUN", "Spindle motor runs");
  add("PUMP_O_RUN", "Kühlmittelpumpe", {link: 0});
  add("PUMP_I_RUN", null, {link: 0});
  add("DOOR_I_SHUT", "Safety door is shut", {}, "BOOL", "TRUE");
  add("START_I_PUSH", "Push button start cycle");
  add("ESTOP_I_SAFE", "비상정지 해제됨", {}, "BOOL", "TRUE");
  add("MODE_I_OFF", "Selector off", {}, "BOOL", "TRUE");
  add("MODE_I_MANUAL", "Selector manual");
  add("MODE_I_AUTO", "Selector automatic");
  finish(plant);
  const loose = (name, comment, more = {}, type = "BOOL") => plant.symbols.push({name: "LINE_S1_" + name, address: "D" + plant.symbols.length, type,
    direction: name.includes("_I_") ? "event" : "operation", device: null, driver: name.includes("_I_") ? "none" : null, link: null, list: "operated.csv:" + plant.symbols.length, inverted: false,
    initial: type === "BOOL" ? "FALSE" : "0", ...(comment ? {comment} : {}), ...more}) - 1;
  loose("MOTOR_O_SPEED", "Spindle speed in 1/min", {}, "INT");
  loose("MOTOR_I_LOAD", "Spindle load", {driver: "signal"}, "REAL");
  loose("PB_I_START", "Start", {operator: true});
  loose("PB_I_RESET_FAULTS_OF_THE_WHOLE_STATION", null, {operator: true});
  loose("PB_I_STOP", "Stop (opener)", {operator: true, inverted: true});
  loose("PL_O_READY", "Lamp ready", {operator: true});
  addTracks(plant, ["LINE_S1_BELT"], 3e6, 300000, null);
  const {sensors} = plant.locations[0];
  for (const [name, at] of [["PE2_I_LOW", sensors[1].at], ["PE2_I_HIGH", sensors[1].at], ["PE3_I_SKEW", sensors[2].at]]) {
    sensors.push({symbol: loose("BELT_" + name, "Eye " + name.slice(6).toLowerCase(), {driver: "parts"}), at});
  }
  plant.links = [{name: "modbus-tcp-server://127.0.0.1:1502", controller: "PLC1"}];
  return plant;
};

/// Names that break pages: markup, Korean, very long ones.
export const names = () => {
  const plant = emptyPlant("이름 <b>시험</b> \"quotes\" & more, a plant with a very long name that does not end soon");
  const devices = new Map();
  const labels = ["<img src=x onerror=alert(1)>", "용접로봇클램프전진실린더이름이아주긴장치", "</script><script>alert(1)</script>", "VERYLONGDEVICENAMEWITHOUTANYBREAKTHATGOESONANDONANDON", "클램프"];
  labels.forEach((label, i) => {
    for (const [direction, task] of [["O", "전진"], ["I", "전진"], ["O", "후진되어있는아주긴상태이름"], ["I", "후진되어있는아주긴상태이름"]]) {
      addSymbol(plant, devices, "차체라인_용접공정" + i % 2 + "_" + label + "_" + direction + "_" + task, "X" + i, "BOOL", "FALSE", "이름.csv:" + i);
    }
  });
  finish(plant);
  plant.part_kinds = [{name: "차체 <b>", length: 900000}];
  addTracks(plant, ["이송 <i>컨베이어</i> 라인"], 6e6, 900000, null);
  plant.requirements = [{name: "로봇은 클램프가 닫힌 상태에서만 <u>작업</u>한다", kind: "never"}];
  plant.malfunctions = [{name: "클램프 <b>고착</b>", kind: "stuck", devices: [0], symbols: []}];
  plant.exercises = [{name: "연습", title: "클램프를 <b>닫기</b>", text: "두 줄\n<script>", steps: 1}];
  return plant;
};
