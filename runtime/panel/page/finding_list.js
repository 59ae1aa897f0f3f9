// Findings as elements: rows of the findings view, and short lists in details.
import {button, make} from "./dom.js";
import {nameLink} from "./links_to.js";
import {exactInstant, instant, withRoundTimes} from "./words.js";

const kShort = 5;

/// Shows the time of a finding in the chart, with the device or symbol that it is about.
export const showFinding = (app, {t, of}) => {
  const found = app.names.find(of);
  if (found?.kind === "device") app.chart.addDevice(found.index, t);
  else if (found?.kind === "symbol") app.chart.addSymbol(found.index, t);
  else app.chart.showTime(t);
};

/// The last findings of which `matches(of)` is true, as a list that follows the plant.
export const lastFindings = (pane, matches) => {
  const {store} = pane.app;
  const element = make("ul", {class: "plain"});
  let shown = null;
  pane.follow(() => {
    if (store.findings === shown) return;
    shown = store.findings;
    const found = store.findings.filter(({of}) => matches(of)).slice(-kShort).reverse();
    element.replaceChildren(...(found.length === 0 ? [make("li", {class: "soft"}, "none")] : found.map((finding) =>
      make("li", {}, button(instant(finding.t), () => showFinding(pane.app, finding), {class: "small", title: exactInstant(finding.t) + ": show in chart"}), " ",
        make("span", {title: finding.text}, withRoundTimes(finding.text))))));
  });
  return element;
};

/// The device, symbol or requirement of a finding.
export const findingSubject = (app, {of}) => nameLink(app, of);
