// The plan: stations, devices, tracks and places as they are to each other, with the parts that move on them. Drawn on three canvases: what stays, what follows
// the plant, and what marks the selection.
import {button, make, select, setAttribute, setText} from "../dom.js";
import {kindLegend} from "../kinds.js";
import {Background} from "./background.js";
import {Camera} from "./camera.js";
import {drawStill, kNear} from "./draw.js";
import {PlanEdit} from "./edit.js";
import {PlanInput} from "./input.js";
import {PlanLive} from "./live.js";
import {boxOf, describe, nameOf, nextThing, pick, thingsOf} from "./pick.js";
import {openPicture} from "./picture.js";
import {rank} from "../status.js";
import {fitCanvas, onTheme, theme} from "../theme.js";

const kAround = 6;    // grid units around what was selected elsewhere
const kPause = 250;  // ms between two drawings of frames for their statuses

export class PlanView {
  constructor(app) {
    Object.assign(this, {app, title: "Plan", camera: new Camera(), focused: null, stillDirty: true, overDirty: true, lastStill: 0, shownStation: ""});
    this.live = new PlanLive(app, this.camera);
    this.canvases = ["still", "live", "over"].map((name) => make("canvas", {"aria-hidden": "true", class: name}));
    this.noted = make("p", {class: "note", hidden: true, onclick: () => this.note("")});
    this.said = make("div", {class: "hidden-text", role: "status"});
    this.board = make("div", {class: "board", role: "application", tabindex: 0, "aria-label": "Plan of the plant",
      "aria-description": "Arrow keys move between devices, tracks and places, Enter opens the details, + and - zoom, 0 shows the whole plant."}, this.canvases);
    this.pictureNote = make("p", {class: "note", role: "alert", hidden: true});
    this.background = new Background(app, openPicture, {loaded: () => this.moved(), failed: (text) => this.noPicture(text)});
    this.edit = PlanEdit.isPossible(app) ? new PlanEdit(app, this) : null;
    this.element = make("div", {class: "view fills plan-view"}, this.makeTools(), this.edit?.bar ?? null, this.noted, this.pictureNote, this.board, this.said);
    this.input = new PlanInput(this.board, this);
    this.board.addEventListener("keydown", (event) => this.key(event));
    this.board.addEventListener("focus", () => this.say());
    this.board.addEventListener("blur", () => this.mark());
    new ResizeObserver(() => this.resize()).observe(this.board);
    onTheme(() => this.moved());
    app.layout.listen(() => this.edit?.isOn ? this.edit.newer() : this.place());
    app.planView = this;  // for tests and the console
    this.place();
  }

  makeTools() {
    const {plant} = this.app;
    this.choice = select("Station", [["", "All stations"], ...plant.stations.map(({name}) => [name, name])],
      {onchange: () => this.app.router.view("plan", this.choice.value ? {station: this.choice.value} : {})});
    const zoom = (label, text, act) => button(text, () => {
      act();
      this.moved();
    }, {"aria-label": label, title: label});
    return make("div", {class: "row tools"}, plant.stations.length > 1 ? this.choice : null,
      make("span", {class: "row", role: "group", "aria-label": "Zoom"}, zoom("Further away", "−", () => this.camera.step(-1)), zoom("Closer", "+", () => this.camera.step(1)),
        zoom("Whole plant", "Whole plant", () => this.toWhole())), this.edit?.button ?? null, kindLegend(plant));
  }

  /// Shows a text above the plan; a click removes it.
  note(text) {
    this.noted.hidden = text === "";
    setText(this.noted, text);
  }

  /// Shows why there is no picture behind the plan, until it is there; "" for none.
  noPicture(text) {
    this.pictureNote.hidden = text === "";
    this.pictureNote.replaceChildren(...(text === "" ? [] : [text + " ", button("Try again", () => this.background.load()), button("Close", () => this.noPicture(""))]));
  }

  /// The layout that is shown: while it is edited, that of the editor.
  get placed() { return this.edit?.isOn ? this.edit.placed : this.app.layout.placed; }
  get plan() { return this.edit?.isOn ? this.edit.plan : this.app.layout.plan; }

  /// After a new layout.
  place() {
    this.live.place(this.placed);
    this.background.show(this.plan.background);
    this.things = thingsOf(this.placed);
    if (this.camera.isWhole && !this.edit?.isOn) this.whole();
    this.moved();
  }

  resize() {
    const {clientWidth, clientHeight} = this.board;
    if (clientWidth === 0 || (clientWidth === this.camera.wide && clientHeight === this.camera.high)) return;
    Object.assign(this.camera, {wide: clientWidth, high: clientHeight});
    this.contexts = this.canvases.map((canvas) => fitCanvas(canvas, clientWidth, clientHeight));
    if (this.camera.isWhole || this.goal) this.aim();
    this.moved();
  }

  /// Shows the station of the address, or all.
  aim() {
    this.goal = this.placed.frames.find(({name}) => name === this.shownStation) ?? null;
    if (this.goal) this.camera.show({x: this.goal.x - .5, y: this.goal.y - .5, w: this.goal.w + 1, h: this.goal.h + 1});
    else this.whole();
  }

  whole() { this.camera.whole(this.placed.bounds); }

