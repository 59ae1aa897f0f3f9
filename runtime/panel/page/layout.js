// Where things are in the line view. Pure functions, without elements.

const kNameGap = 8;  // between two names of sensors

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

const levels = (name) => name.split("_").slice(0, 2).join("_");

/// The stations of a track or place, by the names of its sensors and of itself.
export const stationsOf = (location, plant) => {
  const found = new Set();
  const names = location.sensors.map(({symbol}) => plant.symbols[symbol].name);
  for (const name of [...names, location.name]) {
    const station = plant.stations.findIndex(({line, process}) => line + "_" + process === levels(name));
    if (station >= 0) found.add(station);
  }
  return [...found];
};

/// The devices of each station, and last those in none, as { station, devices }.
export const groupDevices = (plant) => {
  const groups = plant.stations.map((_, station) => ({station, devices: []}));
  const loose = {station: null, devices: []};
  plant.devices.forEach(({station}, index) => (station === null ? loose : groups[station]).devices.push(index));
  return [...groups, loose].filter(({devices}) => devices.length > 0);
};

/// Which names of sensors, { at, text, wide }, are written in a strip: from the left, those that overlap no other one. `x(at)` is
/// where a position is. Sets `shown`.
export const placeNames = (sensors, width, x) => {
  let until = 0;
  for (const sensor of [...sensors].sort((a, b) => a.at - b.at)) {
    const left = x(sensor.at) - sensor.wide / 2;
    const fits = left >= until && left + sensor.wide <= width;
    sensor.shown = fits ? sensor.text : "";
    if (fits) until = left + sensor.wide + kNameGap;
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
