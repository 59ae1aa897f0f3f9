'use strict';
// Draws two traces, one under the other, and marks where they differ.
const data = JSON.parse(document.getElementById('data').textContent);
const at = id => document.getElementById(id);
const most = { rows: 200, list: 2000 };
const whole = { from: 0, to: Math.max(data.expected.end, data.actual.end, 1) };
const shown = { ...whole };
const seconds = t => `${Number((t / 1e9).toPrecision(9))} s`;
const style = getComputedStyle(document.documentElement);
const color = name => style.getPropertyValue(name).trim();

at('summary').textContent = data.summary;
at('files').textContent = `expected: ${data.expected.file}, to ${seconds(data.expected.end)} | actual: ${data.actual.file}, ` +
  `to ${seconds(data.actual.end)} | window ${seconds(data.window)}`;

const marks = data.series.map(() => []);
for (const difference of data.differences) if (difference.of >= 0) marks[difference.of].push(difference);

/** The index of the last change at or before a time, -1 if there is none. */
function before(changes, time) {
  let low = 0;
  let high = changes.length / 2;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (changes[2 * middle] <= time) low = middle + 1; else high = middle;
  }
  return low - 1;
}

function drawLine(pen, series, changes, end, top, height, width) {
  const x = t => (t - shown.from) / (shown.to - shown.from) * width;
  const low = series.least;
  const high = series.most > low ? series.most : low + 1;
  const y = v => top + height - (v - low) / (high - low) * height;
  pen.beginPath();
  if (series.kind === 'parts') {
    for (let i = before(changes, shown.from) + 1; 2 * i < changes.length && changes[2 * i] <= shown.to; ++i) {
      pen.moveTo(x(changes[2 * i]), top);
      pen.lineTo(x(changes[2 * i]), top + height);
    }
  } else {
    let i = before(changes, shown.from);
    let value = i < 0 ? 0 : changes[2 * i + 1];
    let last = -1;
    pen.moveTo(0, y(value));
    for (++i; 2 * i < changes.length && changes[2 * i] <= shown.to; ++i) {
      const here = x(changes[2 * i]);
      pen.lineTo(here, y(value));
      value = changes[2 * i + 1];
      pen.lineTo(here, y(value));
      if (here - last < 0.25) {  // denser than the screen: go on at the next pixel
        const next = before(changes, shown.from + (here + 0.5) / width * (shown.to - shown.from));
        if (next > i) i = next, value = changes[2 * i + 1];
      }
      last = here;
    }
    pen.lineTo(Math.min(width, x(end)), y(value));
  }
  pen.stroke();
}

function draw(canvas) {
  const series = data.series[canvas.dataset.of];
  const scale = devicePixelRatio || 1;
  const width = canvas.clientWidth;
  const height = canvas.clientHeight;
  canvas.width = width * scale;
  canvas.height = height * scale;
  const pen = canvas.getContext('2d');
  pen.scale(scale, scale);
  pen.fillStyle = color('--mark');
  pen.globalAlpha = 0.35;
  for (const mark of marks[canvas.dataset.of]) {
    const from = (mark.from - shown.from) / (shown.to - shown.from) * width;
    const to = (mark.to - shown.from) / (shown.to - shown.from) * width;
    if (to >= -2 && from <= width + 2) pen.fillRect(from - 1, 0, Math.max(3, to - from + 2), height);
  }
  pen.globalAlpha = 1;
  pen.lineWidth = 1.5;
  const half = height / 2;
  pen.strokeStyle = color('--expected');
  drawLine(pen, series, series.expected, data.expected.end, 4, half - 8, width);
  pen.strokeStyle = color('--actual');
  drawLine(pen, series, series.actual, data.actual.end, half + 4, half - 8, width);
}

const visible = new Set();
const observer = new IntersectionObserver(entries => {
  for (const { target, isIntersecting } of entries) {
    if (!isIntersecting) { visible.delete(target); continue; }
    visible.add(target);
    draw(target);
  }
});

function redraw() {
  at('span').textContent = `${seconds(shown.from)} to ${seconds(shown.to)}`;
  for (const canvas of visible) draw(canvas);
}

