// Edits the layout: things are dragged, turned and grouped, on the grid. Others see it once it is saved.
import {layOut} from "./layout.js";
import {devicesOf, groupDevices, moveThings, operatorsOf, snap, turnThings, wholePlan} from "./change.js";
import {EditBar} from "./edit_bar.js";
import {button} from "../dom.js";
import {boxOf, pick, thingsOf} from "./pick.js";

const kMostSteps = 100;  // that can be undone
const kKeyStep = .5;
const kArrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
const kMeanwhile = "Another layout was saved meanwhile: Cancel shows it, a second Save replaces it.";
const kKinds = ["device", "location", "frame"];

const keyOf = ({kind, index}) => kind + index;

export class PlanEdit {
  /// Only a trainer with a valid token changes what all see.
  static isPossible(app) { return app.canAct && app.plant.role === "trainer"; }

  constructor(app, view) {
    Object.assign(this, {app, view, isOn: false, isSaving: false, revision: undefined, plan: {}, kept: new Map(), done: [], undone: [], saved: "{}", selected: new Map(), band: null});
    this.button = button("Edit layout", () => this.begin());
    this.panel = new EditBar(app, this);
    this.bar = this.panel.element;
    addEventListener("beforeunload", (event) => { if (this.isOn && this.isChanged()) event.preventDefault(); });
  }

  begin() {
    Object.assign(this, {isOn: true, revision: this.app.layout.revision, done: [], undone: [], saved: JSON.stringify(this.app.layout.plan), selected: new Map()});
    this.set(this.app.layout.plan, new Map());
    this.panel.show(true);
    this.button.hidden = true;
    this.view.board.focus();
  }

  /// Ends the edit without a question.
  end() {
    this.isOn = false;
    this.panel.show(false);
    this.button.hidden = false;
    this.view.note("");
    this.view.place();
  }

  /// The layout that all see is no longer the one on which the edit is based. While a save waits for its answer it may be that of the edit.
  newer() { if (!this.isSaving && this.app.layout.revision !== this.revision) this.view.note(kMeanwhile); }

  isChanged() { return JSON.stringify(this.plan) !== this.saved; }

  /// Shows a plan. `kept`: where operated symbols stay, see layOut().
  set(plan, kept) {
    Object.assign(this, {plan, kept, placed: layOut(this.app.plant, plan, kept)});
    this.view.place();
    this.panel.update();
  }

  /// What undo returns to.
  now() { return {plan: this.plan, kept: this.kept}; }

  /// A step that can be undone. `from`: what was before it.
  apply(plan, kept, from = this.now()) {
    if (this.isSaving) return;
    this.done = [...this.done, from].slice(-kMostSteps);
    this.undone = [];
    this.set(plan, kept);
  }

  /// A step from the plan with the position of everything.
  change(plan) { this.apply(plan, operatorsOf(this.placed)); }

  undo() { this.step(this.done, this.undone); }
  redo() { this.step(this.undone, this.done); }

  step(from, to) {
    if (from.length === 0 || this.isSaving) return;
    to.push(this.now());
    const {plan, kept} = from.pop();
    this.set(plan, kept);
  }

  things() { return [...this.selected.values()]; }

  /// The plan with the position of everything.
  whole() { return wholePlan(this.app.plant, this.placed, this.plan); }

  move(dx, dy) { this.change(moveThings(this.app.plant, this.placed, this.whole(), this.things(), dx, dy)); }
  turn() { if (this.selected.size > 0) this.change(turnThings(this.app.plant, this.whole(), this.things())); }

  group(name) {
    this.change(groupDevices(this.app.plant, this.placed, this.whole(), devicesOf(this.placed, this.things()), name));
    this.select([]);
  }

  /// Back to the layout that the plant itself has; the picture behind it stays.
  automatic() {
    this.apply(this.plan.background ? {background: this.plan.background} : {}, new Map());
    this.select([]);
    this.view.whole();
  }

  setBackground(background) {
    const {background: _, ...rest} = this.plan;
    this.apply(background ? {...rest, background} : rest, this.kept);
  }

  select(things) {
    this.selected = new Map(things.map((thing) => [keyOf(thing), thing]));
    this.panel.update();
    this.view.mark();
  }

  /// What a pointer takes: a thing, or the head of a frame.
  takes(point) {
    const thing = pick(this.app.plant, this.placed, point);
    if (thing?.kind === "frame") return point[1] < this.placed.frames[thing.index].y + 1 ? thing : null;
    if (thing?.kind === "symbol") return null;
    return thing;
  }

  clicked(point, {shiftKey}) {
    const thing = this.takes(point);
    if (!thing) return shiftKey ? null : this.select([]);
    if (!shiftKey) return this.select([thing]);
    const rest = this.things().filter((other) => keyOf(other) !== keyOf(thing));
    this.select(rest.length < this.selected.size ? rest : [...rest, thing]);
  }

  /// A drag moves what is selected; on nothing it is a rubber band.
  grab(point, {shiftKey}) {
    const thing = this.takes(point);
    if (!thing) return this.rubber(point, shiftKey ? this.things() : []);
    let before = null;
    let whole = null;
    let start = null;
    let kept = null;
    return {
      move: (to) => {
        if (this.isSaving) return;
        if (before === null) {
          if (!this.selected.has(keyOf(thing))) this.select([thing]);
          [before, whole, start, kept] = [this.now(), this.whole(), this.placed, operatorsOf(this.placed)];
        }
        this.set(moveThings(this.app.plant, start, whole, this.things(), snap(to[0] - point[0]), snap(to[1] - point[1])), kept);
      },
      end: () => { if (before !== null) this.apply(this.plan, kept, before); },
    };
  }

  rubber(from, kept) {
    return {
      move: (to) => {
        this.band = {x: Math.min(from[0], to[0]), y: Math.min(from[1], to[1]), w: Math.abs(to[0] - from[0]), h: Math.abs(to[1] - from[1])};
        const {x, y, w, h} = this.band;
        const found = thingsOf(this.placed).filter(({kind, at}) => kKinds.includes(kind) && at[0] >= x && at[0] <= x + w && at[1] >= y && at[1] <= y + h);
        this.select([...kept, ...found]);
      },
      end: () => {
        this.band = null;
        this.view.mark();
      },
    };
  }

  /// Returns whether the key was for the edit.
  key(event) {
    if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z") event.shiftKey ? this.redo() : this.undo();
    else if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "y") this.redo();
    else if (event.ctrlKey || event.metaKey || event.altKey) return false;
    else if (event.key === "r" || event.key === "R") this.turn();
    else if (event.key === "Escape") this.select([]);
    else if ((event.key === "Enter" || event.key === " ") && this.view.focused && kKinds.includes(this.view.focused.kind)) this.toggle(this.view.focused, event.shiftKey);
    else if (event.key in kArrows && this.selected.size > 0 && !event.shiftKey) this.move(...kArrows[event.key].map((part) => part * kKeyStep));
    else return false;
    event.preventDefault();
    return true;
  }

  toggle(thing, adds) {
    const rest = this.things().filter((other) => keyOf(other) !== keyOf(thing));
    this.select([...(adds || rest.length < this.selected.size ? rest : []), ...(rest.length < this.selected.size ? [] : [{kind: thing.kind, index: thing.index}])]);
  }

  /// Outlines of what is selected, and the rubber band.
  draw(context) {
    if (!this.isOn) return;
    for (const thing of this.things()) this.view.outline(context, boxOf(this.placed, thing), 3);
    if (!this.band) return;
    context.setLineDash([4, 3]);
    this.view.outline(context, this.band, 1);
    context.setLineDash([]);
  }
}
