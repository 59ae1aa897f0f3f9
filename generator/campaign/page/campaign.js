'use strict';
// The table of a fault campaign: sorted, filtered, and the chart of each run.
const data = JSON.parse(document.getElementById('data').textContent);
const at = id => document.getElementById(id);
const most = 300;

function made(tag, properties, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}
const seconds = t => t < 0 ? '' : `${Number((t / 1e9).toPrecision(9))} s`;
const rank = new Map(data.classes.map(([name], i) => [name, i]));

/** A text that may break after each `_`: names of symbols are long. */
function broken(text) {
  return text.split(/(?<=_)/).flatMap((part, i) => i === 0 ? [part] : [document.createElement('wbr'), part]);
}

/** The columns, in words of an FMEA: what a cell shows, line by line, and what it is sorted by. */
const columns = [
  { head: 'Item', lines: row => [row.item], more: row => row.more, kind: 'item' },
  { head: 'Failure mode', lines: row => [row.mode] },
  { head: 'Phase', lines: row => row.at === 0 ? [row.phase] : [seconds(row.at), row.phase], key: row => row.at },
  { head: 'Class', lines: row => [row.class], key: row => rank.get(row.class), kind: 'class' },
  { head: 'Local effect: seen first by the program', lines: row => [row.seen === '' ? 'nothing' : row.seen], more: row => row.seen_at < 0 ? '' : `at ${seconds(row.seen_at)}`, key: row => row.seen_at, kind: 'name' },
  { head: 'Effect: reaction of the program', lines: row => row.reaction.split('; '), more: row => row.step === '' ? '' : `base case: ${row.step}`, kind: 'reaction' },
  { head: 'Detected by, after', lines: row => row.detection < 0 ? [] : [seconds(row.detection), ...row.alarms], key: row => row.detection < 0 ? Infinity : row.detection, kind: 'name' },
  { head: 'On at the end', lines: row => row.on.length === 0 ? [row.end] : row.on, key: row => row.on.length, kind: 'on' },
];
const text = (row, column) => column.lines(row).join(' ');

const state = { classes: new Set(data.classes.filter(([name, , count]) => count > 0 && name !== 'no effect').map(([name]) => name)), column: -1, down: false, all: false };
if (state.classes.size === 0) state.classes.add('no effect');

/** Both runs for the page of a comparison. */
function chartData(row) {
  const values = changes => changes.filter((_, i) => i % 2 === 1);
  return {
    summary: `${row.item} ${row.mode}, ${row.phase}: ${row.class}`,
    expected: { file: 'without the fault', end: row.chart.end },
    actual: { file: 'with the fault', end: row.chart.end },
    window: 0,
    left_out: row.chart.left_out,
    series: row.chart.series.map(([name, base, run]) => {
      const expected = data.base[base];
      const all = [0, ...values(expected), ...values(run)];
      return { name, kind: 'value', least: Math.min(...all), most: Math.max(...all), expected, actual: run };
    }),
    differences: [{ t: row.at, from: row.at, to: row.at, of: -1, words: 'the fault begins' }, ...row.chart.differences],
  };
}
const forScript = json => json.replaceAll('<', '\\u003c');

/** The row below a row: the command, and the chart. */
function opened(row) {
  const copy = made('button', { type: 'button', textContent: 'Copy' });
  copy.addEventListener('click', async () => {
    try { await navigator.clipboard.writeText(row.command); copy.textContent = 'Copied'; } catch { copy.textContent = 'Select the text to copy it'; }
  });
  const box = made('td', { colSpan: columns.length, className: 'open' }, made('p', {}, 'This command repeats the run; with --trace FILE or --vcd FILE you keep it: ', copy),
    made('pre', { textContent: row.command }));
  if (row.chart) {
    const frame = made('iframe', { title: `chart of ${row.item} ${row.mode}` });
    frame.srcdoc = data.chart.replace('@data@', () => forScript(JSON.stringify(chartData(row))));
    if (row.chart.cut) box.append(made('p', { className: 'soft', textContent: 'A series has too many changes: only those around the first difference are shown.' }));
    box.append(frame);
  }
  if (row.no_room) box.append(made('p', { className: 'soft', textContent: 'This row has no chart: the page has room for those of the worst rows only.' }));
  return made('tr', { className: 'opened' }, box);
}

function cell(row, column) {
  const kind = column.kind === 'class' ? row.class.replace(' ', '-') : column.kind ?? '';
  const lines = column.lines(row).map(line => made('div', {}, ...broken(line)));
  if (column.kind === 'item') {
    const button = made('button', { type: 'button', textContent: row.chart ? 'Chart and command' : 'Command' });
    button.setAttribute('aria-expanded', 'false');
    button.addEventListener('click', () => {
      const line = button.closest('tr');
      const isOpen = line.nextElementSibling?.className === 'opened';
      isOpen ? line.nextElementSibling.remove() : line.after(opened(row));
      button.setAttribute('aria-expanded', String(!isOpen));
    });
    return made('td', { className: 'name' }, ...lines, made('div', { className: 'soft', textContent: row.more }), button);
  }
  if (column.kind === 'on' && row.on.length > 3) {
    return made('td', { className: 'name' }, made('details', {}, made('summary', { textContent: `${row.on.length} operations` }), ...lines));
  }
  const one = made('td', { className: kind }, ...lines);
  const more = column.more?.(row);
  if (more) one.append(made('div', { className: 'soft', textContent: more }));
  return one;
}

