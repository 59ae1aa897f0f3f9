// The camera and the graphics of the 3D view: draws a scene onto a canvas, finds what is under the pointer.
import {BoxGeometry, Color, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Math as Mathematics, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer} from "../build/three.module.js";
import {OrbitControls} from "../three/OrbitControls.js";
import {Labels} from "./labels.js";
import {reducedMotion} from "../theme.js";
import {overviewOf} from "./overview.js";
import {kRest, Pace} from "./pace.js";

const kFlight = 600;  // ms from one camera to another
const kNear = 36;     // pixels that a unit has on the screen, for its name to be shown
const kInside = .95;  // of the half picture: what is farther out is not seen well
const kMost = 90;     // names at once

/// Whether the graphics are computed by the processor: then fewer pixels are drawn.
const isSoftware = (gl) => {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  return /swiftshader|llvmpipe|software|basic render/i.test(info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : "");
};

export class Stage {
  /// `changed()` asks for a frame. `textOf(device)`: its name and status, see statusLabel().
  constructor(canvas, changed, textOf) {
    Object.assign(this, {canvas, changed, textOf, flight: null, isWhole: false, content: null, size: [0, 0, 1], unit: 1, pace: new Pace(), sharpness: 1});
    this.renderer = new WebGLRenderer({canvas, antialias: false, stencil: false, powerPreference: "high-performance"});
    this.software = isSoftware(this.renderer.getContext());
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(30, 1, .1, 1000);
    this.controls = new OrbitControls(this.camera, canvas);
    Object.assign(this.controls, {enableKeys: false, maxPolarAngle: Math.PI * .495, screenSpacePanning: false});
    this.controls.addEventListener("change", changed);
    canvas.addEventListener("webglcontextrestored", changed);
    this.controls.addEventListener("start", () => Object.assign(this, {flight: null, isWhole: false}));
    this.labels = new Labels();
    this.outline = new Group();
    this.scene.add(this.labels.mesh, this.outline);
  }

  /// `content`: see Boxes and Model.
  setContent(content) {
    if (this.content && this.content !== content) {
      this.scene.remove(this.content.root);
      this.content.dispose();
    }
    this.content = content;
    this.scene.add(content.root);
    this.labels.clear();
    this.scene.background = new Color(...content.colors.back);
    const {min, max} = content.bounds();
    this.span = Math.max(1e-3, Math.hypot(...max.map((value, i) => value - min[i])));
    Object.assign(this.controls, {minDistance: this.span / 300, maxDistance: this.span * 5});
    this.unit = content.unit ?? 1;
  }

  /// A camera from which everything is seen: { from, to }.
  overview() { return overviewOf(this.content.bounds(), this.camera.fov, this.camera.aspect, this.content.slope); }

  /// Everything, also after the picture got another size, until the camera is moved.
  showAll(atOnce = false) {
    this.goTo(this.overview(), atOnce);
    this.isWhole = true;
  }

  /// To a camera { from, to }, with a flight unless motion is unwanted or `atOnce`, or there is no camera yet from which to fly.
  goTo({from, to}, atOnce = false) {
    this.isWhole = false;
    const [position, target] = [new Vector3(...from), new Vector3(...to)];
    const canFly = [...this.camera.position.toArray(), ...this.controls.target.toArray()].every(Number.isFinite);
    if (atOnce || !canFly || reducedMotion.matches) {
      this.flight = null;
      this.camera.position.copy(position);
      this.controls.target.copy(target);
      this.controls.update();
      return this.changed();
    }
    this.flight = {begin: performance.now(), from: this.camera.position.clone(), target: this.controls.target.clone(), position, to: target};
    this.changed();
  }

  fly() {
    if (!this.flight) return false;
    const {begin, from, target, position, to} = this.flight;
    const part = Math.min(1, (performance.now() - begin) / kFlight);
    const smooth = part * part * (3 - 2 * part);
    this.camera.position.lerpVectors(from, position, smooth);
    this.controls.target.lerpVectors(target, to, smooth);
    this.controls.update();
    if (part === 1) this.flight = null;
    return part < 1;
  }

