// The messages of the trainer, in every view until they are closed in this browser.
import {button, make} from "./dom.js";
import {instant} from "./words.js";

const kKey = "symplant messages";
const kMostShown = 3;

/// The numbers of the messages that were closed, of this run.
export class ClosedMessages {
  constructor(run, storage = sessionStorage) {
    Object.assign(this, {run, storage});
    const kept = JSON.parse(storage.getItem(kKey) ?? "null");
    this.numbers = new Set(kept?.run === run ? kept.numbers : []);
  }

  has(n) { return this.numbers.has(n); }

  /// Those that the plant has forgotten need not be kept: `first` is the oldest number that it has.
  add(numbers, first) {
    this.numbers = new Set([...this.numbers, ...numbers].filter((n) => n >= first));
    this.storage.setItem(kKey, JSON.stringify({run: this.run, numbers: [...this.numbers]}));
  }
}

/// Messages that are not closed: the newest first, and how many more there are.
export const openMessages = (messages, closed) => {
  const open = messages.filter(({n}) => !closed.has(n)).reverse();
  return {shown: open.slice(0, kMostShown), more: open.slice(kMostShown)};
};

export class MessageBand {
  constructor(app) {
    Object.assign(this, {app, closed: new ClosedMessages(app.plant.run)});
    this.element = make("div", {class: "messages", role: "log", "aria-label": "Messages of the trainer", "aria-live": "assertive", "aria-relevant": "additions"});
    this.lines = new Map();  // number -> element
  }

  close(numbers) {
    this.closed.add(numbers, this.app.store.messages[0]?.n ?? 0);
    this.update();
    this.app.main.focus();
  }

  line({n, t, text}) {
    return make("div", {class: "row message"}, make("span", {class: "lines grow"}, make("strong", {}, "Trainer at " + instant(t) + ": "), text),
      button("✕", () => this.close([n]), {class: "tiny", "aria-label": "Close the message " + text.slice(0, 40)}));
  }

  /// A line that stays is not made again: a screen reader would read it again.
  update() {
    const {shown, more} = openMessages(this.app.store.messages, this.closed);
    const numbers = new Set(shown.map(({n}) => n));
    for (const [n, line] of this.lines) {
      if (numbers.has(n)) continue;
      line.remove();
      this.lines.delete(n);
    }
    for (const message of [...shown].reverse()) {
      if (this.lines.has(message.n)) continue;
      this.lines.set(message.n, this.line(message));
      this.element.prepend(this.lines.get(message.n));
    }
    this.rest?.remove();
    this.rest = more.length === 0 ? null : make("div", {class: "row"}, make("span", {class: "soft grow"}, more.length + " earlier"),
      button("Close all", () => this.close([...shown, ...more].map(({n}) => n)), {class: "small"}));
    if (this.rest) this.element.append(this.rest);
  }

  change(change) {
    if (change.all || change.keys.has("messages")) this.update();
  }
}