function chosen() {
  const word = at('search').value.toLowerCase();
  const mode = at('mode').value;
  const rows = data.rows.filter(row => state.classes.has(row.class) && (mode === '' || row.mode === mode) &&
    (word === '' || columns.some(column => `${text(row, column)} ${column.more?.(row) ?? ''}`.toLowerCase().includes(word))));
  if (state.column < 0) return rows;
  const column = columns[state.column];
  const key = column.key ?? (row => text(row, column));
  const sign = state.down ? -1 : 1;
  const compared = (a, b) => typeof a === 'number' ? a - b || 0 : a.localeCompare(b, undefined, { numeric: true });
  return rows.map((row, i) => [key(row), i, row]).sort((a, b) => sign * compared(a[0], b[0]) || a[1] - b[1]).map(([, , row]) => row);
}

function show() {
  const rows = chosen();
  const some = state.all ? rows : rows.slice(0, most);
  at('rows').replaceChildren(...some.map(row => made('tr', { className: 'row' }, ...columns.map(column => cell(row, column)))));
  at('count').textContent = `${rows.length} of ${data.rows.length} rows${some.length < rows.length ? `, the first ${some.length} are shown` : ''}`;
  at('more').hidden = some.length === rows.length;
  at('more').textContent = `Show all ${rows.length} rows`;
  [...at('heads').children].forEach((head, i) => {
    head.setAttribute('aria-sort', i !== state.column ? 'none' : state.down ? 'descending' : 'ascending');
    head.querySelector('.arrow').textContent = i !== state.column ? '' : state.down ? ' \u25bc' : ' \u25b2';
  });
}

/** A cell of CSV; one that a spreadsheet would take for a formula begins with an apostrophe. */
function csvCell(content) {
  const safe = /^[=+\-@\t\r]/.test(content) ? `'${content}` : content;
  return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}
/** The same columns as `symplant campaign --csv`. */
const cells = [
  ['item', row => row.item], ['address and comment', row => row.more], ['failure mode', row => row.mode], ['phase', row => row.phase],
  ['from [s]', row => row.at / 1e9], ['class', row => row.class], ['seen first by the program', row => row.seen],
  ['seen at [s]', row => row.seen_at < 0 ? '' : row.seen_at / 1e9], ['reaction', row => row.reaction], ['violated requirement', row => row.requirement],
  ['violated at [s]', row => row.violated_at < 0 ? '' : row.violated_at / 1e9], ['step of the base case that fails', row => row.step],
  ['alarms', row => row.alarms.join('; ')], ['alarm after [s]', row => row.detection < 0 ? '' : row.detection / 1e9],
  ['on at the end', row => row.on.length === 0 ? row.end : row.on.join('; ')], ['severity', () => ''], ['measure', () => ''], ['remark', () => ''],
  ['command', row => row.command],
];
function save() {
  const lines = [cells.map(([head]) => head), ...chosen().map(row => cells.map(([, cell]) => csvCell(String(cell(row)))))];
  const link = made('a', { href: URL.createObjectURL(new Blob([lines.map(line => line.join(',')).join('\n') + '\n'], { type: 'text/csv' })), download: 'campaign.csv' });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

at('title').textContent = `Fault campaign of ${data.plant}`;
at('summary').textContent = data.summary;
at('about').append(...data.run.about.map(([what, words]) => made('div', {}, made('dt', { textContent: what }), made('dd', { textContent: words }))));
if (data.run.alarms === 0) {
  at('note').hidden = false;
  at('note').textContent = 'The plant description names no alarms (key alarms of plant.json), so no fault can be detected in this table.';
}
at('heads').append(...columns.map((column, i) => {
  const button = made('button', { type: 'button' }, column.head, made('span', { className: 'arrow' }));
  button.addEventListener('click', () => {
    state.down = state.column === i && !state.down;
    state.column = i;
    show();
  });
  return made('th', { scope: 'col' }, button);
}));
at('classes').append(...data.classes.map(([name, words, count]) => {
  const box = made('input', { type: 'checkbox', checked: state.classes.has(name), disabled: count === 0 });
  box.setAttribute('aria-label', `show ${name}`);
  box.addEventListener('change', () => {
    box.checked ? state.classes.add(name) : state.classes.delete(name);
    show();
  });
  return made('tr', {}, made('td', {}, box), made('td', { className: name.replace(' ', '-'), textContent: name }), made('td', { textContent: count }), made('td', { textContent: words }));
}));
at('mode').append(...[...new Set(data.rows.map(row => row.mode))].sort().map(mode => made('option', { value: mode, textContent: mode })));
at('search').addEventListener('input', show);
at('mode').addEventListener('change', show);
at('save').addEventListener('click', save);
at('more').addEventListener('click', () => { state.all = true; show(); });
show();