/** Shows a span of time, within the run. */
function show(from, to) {
  const span = Math.min(Math.max(to - from, 1000), whole.to - whole.from);
  shown.from = Math.min(Math.max(from, whole.from), whole.to - span);
  shown.to = shown.from + span;
  redraw();
}
function zoom(factor, middle = (shown.from + shown.to) / 2) {
  show(middle - (middle - shown.from) * factor, middle + (shown.to - middle) * factor);
}
const move = share => show(shown.from + share * (shown.to - shown.from), shown.to + share * (shown.to - shown.from));

function fill() {
  observer.disconnect();
  visible.clear();
  const word = at('search').value.toLowerCase();
  const chosen = [];
  data.series.forEach((series, i) => {
    if (series.name.toLowerCase().includes(word) && !(at('only').checked && marks[i].length === 0)) chosen.push(i);
  });
  at('rows').replaceChildren(...chosen.slice(0, most.rows).map(i => {
    const row = document.createElement('div');
    row.className = 'row';
    const name = document.createElement('div');
    const n = marks[i].length;
    name.textContent = data.series[i].name + (n === 0 ? '' : ` (${n})`);
    const canvas = document.createElement('canvas');
    canvas.dataset.of = i;
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', `${data.series[i].name}: ${n} difference${n === 1 ? '' : 's'}`);
    row.append(name, canvas);
    observer.observe(canvas);
    return row;
  }));
  const hidden = Math.max(0, chosen.length - most.rows);
  at('more').textContent = [hidden ? `${hidden} more match; search for a name to see them.` : '',
    data.left_out ? `${data.left_out} elements without differences are left out of the chart: the traces are too long for all.` : '']
    .filter(Boolean).join(' ');
}

at('list').replaceChildren(...data.differences.slice(0, most.list).map(difference => {
  const row = document.createElement('tr');
  const time = document.createElement('button');
  time.type = 'button';
  time.textContent = seconds(difference.t);
  time.addEventListener('click', () => {
    const span = Math.max(4 * (difference.to - difference.from), 5e9);
    show(difference.from - span / 4, difference.from + span * 3 / 4);
    if (difference.of >= 0) document.querySelector(`canvas[data-of="${difference.of}"]`)?.scrollIntoView({ block: 'center' });
  });
  for (const content of [time, difference.of < 0 ? '' : data.series[difference.of].name, difference.words]) {
    const cell = document.createElement('td');
    cell.append(content);
    row.append(cell);
  }
  return row;
}));
if (data.differences.length === 0) at('rest').textContent = 'None.';
if (data.differences.length > most.list) at('rest').textContent = `and ${data.differences.length - most.list} more`;

at('closer').addEventListener('click', () => zoom(0.5));
at('farther').addEventListener('click', () => zoom(2));
at('whole').addEventListener('click', () => show(whole.from, whole.to));
at('back').addEventListener('click', () => move(-0.5));
at('on').addEventListener('click', () => move(0.5));
at('search').addEventListener('input', fill);
at('only').addEventListener('change', fill);
at('rows').addEventListener('wheel', event => {
  if (!event.ctrlKey || event.target.tagName !== 'CANVAS') return;  // the page still scrolls
  event.preventDefault();
  const box = event.target.getBoundingClientRect();
  zoom(event.deltaY < 0 ? 0.8 : 1.25, shown.from + (event.clientX - box.left) / box.width * (shown.to - shown.from));
}, { passive: false });
let grabbed = null;
at('rows').addEventListener('pointerdown', event => { if (event.target.tagName === 'CANVAS') grabbed = event; });
addEventListener('pointermove', event => {
  if (!grabbed) return;
  const by = (grabbed.clientX - event.clientX) / grabbed.target.clientWidth * (shown.to - shown.from);
  grabbed = { clientX: event.clientX, target: grabbed.target };
  show(shown.from + by, shown.to + by);
});
addEventListener('pointerup', () => { grabbed = null; });
addEventListener('resize', redraw);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);

at('only').checked = data.differences.some(difference => difference.of >= 0);
fill();
redraw();
