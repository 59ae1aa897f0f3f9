// The plant in 3D with a GLB model: its nodes move and have the colors of the devices and values to which they are bound; parts are boxes.
import {Box3, DirectionalLight, Group, HemisphereLight, MeshLambertMaterial, Vector3} from "../build/three.module.js";
import {motionOf} from "../plan/motion.js";
import {GLTFLoader} from "../three/GLTFLoader.js";
import {checkGlb} from "./glb_check.js";
import {cleanGlb} from "./glb_clean.js";
import {nodeAt, treeOf} from "./binding.js";
import {Bound} from "./bound.js";
import {litColor, mixed, sceneColors, statusColor} from "./colors.js";
import {ModelParts} from "./model_parts.js";
import {BoundNode} from "./node.js";
import {kLit} from "./shapes.js";

/// A loaded and bound model; an Error says what is wrong with it.
export const loadModel = async (app, name) => {
  const blob = await app.api.file("files/" + encodeURIComponent(name));
  const file = checkGlb(await blob.arrayBuffer());
  const loaded = await new Promise((done, fail) => new GLTFLoader().parse(cleanGlb(file), "", done, (error) => fail(new Error("its data cannot be read: " + error.message))));
  return new Model(app, loaded.scene, await loaded.parser.getDependencies("node"), treeOf(file.json));
};

export class Model {
  constructor(app, scene, objects, tree) {
    Object.assign(this, {app, root: new Group(), slope: .6, selected: null, materials: new Map(), bound: [], nodes: new Map(), parts: []});
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
    const {nodes} = this;
    for (const [key, entry] of Object.entries(this.app.plant.view3d.nodes ?? {})) {
      const object = objects[nodeAt(tree, entry.node)];
      if (!nodes.has(object)) nodes.set(object, new BoundNode(object));
      const bound = new Bound(this.app, key, entry, nodes.get(object));
      nodes.get(object).bounds.push(bound);
      this.bound.push(bound);
    }
    for (const node of nodes.values()) node.own((object) => nodes.get(object));
    this.parts = this.bound.filter(({location}) => location !== null).map((bound) => new ModelParts(this.app, bound.location, bound.entry, bound.node.object));
    this.tags = [...this.bound.filter(({device}) => device !== null).map(({device, node}) => ({kind: "device", index: device, node})),
      ...this.bound.filter(({location}) => location !== null).map(({location, node}) => ({kind: "location", index: location, node}))];
    this.tagOfObject = new Map([...this.tags].reverse().map((tag) => [tag.node.object, tag]));  // of two the first
    for (const {location, parts} of this.parts) this.tagOfObject.set(parts.mesh, this.tags.find(({kind, index}) => kind === "location" && index === location));
    this.ofDevice = new Map(this.bound.filter(({device}) => device !== null).map(({device, node}) => [device, node]));
    this.colored = [...nodes.values()].filter(({bounds}) => bounds.some(({entry}) => entry.color?.by));
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

  paint(node) { node.paint((device) => this.colorOf(device)); }

  touch(index) {
    const node = this.ofDevice.get(index);
    if (node) this.paint(node);
  }

  touchAll() { for (const node of this.nodes.values()) this.paint(node); }

  /// Moves what has moved until plant time `now`; returns whether something moves on.
  draw(now) {
    let again = false;
    for (const node of this.nodes.values()) again = node.move(now) || again;
    for (const parts of this.parts) again = parts.draw(now, this.colors) || again;
    for (const node of this.colored) this.paint(node);
    return again || [...this.ofDevice.keys()].some((device) => this.app.store.moves(device));
  }

  names() {
    return this.tags.map(({kind, index, node}) => {
      const box = node.worldBox();
      const [x, , z] = box.getCenter(new Vector3()).toArray();
      const text = kind === "device" ? {device: index} : {key: "location " + index, text: this.app.plant.locations[index].name};
      return Object.assign(text, {near: true, x, y: box.max.y, z});
    });
  }

  /// { center, size, turn } of a device, track or place; null: the model has none.
  outline({kind, index}) {
    const found = this.tags.find((tag) => tag.kind === kind && tag.index === index);
    if (!found) return null;
    const box = found.node.worldBox();
    return {center: box.getCenter(new Vector3()).toArray(), size: box.getSize(new Vector3()).addScalar(.03).toArray(), turn: 0};
  }

  tagOf({object}) {
    for (let at = object; at; at = at.parent) if (this.tagOfObject.has(at)) return this.tagOfObject.get(at);
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
