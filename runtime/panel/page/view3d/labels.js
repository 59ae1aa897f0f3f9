// Names that face the camera: all in one call. Their texts are drawn into one picture when they are first seen; when it is full, those that are
// not seen make room.
import {BufferAttribute, BufferGeometry, CanvasTexture, DynamicDrawUsage, LinearFilter, Mesh, MeshBasicMaterial, Vector3} from "../build/three.module.js";
import {kFont, theme} from "../theme.js";

const [kWide, kHigh, kColumns, kRows] = [256, 32, 4, 32];  // pixels of a text, and how many are in the picture
export const kMostLabels = kColumns * kRows;
const kLetterWide = 32;

/// Two boxes around their middles.
const overlaps = (a, b) => Math.abs(a.x - b.x) * 2 < a.wide + b.wide && Math.abs(a.y - b.y) * 2 < a.high + b.high;

/// A picture with a slot for each text.
class Atlas {
  constructor() {
    this.canvas = Object.assign(document.createElement("canvas"), {width: kWide * kColumns, height: kHigh * kRows});
    this.context = this.canvas.getContext("2d");
    this.texture = new CanvasTexture(this.canvas);
    Object.assign(this.texture, {minFilter: LinearFilter, generateMipmaps: false});
    this.slots = new Map();  // by text
    this.free = Array.from({length: kMostLabels}, (_, i) => i);
  }

  /// The slot of a text: { index, wide }; null if there is no room. `isSeen(text)`: its slot cannot be taken.
  slot(label, isSeen) {
    const found = this.slots.get(label.key);
    if (found) return found;
    if (this.free.length === 0) for (const [key, {index}] of this.slots) if (!isSeen(key)) {
      this.slots.delete(key);
      this.free.push(index);
    }
    if (this.free.length === 0) return null;
    const slot = {index: this.free.pop(), wide: 0};
    slot.wide = this.draw(label, slot.index % kColumns * kWide, Math.floor(slot.index / kColumns) * kHigh);
    this.slots.set(label.key, slot);
    this.texture.needsUpdate = true;
    return slot;
  }

  draw({text, letter, color, strong}, x, y) {
    const {context} = this;
    const colors = theme();
    context.clearRect(x, y, kWide, kHigh);
    context.font = (strong ? "bold " : "") + "22px " + kFont;
    context.textBaseline = "middle";
    context.textAlign = "left";
    const room = kWide - (letter ? kLetterWide : 0) - 12;
    let shown = text;
    while (context.measureText(shown).width > room && shown.length > 1) shown = shown.slice(0, -2) + "…";
    const wide = Math.min(kWide - 1, Math.ceil(context.measureText(shown).width) + 12 + (letter ? kLetterWide : 0));
    context.fillStyle = colors.back;
    context.globalAlpha = .82;
    context.fillRect(x, y, wide, kHigh);
    context.globalAlpha = 1;
    context.fillStyle = colors.text;
    context.fillText(shown, x + 6 + (letter ? kLetterWide : 0), y + kHigh / 2 + 1);
    if (!letter) return wide;
    context.fillStyle = color;
    context.fillRect(x, y, kLetterWide - 4, kHigh);
    context.fillStyle = colors.back;
    context.textAlign = "center";
    context.font = "bold 20px " + kFont;
    context.fillText(letter, x + kLetterWide / 2 - 2, y + kHigh / 2 + 1);
    return wide;
  }
}

export class Labels {
  constructor() {
    this.atlas = new Atlas();
    const geometry = new BufferGeometry();
    this.positions = new BufferAttribute(new Float32Array(kMostLabels * 12), 3).setUsage(DynamicDrawUsage);
    this.uvs = new BufferAttribute(new Float32Array(kMostLabels * 8), 2).setUsage(DynamicDrawUsage);
    geometry.setAttribute("position", this.positions);
    geometry.setAttribute("uv", this.uvs);
    geometry.setIndex(Array.from({length: kMostLabels}, (_, i) => [0, 1, 2, 0, 2, 3].map((corner) => i * 4 + corner)).flat());
    this.mesh = new Mesh(geometry, new MeshBasicMaterial({map: this.atlas.texture, transparent: true, depthTest: false, depthWrite: false}));
    Object.assign(this.mesh, {frustumCulled: false, renderOrder: 10});
  }

  /// `labels` are { key, text, letter, color, strong, x, y, z, screenX, screenY }, the most important first; each is `size` pixels high on the screen, and none is over another one.
  show(labels, camera, height, size = 18) {
    const seen = new Set(labels.map(({key}) => key));
    const e = camera.matrixWorld.elements;
    const perPixel = 2 * Math.tan(camera.fov * Math.PI / 360) / height;
    const at = new Vector3();
    const taken = [];
    let count = 0;
    for (const label of labels) {
      const slot = count < kMostLabels ? this.atlas.slot(label, (key) => seen.has(key)) : null;
      if (!slot) break;
      const box = {x: label.screenX, y: label.screenY, wide: slot.wide * size / kHigh + 4, high: size + 2};
      if (taken.some((other) => overlaps(box, other))) continue;
      taken.push(box);
      const depth = -at.set(label.x, label.y, label.z).applyMatrix4(camera.matrixWorldInverse).z;
      const half = perPixel * depth * size / 2;
      this.quad(count++, label, [e[0], e[1], e[2]], [e[4], e[5], e[6]], half * slot.wide / kHigh, half, slot);
    }
    this.mesh.geometry.setDrawRange(0, count * 6);
    this.positions.needsUpdate = true;
    this.uvs.needsUpdate = true;
  }

  quad(i, {x, y, z}, right, up, wide, high, slot) {
    [[-1, -1], [1, -1], [1, 1], [-1, 1]].forEach(([a, b], corner) => {
      this.positions.array.set([0, 1, 2].map((k) => [x, y, z][k] + right[k] * wide * a + up[k] * high * b), i * 12 + corner * 3);
      const u = (slot.index % kColumns * kWide + (a > 0 ? slot.wide - 1 : 1)) / (kWide * kColumns);
      const v = 1 - (Math.floor(slot.index / kColumns) * kHigh + (b > 0 ? 1 : kHigh - 1)) / (kRows * kHigh);
      this.uvs.array.set([u, v], i * 8 + corner * 2);
    });
  }

  /// After a change of colors.
  clear() {
    this.atlas.slots.clear();
    this.atlas.free = Array.from({length: kMostLabels}, (_, i) => i);
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.atlas.texture.dispose();
  }
}
