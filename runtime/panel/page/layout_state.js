// The layout that all see: the positions that were given, and where everything is. A new revision in the stream is loaded at once.
import {layOut} from "./plan_layout.js";

export class LayoutState {
  constructor(app) {
    Object.assign(this, {app, plan: {}, revision: null, asked: null, listeners: new Set(), found: null});
  }

  /// The result of layOut() for the plan.
  get placed() { return this.found ??= layOut(this.app.plant, this.plan); }

  /// `listener()` is called after each new layout. Returns what ends it.
  listen(listener) {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /// After an event of the stream.
  change({all, keys}) {
    const {layout} = this.app.store;
    if ((all || keys.has("layout")) && layout !== this.revision && layout !== this.asked) this.load(layout);
  }

  async load(revision) {
    this.asked = revision;
    try {
      const {plan, revision: got} = await this.app.api.layout();
      this.revision = got;
      this.set(plan);
    } finally {
      this.asked = null;
    }
  }

  set(plan) {
    Object.assign(this, {plan, found: null});
    for (const listener of this.listeners) listener();
  }
}
