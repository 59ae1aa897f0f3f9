// The layout that all see: the positions that were given, and where everything is. A new revision in the stream is loaded at once.
import {layOut} from "./layout.js";

const kAgain = 2000;  // ms until a layout that did not come is asked for again

export class LayoutState {
  /// `again`: ms until a layout that did not come is asked for again.
  constructor(app, again = kAgain) {
    Object.assign(this, {app, again, plan: {}, revision: undefined, isLoading: false, timer: null, listeners: new Set(), found: null});
  }

  /// The result of layOut() for the plan.
  get placed() { return this.found ??= layOut(this.app.plant, this.plan); }

  /// `listener()` is called after each new layout. Returns what ends it.
  listen(listener) {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /// After an event of the stream.
  change({all, keys}) { if (all || keys.has("layout")) this.follow(); }

  /// Whether the layout is that of the stream. A recording has no revision: its layout is loaded once.
  isCurrent() {
    const {layout} = this.app.store;
    return this.revision !== undefined && (layout === null || layout <= this.revision);
  }

  /// Loads layouts, one after the other, until it is that of the stream.
  async follow() {
    if (this.isLoading) return;
    clearTimeout(this.timer);
    this.isLoading = true;
    for (let asked; !this.isCurrent() && asked !== this.app.store.layout;) {
      asked = this.app.store.layout;
      if (!await this.load()) break;
    }
    this.isLoading = false;
    if (!this.isCurrent()) this.timer = setTimeout(() => this.follow(), this.again);
  }

  /// Asks for the layout. An answer that is older than what is shown is dropped. Returns whether there was one.
  async load() {
    try {
      const {revision, plan} = await this.app.api.layout();
      if (this.revision === undefined || revision > this.revision) {
        this.revision = revision;
        this.set(plan);
      }
      return true;
    } catch {
      return false;
    }
  }

  set(plan) {
    Object.assign(this, {plan, found: null});
    for (const listener of this.listeners) listener();
  }
}
