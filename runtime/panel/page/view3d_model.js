// The plant in 3D with a GLB model: its nodes move and have the colors of the devices and values to which they are bound; parts are boxes.
import {Box3, DirectionalLight, Group, HemisphereLight, MeshLambertMaterial, Vector3} from "./build/three.module.js";
import {motionOf} from "./plan_motion.js";
import {GLTFLoader} from "./three/GLTFLoader.js";
import {checkGlb} from "./glb_check.js";
import {cleanGlb} from "./glb_clean.js";
import {nodeAt, treeOf} from "./view3d_binding.js";
import {Bound} from "./view3d_bound.js";
import {litColor, mixed, sceneColors, statusColor} from "./view3d_colors.js";
import {ModelParts} from "./view3d_model_parts.js";
import {kLit} from "./view3d_shapes.js";

/// A loaded and bound model; an Error says what is wrong with it.
export const loadModel = async (app, name) => {
  const blob = await app.api.file("files/" + encodeURIComponent(name));
  const file = checkGlb(await blob.arrayBuffer());
  const loaded = await new Promise((done, fail) => new GLTFLoader().parse(cleanGlb(file), "", done, (error) => fail(new Error("its data cannot be read: " + error.message))));
  return new Model(app, loaded.scene, await loaded.parser.getDependencies("node"), treeOf(file.json));
};

export class Model {
  constructor(app, scene, objects, tree) {
    Object.assign(this, {app, root: new Group(), slope: .6, selected: null, materials: new Map(), bound: []});
    this.targets = [scene];
    scene.updateMatrixWorld(true);
    this.box = new Box3().setFromObject(scene);
    this.root.add(scene, new HemisphereLight(0xffffff, 0x9a9a9a, .7), new DirectionalLight(0xffffff, .33));
    this.root.children[2].position.set(.35, .85, .4);
    scene.traverse((object) => { if (object.isMesh) object.material = this.simple(object.material); });
    this.bind(objects, tree);
    this.unit = this.box.getSize(new Vector3()).length() / 12;  // a device is about so large, for names
    this.recolor();
  }

  /// Materials without reflections: fast, and metal is not black.
  simple(material) {
    if (!this.materials.has(material)) {
      const {color, map, side, transparent, opacity, vertexColors} = material;
      this.materials.set(material, new MeshLambertMaterial({color, map, side, transparent, opacity, vertexColors}));
    }
    return this.materials.get(material);
  }

  bind(objects, tree) {
    const {names, plant} = this.app;
    for (const [key, entry] of Object.entries(plant.view3d.nodes ?? {})) {
      const bound = new Bound(this.app, key, entry, objects[nodeAt(tree, entry.node)], names.index("device", key));
      const location = bound.device === null ? names.index("location", key) : null;
      if (location !== null && entry.from) bound.parts = new ModelParts(this.app, location, entry, bound.object);
      this.bound.push(bound);
    }
    const nodes = new Set(this.bound.map(({object}) => object));
    for (const each of this.bound) if (!each.parts) each.own((object) => nodes.has(object));
    this.tags = new Map(this.bound.flatMap(({device, parts, object}) => device !== null ? [[object, {kind: "device", index: device}]]
      : parts ? [[object, {kind: "location", index: parts.location}]] : []));
    this.ofDevice = new Map(this.bound.filter(({device}) => device !== null).map((each) => [each.device, each]));
    this.colored = this.bound.filter(({entry}) => entry.color?.by);
  }

  recolor() {
    this.colors = sceneColors();
    this.colors.back = mixed(this.colors.back, this.colors.line, .5);  // so that white machines are seen
    this.touchAll();
  }

  bounds() { return {min: this.box.min.toArray(), max: this.box.max.toArray()}; }

  /// Of a device: that of its status, else that of a lamp that is on.
  colorOf(index) {
    const {store, statuses, plant} = this.app;
    const isOn = kLit.has(plant.devices[index].shape) && motionOf(store, index, store.t).on;
    return statusColor(statuses.of[index]) ?? (isOn ? litColor(plant.devices[index]) : null);
  }

  touch(index) { this.ofDevice.get(index)?.paint(this.colorOf(index)); }

  touchAll() {
    for (const each of this.bound) each.paint(each.device === null ? null : this.colorOf(each.device));
  }

  /// Moves what has moved until plant time `now`; returns whether something moves on.
  draw(now) {
    let again = false;
    for (const each of this.bound) {
      again = each.move(now) || again;
      if (each.parts) again = each.parts.draw(now, this.colors) || again;
      again ||= each.device !== null && this.app.store.moves(each.device);
    }
    for (const each of this.colored) each.paint(null);
    return again;
  }

  names() {
    return this.bound.filter(({object}) => this.tags.has(object)).map(({device, parts, object}) => {
      const box = new Box3().setFromObject(object);
      const [x, , z] = box.getCenter(new Vector3()).toArray();
      const text = device !== null ? {device} : {key: "location " + parts.location, text: this.app.plant.locations[parts.location].name};
      return Object.assign(text, {near: true, x, y: box.max.y, z});
    });
  }

  /// { center, size, turn } of a device, track or place; null: the model has none.
  outline({kind, index}) {
    const found = [...this.tags].find(([, tag]) => tag.kind === kind && tag.index === index);
    if (!found) return null;
    const box = new Box3().setFromObject(found[0]);
    return {center: box.getCenter(new Vector3()).toArray(), size: box.getSize(new Vector3()).addScalar(.03).toArray(), turn: 0};
  }

  tagOf({object}) {
    for (let at = object; at; at = at.parent) if (this.tags.has(at)) return this.tags.get(at);
    return null;
  }

  select(tag) {
    this.selected = tag;
    this.setTranslucent(this.isTranslucent);
  }

  /// All but what moves, parts and the selection.
  setTranslucent(on) {
    this.isTranslucent = on;
    for (const material of this.materials.values()) {
      material.kept ??= {transparent: material.transparent, opacity: material.opacity};
      Object.assign(material, on ? {transparent: true, opacity: .2, depthWrite: false} : {...material.kept, depthWrite: true}, {needsUpdate: true});
    }
  }

  dispose() {
    this.root.traverse((object) => {
      object.geometry?.dispose();
      object.material?.map?.dispose();
      object.material?.dispose();
    });
  }
}