  /// From a station, too.
  toWhole() {
    if (this.shownStation !== "") this.app.router.view("plan");
    else this.whole();
  }

  show({station = ""}) {
    if (this.shownStation !== station) {
      this.shownStation = station;
      this.choice.value = station;
      this.aim();
    }
    this.focusSelected();
    this.moved();
  }

  /// What was selected elsewhere has the focus, and is near enough to be read.
  focusSelected() {
    const selection = this.app.router.selection();
    const index = selection && ["device", "symbol", "location"].includes(selection.kind) ? this.app.names.index(selection.kind, selection.name) : null;
    if (index === null || !boxOf(this.placed, {kind: selection.kind, index})) return;
    if (this.focused?.kind === selection.kind && this.focused.index === index) return;
    const box = boxOf(this.placed, {kind: selection.kind, index});
    if (this.camera.scale < kNear && selection.kind !== "location") this.camera.show({x: box.x - kAround, y: box.y - kAround, w: box.w + 2 * kAround, h: box.h + 2 * kAround}, kNear);
    this.focus({kind: selection.kind, index});
  }

  focus(thing) {
    this.focused = thing;
    if (this.camera.follow(boxOf(this.placed, thing))) this.moved();
    this.mark();
    this.say();
  }

  say() { if (this.focused && document.activeElement === this.board) setText(this.said, describe(this.app, this.placed, this.focused)); }

  /// After the view moved, or everything must be drawn again.
  moved() {
    this.stillDirty = true;
    this.live.touchAll();
    this.mark();
  }

  /// The selection, the focus or what is edited changed.
  mark() {
    this.overDirty = true;
    this.app.frames.request();
  }

  change(change, statusChanged) {
    this.live.change(change, statusChanged);
    if (change.all || statusChanged.size > 0) this.statusDirty = true;
    if (this.focused && this.focused.kind === "device" && change.devices.includes(this.focused.index)) this.say();
    this.app.frames.request();
  }

  clicked(point, event) {
    if (this.edit?.isOn) return this.edit.clicked(point, event);
    const thing = pick(this.app.plant, this.placed, point);
    if (thing && (thing.kind !== "frame" || point[1] < this.placed.frames[thing.index].y + 1)) this.open(thing);
  }

  /// Shows the details of a thing, or a station.
  open(thing) {
    this.focused = thing;
    if (thing.kind === "frame") {
      const {station, name} = this.placed.frames[thing.index];
      if (station !== null) this.app.router.view("plan", {station: name});
    } else this.app.router.select(thing.kind, nameOf(this.app, this.placed, thing));
  }

  hovered(point) {
    const thing = pick(this.app.plant, this.placed, point);
    const name = thing ? nameOf(this.app, this.placed, thing) : null;
    const comment = thing?.kind === "device" ? this.app.names.commentOf(this.app.plant.devices[thing.index]) : thing?.kind === "symbol" ? this.app.plant.symbols[thing.index].comment : "";
    setAttribute(this.board, "title", name && [describe(this.app, this.placed, thing), comment].filter((text) => text).join("\n"));
    this.board.classList.toggle("on-thing", thing !== null && thing.kind !== "frame");
  }

  grab(point, event) { return this.edit?.isOn ? this.edit.grab(point, event) : null; }

  key(event) {
    if (event.defaultPrevented || this.edit?.isOn && this.edit.key(event)) return;
    if (event.key === "Enter" && this.focused) this.open(this.focused);
    else if (event.key.startsWith("Arrow") && this.things.length > 0) this.focus(nextThing(this.things, this.focused, event.key));
    else return;
    event.preventDefault();
  }

  statusOf({station, devices}) {
    const {statuses} = this.app;
    if (station !== null && devices.length > 0) return statuses.worst(statuses.stations[station]);
    return devices.length === 0 ? null : devices.reduce((worst, device) => Math.max(worst, statuses.of[device]), rank.rest);
  }

  drawStill(wall) {
    this.stillDirty = this.statusDirty = false;
    this.lastStill = wall;
    drawStill(this.contexts[0], this.camera, {plant: this.app.plant, placed: this.placed, background: this.background.shown(), statusOf: (frame) => this.statusOf(frame)});
  }

  /// The outline of what is selected and of what has the focus.
  drawOver() {
    this.overDirty = false;
    const context = this.contexts[2];
    context.clearRect(0, 0, this.camera.wide, this.camera.high);
    if (this.focused && (document.activeElement === this.board || this.app.router.selection())) this.outline(context, boxOf(this.placed, this.focused), 2);
    this.edit?.draw(context);
  }

  outline(context, {x, y, w, h}, wide) {
    const [left, top] = this.camera.toScreen([x, y]);
    context.strokeStyle = theme().accent;
    context.lineWidth = wide;
    context.strokeRect(left - 2, top - 2, w * this.camera.scale + 4, h * this.camera.scale + 4);
  }

  /// Returns whether something moves on.
  frame(now) {
    if (!this.contexts) return false;
    const wall = performance.now();
    if (this.stillDirty || (this.statusDirty && wall - this.lastStill > kPause)) this.drawStill(wall);
    const again = this.live.draw(this.contexts[1], now);
    if (this.overDirty) this.drawOver();
    return Boolean(this.statusDirty) || (again && this.app.clock.runs);
  }
}

