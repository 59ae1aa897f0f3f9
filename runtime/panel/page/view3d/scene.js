// What the 3D view loads when it is opened: the scene, kept up to date with the plant.
import {Boxes} from "./boxes.js";
import {statusLabel} from "./colors.js";
import {listenToScene} from "./keys.js";
import {loadModel} from "./model.js";
import {describe} from "../plan/pick.js";
import {Stage} from "./stage.js";
import {onTheme} from "../theme.js";

export class View3dScene {
  /// `page`: `say(text)` shows a sentence, or removes it; `toggled(on)`: translucent or not; `announce(text)`: what has the focus.
  constructor(app, canvas, page) {
    Object.assign(this, {app, page, dirty: true, isTranslucent: false, drawn: 0, focused: null, marked: null});
    this.stage = new Stage(canvas, () => this.changed(), (device) => statusLabel(app, device));
    this.ends = [app.layout.listen(() => this.rebuild()), onTheme(() => this.rebuild())];
    this.observer = new ResizeObserver(() => this.changed());
    this.observer.observe(canvas.parentElement);
    listenToScene(canvas, this);
  }

  showBoxes() {
    this.stage.fit();
    this.setContent(new Boxes(this.app, this.app.layout.placed));
    this.stage.showAll(true);
  }

  /// Instead of boxes, if there is one.
  async showModel() {
    const {model} = this.app.plant.view3d ?? {};
    if (!model) return;
    try {
      this.page.say("The model " + model + " is loaded ...");
      const content = await loadModel(this.app, model);
      this.page.say("");
      this.stage.fit();
      this.setContent(content);
      this.stage.showAll(true);
    } catch (error) {
      this.page.say("The model " + model + " cannot be shown: " + error.message + ". Boxes are shown instead.");
    }
  }

  setContent(content) {
    this.stage.setContent(content);
    content.setTranslucent(this.isTranslucent);
    this.select();
    this.changed();
  }

  /// After a change of the layout or the colors.
  rebuild() {
    const {content} = this.stage;
    if (content instanceof Boxes) this.setContent(new Boxes(this.app, this.app.layout.placed));
    else {
      content.recolor();
      this.setContent(content);
    }
    if (this.stage.isWhole) this.stage.showAll(true);
  }

  changed() {
    this.dirty = true;
    this.app.frames.request();
  }

  select() {
    const selection = this.app.router.selection();
    const index = selection && ["device", "location"].includes(selection.kind) ? this.app.names.index(selection.kind, selection.name) : null;
    const tag = index === null ? null : {kind: selection.kind, index};
    this.stage.content.select(tag);
    if (tag?.kind === "device") this.focused = index;
    this.mark(tag);
  }

  /// The outline, and the name of a device, stay with what is selected or has the focus.
  mark(tag) {
    this.marked = tag;
    this.stage.named = tag?.kind === "device" ? tag.index : null;
    this.stage.setOutline(tag && this.stage.content.outline(tag));
    this.changed();
  }

  /// The focus to the next (1) or previous (-1) device that the view shows.
  step(by) {
    const count = this.app.plant.devices.length;
    let index = this.focused ?? (by > 0 ? -1 : count);
    for (let tries = 0; tries < count; ++tries) {
      index = (index + by + count) % count;
      const around = this.stage.content.outline({kind: "device", index});
      if (!around) continue;
      this.focused = index;
      this.mark({kind: "device", index});
      this.stage.reveal(around.center);
      return this.page.announce(describe(this.app, this.app.layout.placed, this.marked));
    }
  }

  openFocused() { if (this.focused !== null) this.app.router.select("device", this.app.names.name("device", this.focused)); }

  /// What changed while another view was shown.
  refresh() {
    this.stage.content.touchAll();
    this.select();
  }

  pick(x, y) {
    const tag = this.stage.pick(x, y);
    if (tag) this.app.router.select(tag.kind, this.app.names.name(tag.kind, tag.index));
  }

  setTranslucent(on) {
    this.isTranslucent = on;
    this.stage.content.setTranslucent(on);
    this.page.toggled(on);
    this.changed();
  }

  /// A camera of plant.json by its name; "": everything.
  goTo(name, atOnce = false) {
    const camera = name === "" ? null : this.app.plant.view3d?.cameras?.[name];
    if (camera) this.stage.goTo(camera, atOnce);
    else this.stage.showAll(atOnce);
  }

  change({all, devices, symbols, tracks, places, values}, statusChanged) {
    const {content} = this.stage;
    if (all) content.touchAll();
    else for (const device of new Set([...statusChanged, ...devices])) content.touch(device);
    if (all || devices.length + symbols.length + tracks.length + places.length + values.length + statusChanged.size > 0) this.dirty = true;
  }

  /// Draws if something changed or moves; returns whether something moves on.
  frame(now) {
    this.stage.fit();
    const flies = this.stage.fly();
    const moves = this.stage.content.draw(now);
    if (this.dirty || flies || moves) {
      this.dirty = false;
      this.drawn += 1;
      if (moves && this.marked) this.stage.setOutline(this.stage.content.outline(this.marked));
      this.stage.render();
    }
    return flies || (moves && this.app.clock.runs);
  }

  dispose() {
    for (const end of this.ends) end();
    this.observer.disconnect();
    this.stage.dispose();
  }
}
