// The plant in 3D. What draws it is loaded when the view is first opened.
import {actButton, resultOutput} from "../acts.js";
import {button, make, select, setText} from "../dom.js";
import {kView3dLabel} from "./keys.js";

const kNoWebGl = "This browser shows no 3D: WebGL is off or missing. ";
const kFailed = "The 3D view cannot be shown: ";
const kOverview = "Overview";

const hasWebGl = () => {
  const context = document.createElement("canvas").getContext("webgl");
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return context !== null;
};

export class View3d {
  constructor(app) {
    Object.assign(this, {app, scene: null, loading: false, lastCamera: null, sent: null});
    this.message = make("p", {class: "soft", role: "status"});
    this.said = make("div", {class: "hidden-text", role: "status"});
    this.stage = make("div", {class: "stage3d"});
    this.result = resultOutput();
    this.camera = select("Camera", [["", kOverview], ...Object.keys(app.plant.view3d?.cameras ?? {}).map((name) => [name, name])],
      {onchange: () => this.scene?.goTo(this.camera.value)});
    const step = (label, text, act) => button(label, () => this.scene && act(this.scene), {"aria-label": text, title: text});
    this.see = button("See through", () => this.scene?.setTranslucent(!this.scene.isTranslucent), {class: "toggle", "aria-pressed": "false", title: "Housings become translucent (t)"});
    this.tools = make("div", {class: "row tools"}, this.camera,
      app.canAct ? actButton(app, this.result, "For everyone", () => ({camera: this.sent = this.camera.value}), {title: "Show this view to everyone who looks at the plant in 3D"}) : null,
      step("+", "Nearer", (scene) => scene.stage.zoom(1 / 1.25)), step("−", "Farther", (scene) => scene.stage.zoom(1.25)),
      step("⟲", "Turn left", (scene) => scene.stage.turn(-15, 0)), step("⟳", "Turn right", (scene) => scene.stage.turn(15, 0)),
      step("▲", "Move ahead", (scene) => scene.stage.pan(0, .1)), step("▼", "Move back", (scene) => scene.stage.pan(0, -.1)),
      step("◀", "Move left", (scene) => scene.stage.pan(-.1, 0)), step("▶", "Move right", (scene) => scene.stage.pan(.1, 0)),
      button("Show everything", () => this.scene?.goTo(""), {title: "0"}), this.see, app.canAct ? this.result : null);
    this.element = make("div", {class: "view fills view3d"}, this.tools, this.message, this.stage, this.said);
  }

  show() {
    if (!this.scene) return this.loading || this.load();
    this.scene.refresh();
    this.follow();
  }

  async load() {
    this.loading = true;
    setText(this.message, "The 3D view is loaded ...");
    this.setShown(true);
    if (!hasWebGl()) return this.fail(kNoWebGl);
    try {
      const {View3dScene} = await import("./scene.js");
      const canvas = make("canvas", {tabindex: 0, role: "application", "aria-label": kView3dLabel});
      this.stage.replaceChildren(canvas);
      this.scene = new View3dScene(this.app, canvas, {say: (text) => setText(this.message, text), announce: (text) => setText(this.said, text),
        toggled: (on) => this.see.setAttribute("aria-pressed", String(on))});
      this.app.view3d = this.scene;  // for tests and the console
      setText(this.message, "");
      this.scene.showBoxes();
      this.follow();
      await this.scene.showModel();
      this.follow(true);
    } catch (error) {
      this.fail(kFailed + error.message + ". ");
    }
  }

  setShown(on) { for (const each of [this.tools, this.stage]) each.hidden = !on; }

  /// Says why there is no 3D. It is tried again when the view is next shown.
  fail(text) {
    this.scene?.dispose();
    this.scene = this.app.view3d = null;
    this.loading = false;
    this.stage.replaceChildren();
    this.setShown(false);
    setText(this.message, text);
    this.message.append(make("a", {href: "#view=plan"}, "See the plant as a plan"));
  }

  /// To the trainer's camera, if it is another one than the last time.
  follow(again = false) {
    const {camera} = this.app.store;
    if (!this.scene || !camera || (camera.n === this.lastCamera && !again)) return;
    this.lastCamera = camera.n;
    const isOwn = camera.name === this.sent;
    this.sent = null;
    if (isOwn && this.camera.value !== camera.name) return;  // this page has chosen another one since it sent that one
    this.camera.value = camera.name;
    this.scene.goTo(camera.name);
  }

  change(change, statusChanged) {
    if (!this.scene) return;
    this.scene.change(change, statusChanged);
    this.follow();
  }

  frame(now) { return this.scene?.frame(now) ?? false; }
}