  /// Degrees about the target: to the side, and up.
  turn(side, up) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    const flat = Math.hypot(arm.x, arm.z);
    const angle = Math.atan2(arm.x, arm.z) + side * Math.PI / 180;
    const height = Mathematics.clamp(Math.atan2(arm.y, flat) + up * Math.PI / 180, .01, Math.PI / 2 - .01);
    const length = arm.length();
    arm.set(Math.sin(angle) * Math.cos(height), Math.sin(height), Math.cos(angle) * Math.cos(height)).multiplyScalar(length);
    this.goTo({from: this.controls.target.clone().add(arm).toArray(), to: this.controls.target.toArray()}, true);
  }

  /// Along the floor, in parts of the distance.
  pan(right, ahead) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    const forward = new Vector3(-arm.x, 0, -arm.z).normalize();
    const by = forward.clone().multiplyScalar(ahead).add(new Vector3(-forward.z, 0, forward.x).multiplyScalar(right)).multiplyScalar(arm.length());
    this.goTo({from: this.camera.position.clone().add(by).toArray(), to: this.controls.target.clone().add(by).toArray()}, true);
  }

  zoom(factor) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    arm.setLength(Mathematics.clamp(arm.length() * factor, this.controls.minDistance, this.controls.maxDistance));
    this.goTo({from: this.controls.target.clone().add(arm).toArray(), to: this.controls.target.toArray()}, true);
  }

  /// To a point if it is not in the picture, from the same side and as far away.
  reveal(point) {
    const to = new Vector3(...point);
    this.camera.updateMatrixWorld();
    const at = to.clone().project(this.camera);
    if (Math.abs(at.x) < kInside && Math.abs(at.y) < kInside && at.z < 1) return;
    const from = this.camera.position.clone().sub(this.controls.target).add(to);
    this.goTo({from: from.toArray(), to: point});
  }

  /// The tag of what is at a point of the page; null: nothing.
  pick(x, y) {
    const box = this.canvas.getBoundingClientRect();
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((x - box.left) / box.width * 2 - 1, 1 - (y - box.top) / box.height * 2), this.camera);
    const [hit] = ray.intersectObjects(this.content.targets, true);
    return hit ? this.content.tagOf(hit) : null;
  }

  /// Lines around { center, size, turn }, or around nothing.
  setOutline(around) {
    for (const line of [...this.outline.children]) {
      this.outline.remove(line);
      line.geometry.dispose();
    }
    if (!around) return;
    const line = new LineSegments(new EdgesGeometry(new BoxGeometry(...around.size)), new LineBasicMaterial({color: new Color(...this.content.colors.accent), depthTest: false}));
    line.position.set(...around.center);
    line.rotation.y = -around.turn * Math.PI / 180;
    line.renderOrder = 9;
    this.outline.add(line);
  }

  /// Fits the picture to its element, and to how fast frames are. An element that is not shown has no size: then the picture stays as it is.
  fit() {
    const [wide, high] = [this.canvas.parentElement.clientWidth, this.canvas.parentElement.clientHeight];
    if (wide === 0 || high === 0) return;
    const ratio = this.software ? Math.min(1, devicePixelRatio) * this.sharpness : Math.min(2, devicePixelRatio);
    const isResized = wide !== this.size[0] || high !== this.size[1];
    if (!isResized && ratio === this.size[2]) return;
    this.size = [wide, high, ratio];
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(wide, high, true);
    this.camera.aspect = wide / high;
    this.camera.updateProjectionMatrix();
    if (isResized && this.isWhole) this.showAll(true);
  }

  /// Names that are near enough, the nearest first; all that are not `near` before them.
  nameList() {
    const at = new Vector3();
    const perUnit = this.size[1] / (2 * Math.tan(this.camera.fov * Math.PI / 360)) * this.unit;
    const seen = [];
    for (const label of this.content.names()) {
      if (label.near && label.device !== this.named && perUnit / this.camera.position.distanceTo(at.set(label.x, label.y, label.z)) < kNear) continue;
      at.set(label.x, label.y, label.z).applyMatrix4(this.camera.matrixWorldInverse);
      const depth = -at.z;
      if (depth < this.camera.near) continue;
      at.applyMatrix4(this.camera.projectionMatrix);
      if (Math.abs(at.x) < 1.1 && Math.abs(at.y) < 1.1) seen.push({...label, ...(label.device === undefined ? {} : this.textOf(label.device)), depth, screenX: at.x * this.size[0] / 2, screenY: at.y * this.size[1] / 2});
    }
    return seen.sort((a, b) => Boolean(a.near) - Boolean(b.near) || a.depth - b.depth).slice(0, kMost);
  }

  render() {
    if (this.software) {
      clearTimeout(this.rest);
      this.sharpness = this.pace.ratio(performance.now());
      if (this.sharpness < 1) this.rest = setTimeout(this.changed, kRest);
      this.fit();
    }
    const distance = this.camera.position.distanceTo(this.controls.target);
    Object.assign(this.camera, {near: distance / 40, far: distance + this.span * 2});
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    this.labels.show(this.nameList(), this.camera, this.size[1]);
    this.renderer.render(this.scene, this.camera);
  }

  dispose() {
    clearTimeout(this.rest);
    this.setOutline(null);
    this.content?.dispose();
    this.labels.dispose();
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
