'use strict';
// Draws the durations of each time as a histogram, with what was learned and what the model has.
const data = JSON.parse(document.getElementById('data').textContent);
const at = id => document.getElementById(id);
const most = 300;
const seconds = t => `${Number((t / 1e9).toPrecision(6))} s`;
const style = getComputedStyle(document.documentElement);
const color = name => style.getPropertyValue(name).trim();

function element(tag, text, className) {
  const made = document.createElement(tag);
  made.textContent = text;
  if (className) made.className = className;
  return made;
}

at('title').textContent = document.title;
at('summary').textContent = data.summary;
at('files').replaceChildren(...data.sources.map(source => element('li', source)));

function draw(canvas) {
  const time = data.times[canvas.dataset.of];
  const { from, step, counts, outliers } = time.histogram;
  const scale = devicePixelRatio || 1;
  const width = canvas.clientWidth;
  const height = canvas.clientHeight;
  canvas.width = width * scale;
  canvas.height = height * scale;
  const pen = canvas.getContext('2d');
  pen.scale(scale, scale);
  const base = height - 18;
  const x = t => (t - from) / (step * counts.length) * width;
  const highest = Math.max(1, ...counts.map((count, i) => count + outliers[i]));
  const tall = count => count / highest * (base - 14);

  pen.globalAlpha = 0.25;
  pen.fillStyle = color('--focus');
  const [low, high] = time.proposed;
  pen.fillRect(Math.min(x(low), width - 3) - 1.5, 0, Math.max(3, x(high) - x(low) + 3), base);
  pen.globalAlpha = 1;
  counts.forEach((count, i) => {
    const left = i / counts.length * width;
    const wide = Math.max(1, width / counts.length - 1);
    pen.fillStyle = color('--expected');
    pen.fillRect(left, base - tall(count), wide, tall(count));
    pen.fillStyle = color('--mark');
    const rare = outliers[i] ? Math.max(2, tall(outliers[i])) : 0;
    pen.fillRect(left, base - tall(count) - rare, wide, rare);
  });
  if (time.given) {
    pen.strokeStyle = color('--actual');
    pen.setLineDash([4, 3]);
    pen.lineWidth = 1.5;
    for (const t of new Set(time.given)) {
      if (x(t) < 0 || x(t) > width) continue;
      pen.beginPath();
      pen.moveTo(x(t), 0);
      pen.lineTo(x(t), base);
      pen.stroke();
    }
    pen.setLineDash([]);
  }
  pen.strokeStyle = color('--line');
  pen.strokeRect(0, base, width, 0);
  pen.fillStyle = color('--soft');
  pen.font = '11px system-ui, sans-serif';
  pen.textAlign = 'left';
  pen.fillText(seconds(Math.max(0, from)), 0, height - 5);
  pen.textAlign = 'center';
  pen.fillText(seconds(from + step * counts.length / 2), width / 2, height - 5);
  pen.textAlign = 'right';
  pen.fillText(seconds(from + step * counts.length), width, height - 5);
  pen.fillText(`${highest}`, width, 11);
}

const visible = new Set();
const observer = new IntersectionObserver(entries => {
  for (const { target, isIntersecting } of entries) {
    if (!isIntersecting) { visible.delete(target); continue; }
    visible.add(target);
    draw(target);
  }
});

function card(time, index) {
  const made = element('article', '', time.odd ? 'card odd' : 'card');
  made.append(element('h3', `${time.title}: ${time.of}`));
  made.append(element('p', `learned ${time.learned}, model ${time.model}`));
  if (time.odd) made.append(element('p', time.odd, 'why'));
  const canvas = document.createElement('canvas');
  canvas.dataset.of = index;
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', `Histogram: ${time.figures}`);
  made.append(canvas, element('p', time.figures), element('p', time.from, 'soft'));
  if (time.groups) made.append(element('p', time.groups));
  if (time.outliers.length) {
    const list = document.createElement('ul');
    list.append(...time.outliers.map(outlier => element('li', outlier)));
    made.append(element('p', 'Outliers:'), list);
  }
  observer.observe(canvas);
  return made;
}

function fill() {
  observer.disconnect();
  visible.clear();
  const word = at('search').value.toLowerCase();
  const chosen = data.times.map((time, i) => [time, i]).filter(([time]) =>
    `${time.title} ${time.of}`.toLowerCase().includes(word) && (time.odd || !at('only').checked));
  at('cards').replaceChildren(...chosen.slice(0, most).map(([time, i]) => card(time, i)));
  for (const canvas of at('cards').querySelectorAll('canvas')) {
    if (canvas.getBoundingClientRect().top < innerHeight) draw(canvas);  // without a frame of empty pictures
  }
  at('count').textContent = `${chosen.length} of ${data.times.length}`;
  at('more').textContent = chosen.length > most ? `${chosen.length - most} more match; search for a name to see them.` : '';
}

at('pairs').hidden = data.pairs.length === 0;
at('pair-rows').replaceChildren(...data.pairs.map(pair => {
  const row = document.createElement('tr');
  row.append(...[pair.operation, pair.event, pair.evidence].map(text => element('td', text)));
  return row;
}));

for (const list of data.not_seen) {
  const details = document.createElement('details');
  details.append(element('summary', `${list.title} (${list.count})`));
  const names = document.createElement('ul');
  names.append(...list.names.map(name => element('li', name)));
  if (list.count > list.names.length) names.append(element('li', `and ${list.count - list.names.length} more`));
  details.append(names);
  at('not-seen').append(details);
}
if (data.not_seen.length === 0) at('not-seen').textContent = 'Everything was seen.';

at('search').addEventListener('input', fill);
at('only').addEventListener('change', fill);
addEventListener('resize', () => visible.forEach(draw));
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => visible.forEach(draw));
fill();
