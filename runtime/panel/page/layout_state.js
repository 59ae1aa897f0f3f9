// The layout that all see: the positions that were given, and where everything is. A new revision in the stream is loaded at once.
import {layOut} from "./plan_layout.js";

export class LayoutState {
  constructor(app) {
    Object.assign(this, {app, plan: {}, revision: undefined, asked: undefined, listeners: new Set(), found: null});
  }

  /// The result of layOut() for the plan.
  get placed() { return this.found ??= layOut(this.app.plant, this.plan); }

  /// `listener()` is called after each new layout. Returns what ends it.
  listen(listener) {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /// After an event of the stream. A recording has no revision: its layout is loaded once.
  change({all, keys}) {
    const {layout} = this.app.store;
    if ((all || keys.has("layout")) && layout !== this.revision && layout !== this.asked) this.load(layout);
  }

  async load(revision) {
    this.asked = revision;
    try {
      const {plan} = await this.app.api.layout();
      this.revision = revision;
      this.set(plan);
    } catch {
      // The layout stays as it is; the next picture of the stream asks again.
    } finally {
      this.asked = undefined;
    }
  }

  set(plan) {
    Object.assign(this, {plan, found: null});
    for (const listener of this.listeners) listener();
  }
}
