// Why a thing is as it is: a sentence and a tree of what it follows from. Asked again when something in it changes, and while
// plant time runs: a cause that was no part of it may be new.
import {button, make, setText} from "./dom.js";
import {deviceLink, locationLink, nameLink, symbolLink} from "./links_to.js";
import {instant, withRoundTimes} from "./words.js";

const kPause = 500;  // ms between two questions
const kOldest = 2000;  // ms until it is asked again while plant time runs
const kMostDeep = 12;
const valueLink = (app, index) => nameLink(app, app.names.name("value", index));
const kLinks = {device: deviceLink, symbol: symbolLink, location: locationLink, value: valueLink};

/// The text of a node; the names of devices and symbols in it are links.
const linked = (app, text) => withRoundTimes(text).split(/([\p{L}\p{N}_.]{3,}(?:\[\d+\])?)/u).map((word, i) => {
  if (i % 2 === 0) return word;
  if (app.names.find(word)) return nameLink(app, word);
  const end = word.lastIndexOf(".");  // DEVICE.STATE, or the last word of a sentence
  if (end > 0 && app.names.find(word.slice(0, end))) return [nameLink(app, word.slice(0, end)), word.slice(end)];
  return word;
});

/// The names that a tree is about, by kind: `device`, `symbol`, `location` ...
const namesIn = (node, found = []) => {
  for (const about of node.about ?? []) found.push(...Object.entries(about));
  for (const cause of node.because ?? []) namesIn(cause, found);
  return found;
};

export class Why {
  constructor(app, name) {
    Object.assign(this, {app, name, devices: new Set(), symbols: new Set(), timer: null, last: 0, abort: new AbortController(), shown: ""});
    this.at = make("span", {class: "soft"});
    this.text = make("div", {class: "why-text"}, "...");
    this.tree = make("ul", {class: "why-tree"});
    this.element = make("section", {class: "why", "aria-label": "Why"},
      make("div", {class: "row"}, make("h3", {}, "Why"), this.at, make("span", {class: "grow"}), button("Ask again", () => this.ask(), {class: "small"})),
      this.text, this.tree);
    this.ask();
  }

  close() {
    clearTimeout(this.timer);
    this.abort.abort();
  }

  change({all, devices, symbols, keys}) {
    if (this.timer !== null) return;
    const changed = all || keys.has("malfunctions") || keys.has("acts") || devices.some((index) => this.devices.has(index))
      || symbols.some((index) => this.symbols.has(index));
    if (!changed) return;
    this.timer = setTimeout(() => this.ask(), Math.max(0, this.last + kPause - performance.now()));
  }

  tick() {
    const {clock, lost} = this.app;
    if (this.timer === null && clock.runs && !lost && performance.now() - this.last > kOldest) this.ask();
  }

  async ask() {
    clearTimeout(this.timer);
    this.timer = 0;  // one question at a time
    this.last = performance.now();
    try {
      const answer = await this.app.api.why(this.name, this.abort.signal);
      setText(this.at, "at " + instant(this.app.clock.now()));
      this.show(answer);
    } catch (error) {
      if (error.name !== "AbortError") this.text.replaceChildren(make("span", {class: "wrong"}, error.message));
    }
    this.timer = null;
  }

  show(answer) {
    const text = JSON.stringify(answer);
    if (text === this.shown) return;
    this.shown = text;
    const trees = answer.trees ?? [];
    const own = this.app.names.find(this.name);
    this.devices = new Set();
    this.symbols = new Set();
    for (const [kind, name] of trees.flatMap((tree) => namesIn(tree))) {
      const thing = this.app.names.find(name);
      if (kind === "device" && thing?.kind === "device") this.devices.add(thing.index);
      if (kind === "symbol" && thing?.kind === "symbol") this.symbols.add(thing.index);
    }
    if (own?.kind === "device") this.follow(own.index);
    if (own?.kind === "symbol") this.symbols.add(own.index);
    const focused = this.focusedLink();
    const sentence = trees[0]?.sentence ?? answer.text;
    this.text.title = sentence;
    this.text.replaceChildren(...linked(this.app, sentence).flat());
    this.tree.replaceChildren(...(trees[0]?.because ?? []).map((cause) => this.node(cause, 1)),
      ...trees.slice(1).map((tree) => this.node(tree, 1)));
    if (focused !== null) [...this.element.querySelectorAll("a")].filter(({hash}) => hash === focused.hash)[focused.rank]?.focus();
  }

  /// The link that has the focus, as { hash, rank } among those that lead to the same thing, or null.
  focusedLink() {
    const link = document.activeElement;
    if (link?.tagName !== "A" || !this.element.contains(link)) return null;
    const {hash} = link;
    return {hash, rank: [...this.element.querySelectorAll("a")].filter((other) => other.hash === hash).indexOf(link)};
  }

  follow(device) {
    const {operations, events} = this.app.plant.devices[device];
    this.devices.add(device);
    for (const {symbol} of operations) this.symbols.add(symbol);
    for (const symbol of events) this.symbols.add(symbol);
  }

  node(cause, depth) {
    const {app} = this;
    const text = linked(app, cause.sentence).flat();
    for (const [kind, name] of (cause.about ?? []).flatMap((about) => Object.entries(about))) {
      const thing = app.names.find(name);
      if (!thing || cause.sentence.includes(name) || !(kind in kLinks)) continue;
      text.push(" (", kLinks[kind](app, thing.index), ")");
    }
    const because = depth < kMostDeep ? cause.because ?? [] : [];
    return make("li", {title: cause.sentence}, text, because.length > 0 ? make("ul", {}, because.map((next) => this.node(next, depth + 1))) : null);
  }
}
