// Where things are in the line view. Pure functions, without elements.

const kNameGap = 8;  // between two names of sensors
const kHalfGap = 3;  // between the middle of marks that are side by side and their names
const kMarkWidth = 14;  // of the mark of a sensor, with a gap

/// Cells for tiles, in units of a tile. `views` has { x, y } or undefined for each tile; tiles without fill the free cells,
/// row by row. Returns { cells: [[x, y]], columns, rows }; `columns` may be more than asked if a view needs it.
export const placeTiles = (views, columns) => {
  const taken = new Set();
  const cells = new Array(views.length);
  let most = Math.max(1, columns);
  views.forEach((view, index) => {
    if (!view) return;
    const x = Math.max(0, view.x);
    const y = Math.max(0, view.y);
    cells[index] = [x, y];
    most = Math.max(most, Math.ceil(x) + 1);
    for (const column of [Math.floor(x), Math.ceil(x)]) for (const row of [Math.floor(y), Math.ceil(y)]) taken.add(column + "," + row);
  });
  let next = 0;
  views.forEach((view, index) => {
    if (view) return;
    while (taken.has(next % most + "," + Math.floor(next / most))) ++next;
    cells[index] = [next % most, Math.floor(next / most)];
    ++next;
  });
  const rows = cells.reduce((last, [, y]) => Math.max(last, Math.ceil(y) + 1), 0);
  return {cells, columns: Math.min(most, cells.reduce((last, [x]) => Math.max(last, Math.ceil(x) + 1), 1)), rows};
};

/// The index of the cell that an arrow key leads to from `from`, or `from` itself if there is none.
export const neighbor = (cells, from, key) => {
  const [x, y] = cells[from];
  const [dx, dy] = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[key];
  let best = from;
  let least = Infinity;
  cells.forEach(([cx, cy], index) => {
    const along = (cx - x) * dx + (cy - y) * dy;
    if (along <= 0) return;
    const across = Math.abs((cx - x) * dy) + Math.abs((cy - y) * dx);
    const distance = along + 4 * across;
    if (distance < least) [best, least] = [index, distance];
  });
  return best;
};

/// The station whose line and process begin a name; null without one.
export const stationFinder = ({stations}) => {
  const known = new Map(stations.map(({line, process}, index) => [line + "_" + process, index]));
  return (name) => known.get(name.split("_").slice(0, 2).join("_")) ?? null;
};

/// The stations of a track or place, by the names of its sensors and of itself.
export const stationsOf = (location, plant, find = stationFinder(plant)) => {
  const names = location.sensors.map(({symbol}) => plant.symbols[symbol].name);
  return [...new Set([...names, location.name].map(find).filter((station) => station !== null))];
};

/// The symbols that a person operates and that are in no device, by station; null for those whose names are of no station.
export const operatedSymbols = (plant) => {
  const find = stationFinder(plant);
  const found = new Map();
  plant.symbols.forEach(({operator, device, name}, index) => {
    if (!operator || device !== null) return;
    const station = find(name);
    if (found.has(station)) found.get(station).push(index);
    else found.set(station, [index]);
  });
  return found;
};

/// The devices of each station, and last those in none, as { station, devices }.
export const groupDevices = (plant) => {
  const groups = plant.stations.map((_, station) => ({station, devices: []}));
  const loose = {station: null, devices: []};
  plant.devices.forEach(({station}, index) => (station === null ? loose : groups[station]).devices.push(index));
  return [...groups, loose].filter(({devices}) => devices.length > 0);
};

/// Where the marks of sensors, { at }, are in a strip: those that would be over each other are side by side, in their order. `x(at)` is
/// where a position is. Sets `mark`, the middle in pixels, and `side`: where its name is from there ("none": it has no room).
export const placeMarks = (sensors, x) => {
  const groups = [];
  for (const sensor of [...sensors].sort((a, b) => a.at - b.at)) {
    const last = groups[groups.length - 1];
    if (last && x(sensor.at) - last.middle < (last.sensors.length + 1) / 2 * kMarkWidth) {
      last.sensors.push(sensor);
      last.middle = (x(last.sensors[0].at) + x(sensor.at)) / 2;
    } else groups.push({middle: x(sensor.at), sensors: [sensor]});
  }
  for (const {middle, sensors: {length}, sensors: group} of groups) {
    group.forEach((sensor, i) => {
      sensor.mark = middle + (i - (length - 1) / 2) * kMarkWidth;
      sensor.side = length === 1 ? "center" : i === 0 ? "right" : i === length - 1 ? "left" : "none";
    });
  }
};

/// From its mark, the left end of a name of this width. `side` is the alignment of the text.
const leftOf = ({mark, side, wide}) => side === "right" ? mark + kMarkWidth / 2 - kHalfGap - wide : side === "left" ? mark - kMarkWidth / 2 + kHalfGap : mark - wide / 2;

/// Which names of sensors, { text, wide } with their marks, are written in a strip: from the left, those that overlap no other one. Sets
/// `shown` and `left`.
export const placeNames = (sensors, width) => {
  let until = 0;
  for (const sensor of [...sensors].sort((a, b) => a.mark - b.mark)) {
    const left = leftOf(sensor);
    const fits = sensor.side !== "none" && left >= until && left + sensor.wide <= width;
    Object.assign(sensor, {shown: fits ? sensor.text : "", left});
    if (fits) until = left + sensor.wide + (sensor.side === "right" ? 0 : kNameGap);
  }
};

/// Round numbers between `from` and `to`, about `most` of them: for the ticks of an axis.
export const ticks = (from, to, most) => {
  const span = to - from;
  if (!(span > 0) || most < 1) return [];
  const rough = span / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= rough * (1 - 1e-9));
  const found = [];
  for (let i = Math.ceil(from / step - 1e-9) || 0; i * step <= to * (1 + 1e-12); ++i) found.push(i * step);
  return found;
};
