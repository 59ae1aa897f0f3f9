// The line at the bottom with the last finding, and what screen readers say of findings: politely, and not too often.
import {make, setText} from "./dom.js";
import {linkTo} from "./links_to.js";
import {count, instant, withRoundTimes} from "./words.js";

const kPause = 4000;

export class Announcer {
  /// `footer` is seen; `live` is a region for screen readers.
  constructor(app, footer, live) {
    Object.assign(this, {app, live, said: null, timer: null});
    this.count = make("a", {href: "#view=findings"});
    this.subject = make("span", {class: "cut-subject"});
    this.text = make("span", {class: "cut grow"});
    footer.append(this.count, this.subject, this.text);
  }

  last() { return this.app.store.findings[this.app.store.findings.length - 1]; }

  change(change) {
    if (!change.all && !change.keys.has("findings")) return;
    const last = this.last();
    setText(this.count, last ? count(last.n + 1, "finding") : "no findings");
    setText(this.text, last ? instant(last.t) + ": " + withRoundTimes(last.text) : "");
    this.text.title = last?.text ?? "";
    const found = last ? this.app.names.find(last.of) : null;
    this.subject.replaceChildren(...(found ? [linkTo(found.kind, last.of)] : []));
    if (this.said === null || change.all) this.said = last ? last.n : -1;
    else if (last && last.n > this.said && this.timer === null) this.timer = setTimeout(() => this.say(), 200);
  }

  say() {
    const last = this.last();
    const fresh = last.n - this.said;
    this.said = last.n;
    this.live.textContent = (fresh > 1 ? fresh + " findings, the last: " : "Finding: ") + withRoundTimes(last.text);
    this.timer = setTimeout(() => {
      this.timer = null;
      if (this.last() && this.last().n > this.said) this.say();
    }, kPause);
  }
}
