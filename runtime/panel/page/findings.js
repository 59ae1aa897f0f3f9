// The findings view: what the plant reports, the newest first, and the requirements.
import {tell} from "./dialog.js";
import {button, make, setText} from "./dom.js";
import {showFinding, findingSubject} from "./finding_list.js";
import {linkTo} from "./links_to.js";
import {requirementState} from "./requirement_details.js";
import {VirtualList} from "./virtual_list.js";
import {count, exactInstant, instant, withRoundTimes} from "./words.js";

const kFindingHeight = 80;
const kRequirementHeight = 30;
const kOrder = {violated: 0, ok: 1};
const kLetters = {violated: "!", ok: "✓"};

export class FindingsView {
  constructor(app) {
    Object.assign(this, {app, title: "Findings", order: []});
    this.count = make("span", {class: "soft"});
    this.list = new VirtualList({height: kFindingHeight, label: "Findings, the newest first", role: "list", makeRow: () => this.makeRow(),
      fillRow: (row, at) => this.fillRow(row, at)});
    new ResizeObserver(() => { for (const row of this.list.rows.values()) this.offerMore(row); }).observe(this.list.element);
    this.requirementCount = make("span", {class: "soft"});
    this.requirements = new VirtualList({height: kRequirementHeight, label: "Requirements", role: "list",
      makeRow: () => this.makeRequirement(), fillRow: (row, at) => this.fillRequirement(row, at)});
    this.element = make("div", {class: "view fills two"},
      make("section", {"aria-label": "Findings"}, make("h2", {}, "Findings ", this.count), this.list.element),
      make("section", {"aria-label": "Requirements"}, make("h2", {}, "Requirements ", this.requirementCount), this.requirements.element));
  }

  show() {
    this.showFindings();
    this.showRequirements();
  }

  showFindings() {
    const {findings} = this.app.store;
    const last = findings[findings.length - 1];
    setText(this.count, last ? count(last.n + 1, "finding") + (findings.length <= last.n ? ", the last " + findings.length : "") : "none yet");
    this.list.setCount(findings.length);
  }

  makeRow() {
    const row = {time: make("span", {class: "time"}), kind: make("strong", {}), subject: make("span", {}), text: make("div", {class: "clamp"})};
    row.more = button("More", () => this.tell(row.finding), {class: "small", hidden: true});
    row.first = button("Show in chart", () => showFinding(this.app, row.finding), {class: "small"});
    row.element = make("div", {class: "finding", role: "listitem"},
      make("div", {class: "row"}, row.time, row.kind, row.subject, make("span", {class: "grow"}), row.more, row.first), row.text);
    return row;
  }

  fillRow(row, at) {
    const {findings} = this.app.store;
    const finding = findings[findings.length - 1 - at];
    if (row.finding === finding) return;
    row.finding = finding;
    setText(row.time, instant(finding.t));
    row.time.title = exactInstant(finding.t);
    setText(row.kind, finding.finding);
    row.kind.className = "severity-" + (["error", "warning"].includes(finding.severity) ? finding.severity : "note");
    row.subject.replaceChildren(findingSubject(this.app, finding));
    setText(row.text, withRoundTimes(finding.text));
    row.text.title = finding.text;
    row.more.setAttribute("aria-label", "More of the finding at " + instant(finding.t));
    this.offerMore(row);
  }

  /// A button for the whole text, if a row does not show it.
  offerMore({text, more}) { more.hidden = text.scrollHeight <= text.clientHeight; }

  tell({t, finding, of, text}) {
    tell(finding + " at " + instant(t), [make("p", {}, findingSubject(this.app, {of})), make("p", {}, withRoundTimes(text))]);
  }

  showRequirements() {
    const {store, plant} = this.app;
    const state = (index) => requirementState(store, index)[0];
    this.order = [...plant.requirements.keys()].sort((a, b) => kOrder[state(a)] - kOrder[state(b)] || a - b);
    const violated = this.order.filter((index) => requirementState(store, index)[2] > 0).length;
    setText(this.requirementCount, plant.requirements.length === 0 ? "none" : count(plant.requirements.length, "requirement") + ", " +
      violated + " violated so far");
    this.requirements.setCount(this.order.length);
  }

  makeRequirement() {
    const row = {letter: make("span", {class: "letter", "aria-hidden": "true"}), state: make("span", {class: "soft"})};
    row.first = make("a", {class: "name cut"});
    row.element = make("div", {class: "row requirement", role: "listitem"}, row.letter, row.first, make("span", {class: "grow"}), row.state);
    return row;
  }

  fillRequirement(row, at) {
    const {store, plant} = this.app;
    const index = this.order[at];
    const [state, , violations] = requirementState(store, index);
    const {name} = plant.requirements[index];
    row.first.href = linkTo("requirement", name).getAttribute("href");
    setText(row.first, name);
    row.first.title = name;
    row.letter.className = "letter r-" + (violations > 0 ? "violated" : state);
    setText(row.letter, violations > 0 ? "!" : kLetters[state] ?? "?");
    setText(row.state, state + (violations > 0 ? ", violated " + violations + " x" : ""));
  }

  change(change) {
    if (change.all || change.keys.has("findings")) this.showFindings();
    if (change.all || change.requirements.length > 0) this.showRequirements();
  }
}
