'use strict';
// Shows the cases of a suite, and the chart of one of them.
const data = JSON.parse(document.getElementById('data').textContent);
const at = id => document.getElementById(id);

function made(tag, properties, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

/** Text of JSON for a script element. */
const forScript = json => json.replaceAll('<', '\\u003c');

function showChart(one) {
  at('chart').hidden = false;
  at('chart-title').textContent = one.title;
  at('frame').srcdoc = data.chart.replace('@data@', () => forScript(one.chart));
  at('chart').scrollIntoView();
}

function row(one) {
  const details = made('td', {});
  if (one.messages.length > 0) {
    const list = made('details', { open: one.verdict !== 'passed' }, made('summary', { textContent: `${one.messages.length} lines` }),
      made('pre', { textContent: one.messages.join('\n') }));
    details.append(list);
  }
  if (one.chart !== '') details.append(made('button', { type: 'button', textContent: 'Chart', onclick: () => showChart(one) }));
  return made('tr', {}, made('th', { scope: 'row', textContent: one.title }), made('td', { className: one.verdict, textContent: one.verdict }),
    made('td', { textContent: one.reference }), made('td', { textContent: one.seconds }), details);
}

function show() {
  const shown = data.cases.filter(one => !at('only').checked || one.verdict !== 'passed');
  at('cases').replaceChildren(...shown.map(row));
}

at('summary').textContent = data.summary;
at('only').addEventListener('change', show);
show();
