// A small plant for the tests of the page's modules: two devices, four symbols, a track and a place.
export const smallPlant = () => ({
  plant: "small", mode: "live", acts: true, with_plc: false, end: 0, files: true,
  stations: [{name: "LINE S1", line: "LINE", process: "S1"}],
  devices: [
    {name: "LINE_S1_CLAMP", label: "CLAMP", station: 0, states: ["OPEN", "CLOSE"], rest: null, actuation: "latched",
      operations: [{symbol: 0, to: 1}], events: [1]},
    {name: "LINE_S1_DOOR", label: "DOOR", station: 0, states: ["NOT_SHUT", "SHUT"], rest: null, actuation: "latched", operations: [], events: [2]},
  ],
  symbols: [
    {name: "LINE_S1_CLAMP_O_CLOSE", address: "Y0", type: "BOOL", direction: "operation", device: 0, driver: null, link: null, list: "a.csv:2", inverted: false},
    {name: "LINE_S1_CLAMP_I_CLOSE", address: "X0", type: "BOOL", direction: "event", device: 0, driver: "device", link: 0, list: "a.csv:3", inverted: false},
    {name: "LINE_S1_DOOR_I_SHUT", address: "X1", type: "BOOL", direction: "event", device: 1, driver: "none", link: 0, list: "a.csv:4", inverted: false},
    {name: "LINE_S1_PE_I_PART", address: "X2", type: "BOOL", direction: "event", device: null, driver: "parts", link: 0, list: "a.csv:5", inverted: false},
  ],
  locations: [
    {name: "BELT", kind: "track", length: 3000000, drives: [{from: 0, until: 3000000}], stops: [{at: 2000000}], sensors: [{symbol: 3, at: 300000}], ends: [{to: 1}]},
    {name: "FIXTURE", kind: "place", holds: 2, sensors: []},
  ],
  transfers: [], part_kinds: [{name: "raw", length: 200000}], requirements: [{name: "never both", kind: "never"}], malfunctions: [],
  ordinary: {device: ["stuck"], event: ["stuck on"]}, exercises: [], programs: [], links: [{name: "modbus-tcp-server://127.0.0.1:1502", controller: "PLC1"}],
});

export const smallPicture = () => ({
  rev: 1, t: 0, clock: {state: "running", speed: 1, real_speed: 1, until: null},
  devices: [[0, 0, 0, 0, 0, 0, 0], [1, 1, 0, 0, 0, 0, 0]],
  symbols: [[false, 0, 0], [false, 0, 0], [true, 0, 0], [false, 0, 0]],
  tracks: [[0, [[1, 0, 500000, 400000]], [false], [400000]]], places: [[[2, 0]]],
  malfunctions: [], findings: [], requirements: [["ok", 0, 0]], links: [], cycle: null, acts: [], snapshots: [], exercise: null,
});

/// The same plant with three values; two of them belong to the clamp.
export const plantWithValues = () => ({...smallPlant(), values: [
  {name: "wind", unit: "m/s", kind: "parameter", min: 0, max: 30, settable: true, formulas: [], device: null, trace: 1e8},
  {name: "LINE_S1_CLAMP.load", unit: "l", kind: "integral", min: 0, max: 120, settable: true, formulas: ["wind"], device: 0, trace: 1e8},
  {name: "LINE_S1_CLAMP.double", unit: "", kind: "is", min: null, max: null, settable: false, formulas: ["2 * LINE_S1_CLAMP.load"], device: 0, trace: null},
]});

export const pictureWithValues = () => ({...smallPicture(), values: [[4, 0], [20, 0], [40, 0]]});
