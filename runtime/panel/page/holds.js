// What is held: a push button or a jog is on until it is let go. What was switched on is switched off again, whatever becomes of the
// button, the page or the connection; until the plant has confirmed that, the page says that it is still pressed.
import {showResult} from "./acts.js";

const kPause = 1000;  // ms between two tries to release
const kKept = "symplant held";
const kDenied = [401, 403, 409];  // a further try would be answered in the same way

const text = (name) => name + " is still pressed";

export class Holds {
  /// `notice` shows what is still pressed; `storage` keeps it while the page is loaded again.
  constructor(app, notice, storage) {
    Object.assign(this, {app, notice, storage, held: new Map(), released: new Map(), waiting: new Set()});
    this.changed = () => {};  // called with the name of what changed its phase
  }

  /// Lets go when the pointer or key is let go anywhere, the window loses the focus, or the page is hidden or closed.
  listen(page) {
    for (const type of ["pointerup", "pointercancel"]) page.addEventListener(type, ({pointerId}) => this.endBy("pointer " + pointerId));
    page.addEventListener("keyup", ({code}) => this.endBy("key " + code));
    page.addEventListener("blur", ({target}) => { if (target === page) this.endAll(); });
    page.document.addEventListener("visibilitychange", () => { if (page.document.hidden) this.endAll(); });
    page.addEventListener("pagehide", () => this.farewell());
  }

  /// What is held, or was released last: { entry, at }, `at` is null or the time of its release. undefined before the first time.
  last(name) { return this.held.has(name) ? {entry: this.held.get(name), at: null} : this.released.get(name); }

  /// "": not held; "pressing", "held", "releasing", or "stuck": the release is not confirmed.
  phase(name) { return this.held.get(name)?.phase ?? ""; }

  /// Holds `{ name, on, off, result }`: the acts that switch it on and off, and where their result is shown. `by`: what holds it,
  /// as in listen(). Pressed again while its release is under way, it follows that. Resolves when it is released.
  async begin(hold, by) {
    const before = this.held.get(hold.name);
    if (before && before.phase !== "releasing") return;
    const entry = {...hold, by};
    entry.over = new Promise((done) => { entry.end = done; });
    if (before) before.next = entry;
    else await this.run(entry);
  }

  async run(entry) {
    this.held.set(entry.name, entry);
    this.keep();
    if (await this.press(entry)) {
      await entry.over;
      await this.release(entry);
    }
    this.forget(entry);
    if (entry.next) await this.run(entry.next);
  }

  endIf(matches) {
    for (const entry of this.held.values()) for (const of of [entry, entry.next]) if (of && matches(of)) of.end();
  }
  end(name) { this.endIf((entry) => entry.name === name); }
  endBy(by) { this.endIf((entry) => entry.by === by); }
  endAll() { this.endIf(() => true); }

  enter(entry, phase) {
    entry.phase = phase;
    this.changed(entry.name);
  }

  /// Returns whether it must be released: it is on, or it may be, since no answer came.
  async press(entry) {
    this.enter(entry, "pressing");
    try {
      if (this.app.lost) throw new Error("there is no connection to the plant: nothing was done");
      await this.app.api.acts(entry.on);
      this.enter(entry, "held");
      return true;
    } catch (error) {
      this.show(entry, error.status === 401 ? this.app.deniedText : error.message, true);
      if (error.status === 0) entry.end();
      return error.status === 0;
    }
  }

  /// Tries until the plant has done it, or denies it.
  async release(entry) {
    this.enter(entry, "releasing");
    for (;;) {
      try {
        await this.app.api.acts(entry.off);
        if (entry.isSaid) this.show(entry, entry.name + " is released");
        return this.notice.show("held " + entry.name, "");
      } catch (error) {
        const isDenied = kDenied.includes(error.status);
        if (!entry.isSaid || isDenied) this.notice.show("held " + entry.name, text(entry.name) + ": " + error.message, isDenied);
        if (!entry.isSaid) this.show(entry, text(entry.name), true);
        entry.isSaid = true;
        entry.next = null;  // not pressed at a time that no person expects
        this.enter(entry, "stuck");
        if (isDenied) return;
        await this.pause();
      }
    }
  }

  pause() {
    return new Promise((done) => {
      const go = () => {
        this.waiting.delete(go);
        done();
      };
      this.waiting.add(go);
      setTimeout(go, kPause);
    });
  }

  /// What waits for a try to release tries at once.
  connected() { for (const go of this.waiting) go(); }

  /// The connection is lost: nothing is held any longer.
  disconnected() { this.endAll(); }

  forget(entry) {
    this.held.delete(entry.name);
    this.released.set(entry.name, {entry, at: performance.now()});
    this.keep();
    this.changed(entry.name);
  }

  show({result}, ...shown) { if (result) showResult(result, ...shown); }

  /// Remembers what is held over a new load of the page.
  keep() {
    const kept = [...this.held.values()].map(({name, off}) => ({name, off}));
    if (kept.length === 0) this.storage.removeItem(kKept);
    else this.storage.setItem(kKept, JSON.stringify({run: this.app.api.run, kept}));
  }

  /// Releases what was held when the page was closed.
  async recover() {
    const {run, kept} = JSON.parse(this.storage.getItem(kKept) ?? "{}");
    if (run !== this.app.api.run) return this.storage.removeItem(kKept);
    await Promise.all(kept.map(async (of) => {
      const entry = {...of, end: () => {}};
      this.held.set(entry.name, entry);
      await this.release(entry);
      this.forget(entry);
    }));
  }

  /// The page is closed: the browser sends the release afterward.
  farewell() {
    this.endAll();
    if (this.held.size > 0) this.app.api.leave(...[...this.held.values()].map(({off}) => off).flat());
  }
}
