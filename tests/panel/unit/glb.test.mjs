// A GLB file is checked before a loader sees it: each thing that is refused, and hostile files.
import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {test} from "node:test";
import {fileURLToPath} from "node:url";
import {checkGlb, kMostBytes} from "../../../runtime/panel/page/view3d/glb_check.js";
import {cleanGlb, cleanJson, packGlb} from "../../../runtime/panel/page/view3d/glb_clean.js";
import {sizeOfPicture} from "../../../runtime/panel/page/view3d/glb_images.js";
import {jpegOf, pack, pngOf, smallModel} from "./glb.mjs";

const kExamples = join(dirname(fileURLToPath(import.meta.url)), "../../../examples");
const readExample = (path) => {
  const bytes = readFileSync(join(kExamples, path));
  return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
};

/// Fails unless the small model, changed, is refused with these words.
const refused = (words, change) => {
  const model = smallModel();
  const changed = change(model);
  assert.throws(() => checkGlb(changed instanceof ArrayBuffer ? changed : pack(model)), (error) => error.constructor === Error && words.test(error.message), String(words));
};
const setUint32 = (at, value) => (model) => {
  const buffer = pack(model);
  new DataView(buffer).setUint32(at, value, true);
  return buffer;
};
const chain = (count) => Array.from({length: count}, (_, i) => i + 1 < count ? {children: [i + 1]} : {mesh: 0});

test("A valid model is accepted, and the bounds of its positions are those of its data", () => {
  const model = smallModel();
  Object.assign(model.json.accessors[0], {min: [9, 9, 9], max: ["x"]});
  const {json} = checkGlb(pack(model));
  assert.deepEqual([json.accessors[0].min, json.accessors[0].max], [[0, 0, 0], [1, 2, 0]]);
});

test("The models of the examples are accepted, and small", () => {
  for (const path of ["cell/cell.glb", "harbour-crane/crane.glb"]) {
    const buffer = readExample(path);
    assert.ok(buffer.byteLength < 60000, path);
    checkGlb(buffer);
  }
});

test("A file that is cut off, or is no GLB file, is refused", () => {
  refused(/not a GLB file/, () => new ArrayBuffer(0));
  refused(/not a GLB file/, () => new TextEncoder().encode("<svg>a picture, not a model</svg>").buffer);
  for (let size = 0; size < pack(smallModel()).byteLength; ++size) refused(/./, (model) => pack(model).slice(0, size));
  refused(/version 1 of GLB/, setUint32(4, 1));
  refused(/32 MiB/, () => new ArrayBuffer(kMostBytes + 4));
});

test("Chunks that overlap, are too long or not aligned are refused", () => {
  refused(/header says 4,294,967,295 bytes/, setUint32(8, 0xFFFFFFFF));
  refused(/chunk of 4,294,967,292 bytes/, setUint32(12, 0xFFFFFFFC));
  refused(/chunk of 5 bytes/, setUint32(12, 5));
  refused(/chunk/, setUint32(12, 8));  // the second chunk would be in the first one
  refused(/not JSON/, setUint32(16, 1));
  refused(/last chunk is cut off/, (model) => {
    const whole = new Uint8Array(pack(model).byteLength + 4);
    whole.set(new Uint8Array(pack(model)));
    new DataView(whole.buffer).setUint32(8, whole.length, true);
    return whole.buffer;
  });
});

test("JSON that is not valid, too deep or too large for numbers is refused", () => {
  const withText = (text) => () => {
    const bytes = new TextEncoder().encode(text.padEnd(Math.ceil(text.length / 4) * 4));
    const buffer = packGlb({}, new Uint8Array(0));
    const whole = new Uint8Array(20 + bytes.length);
    whole.set(new Uint8Array(buffer).subarray(0, 20));
    whole.set(bytes, 20);
    const view = new DataView(whole.buffer);
    view.setUint32(8, whole.length, true);
    view.setUint32(12, bytes.length, true);
    return whole.buffer;
  };
  refused(/JSON has 17,000,012 bytes/, withText("{\"x\":" + " ".repeat(17000005)));
  refused(/JSON is not valid/, withText("{\"asset\":"));
  refused(/not an object/, withText("[]"));
  refused(/nested more than 64/, withText("[".repeat(100000) + "]".repeat(100000)));
  refused(/not finite/, withText("{\"asset\":{\"version\":\"2.0\"},\"x\":[1e999]}"));
  refused(/__proto__/, withText("{\"asset\":{\"version\":\"2.0\"},\"x\":{\"__proto__\":{}}}"));
  refused(/asset.version/, ({json}) => { json.asset.version = "1.0"; });
  refused(/asset.version/, ({json}) => { delete json.asset; });
  refused(/`nodes` are not a list/, ({json}) => { json.nodes = {length: 3}; });
  refused(/`nodes` are not all objects/, ({json}) => { json.nodes[2] = null; });
  const model = smallModel();
  model.json.extras = "\"" + "[".repeat(100);  // a text is not nested
  checkGlb(pack(model));
});

test("Extensions that are required and not known are refused, others are ignored", () => {
  refused(/needs the extension `KHR_draco_mesh_compression`/, ({json}) => { json.extensionsRequired = ["KHR_materials_unlit", "KHR_draco_mesh_compression"]; });
  const model = smallModel();
  model.json.extensionsUsed = ["KHR_lights_punctual", "X"];
  checkGlb(pack(model));
});

test("Data outside of the file is refused", () => {
  refused(/another file/, ({json}) => { json.buffers[0].uri = "http://example.com/x.bin"; });
  refused(/in another file/, ({json}) => { json.images[0].uri = "data:image/png;base64,AAAA"; });
  refused(/2 buffers/, ({json}) => { json.buffers.push({byteLength: 1}); });
  refused(/buffer has 1000 bytes/, ({json}) => { json.buffers[0].byteLength = 1000; });
  for (const change of [{byteOffset: -4}, {byteOffset: 60}, {byteLength: 1e9}, {byteLength: -1}, {byteOffset: .5}, {buffer: 1}, {buffer: undefined}, {byteLength: "36"}]) {
    refused(/buffer view 0 is outside/, ({json}) => { Object.assign(json.bufferViews[0], change); });
  }
  for (const byteStride of [3, 2, 256, 6, "12"]) refused(/invalid stride/, ({json}) => { json.bufferViews[0].byteStride = byteStride; });
});

test("Accessors with huge counts, negative offsets or unknown types are refused", () => {
  const accessor = (words, change) => refused(words, ({json}) => { Object.assign(json.accessors[0], change); });
  accessor(/outside of its buffer view/, {count: 4});
  accessor(/outside of its buffer view/, {count: 4294967295});
  accessor(/outside of its buffer view/, {byteOffset: 4});
  accessor(/invalid offset/, {byteOffset: -12});
  accessor(/not aligned/, {byteOffset: 1});
  accessor(/invalid count/, {count: 0});
  accessor(/invalid count/, {count: 1.5});
  accessor(/unknown type/, {componentType: 5130});
  accessor(/unknown type/, {type: "VEC9"});
  accessor(/not supported/, {type: "MAT4"});
  accessor(/not supported/, {sparse: {count: 1}});
  accessor(/has no data/, {bufferView: undefined});
  accessor(/has no data/, {bufferView: 99});
  refused(/not aligned/, ({json}) => { json.bufferViews[0].byteStride = 8; });
});

test("Positions that are not finite or far away are refused, and indices of vertices that are not there", () => {
  for (const number of [NaN, Infinity, -Infinity, 1e30]) {
    refused(/not finite, or too large, in POSITION/, ({bin}) => { new DataView(bin.buffer).setFloat32(16, number, true); });
  }
  refused(/index 3 of 3 vertices/, ({bin}) => { bin[38] = 3; });
  refused(/invalid indices/, ({json}) => { json.meshes[0].primitives[0].indices = 0; });
  refused(/invalid indices/, ({json}) => { json.meshes[0].primitives[0].indices = 9; });
  refused(/no positions/, ({json}) => { json.meshes[0].primitives[0].attributes = {}; });
  refused(/no positions/, ({json}) => { json.meshes[0].primitives[0] = null; });
  refused(/unknown mode/, ({json}) => { json.meshes[0].primitives[0].mode = 7; });
  refused(/morph targets/, ({json}) => { json.meshes[0].primitives[0].targets = [{}]; });
  refused(/invalid data for NORMAL/, ({json}) => { json.meshes[0].primitives[0].attributes.NORMAL = 1; });
  refused(/no primitives/, ({json}) => { json.meshes[0].primitives = []; });
  refused(/3 positions, and 2 of NORMAL/, ({json}) => {
    json.accessors.push({bufferView: 0, componentType: 5126, count: 2, type: "VEC3"});
    json.meshes[0].primitives[0].attributes.NORMAL = 2;
  });
});

test("Data that is used very often is refused before it is read again and again", () => {
  refused(/use the same data too often/, (model) => {
    const count = 100000;
    model.bin = new Uint8Array(count * 12);
    Object.assign(model.json, {images: [], textures: [], materials: [{}], buffers: [{byteLength: count * 12}], bufferViews: [{buffer: 0, byteLength: count * 12}],
      accessors: Array.from({length: 1000}, () => ({bufferView: 0, componentType: 5126, count, type: "VEC3"})),
      meshes: [{primitives: Array.from({length: 1000}, (_, i) => ({attributes: {POSITION: i}}))}]});
  });
});

test("Nodes in cycles, with two parents, too deep or too many are refused", () => {
  refused(/has two parents/, ({json}) => { json.nodes[1].children = [2]; });
  refused(/cycle/, ({json}) => { json.nodes.push({name: "a", children: [4]}, {name: "b", children: [3]}); });
  refused(/cycle/, ({json}) => { json.nodes.push({children: [3]}); });
  refused(/cycle at node `/, ({json}) => { json.nodes[1].children = [0]; });
  refused(/`AGV` is in the scene and has a parent/, ({json}) => { json.scenes[0].nodes = [0, 1]; });
  refused(/nested more than 64 levels/, ({json}) => { json.nodes = chain(65); });
  refused(/nested more than 64 levels/, ({json}) => { json.nodes = chain(5000); });
  refused(/20,001 nodes/, ({json}) => { json.nodes = Array.from({length: 20001}, () => ({mesh: 0})); });
  refused(/invalid children/, ({json}) => { json.nodes[0].children = [-1]; });
  refused(/invalid children/, ({json}) => { json.nodes[0].children = "12"; });
  refused(/names 7 of 1/, ({json}) => { json.nodes[1].mesh = 7; });
  refused(/names -1 of 1/, ({json}) => { json.nodes[1].mesh = -1; });
  refused(/invalid `translation`/, ({json}) => { json.nodes[1].translation = [0, 1e9, 0]; });
  refused(/invalid `matrix`/, ({json}) => { json.nodes[1].matrix = [1, 2, 3]; });
  refused(/invalid name/, ({json}) => { json.nodes[1].name = 5; });
  for (const name of ["x".repeat(1001), "ä".repeat(501)]) refused(/name of more than 1,000 bytes/, ({json}) => { json.nodes[1].name = name; });
  refused(/no scene/, ({json}) => { json.scene = 5; });
  refused(/no nodes, or one twice/, ({json}) => { json.scenes[0].nodes = [0, 0]; });
  refused(/names the node 9 of 3/, ({json}) => { json.scenes[0].nodes = [9]; });
  refused(/nothing to show/, ({json}) => { for (const node of json.nodes) delete node.mesh; });
  const deep = smallModel();
  deep.json.nodes = chain(64);
  checkGlb(pack(deep));
});

test("A model that draws too much is refused: what counts is each use of a mesh", () => {
  refused(/draws 6,000,000 vertices/, (model) => {
    const count = 1000;
    model.bin = new Uint8Array(count * 12);
    Object.assign(model.json, {images: [], textures: [], materials: [{}], buffers: [{byteLength: count * 12}], bufferViews: [{buffer: 0, byteLength: count * 12}],
      accessors: [{bufferView: 0, componentType: 5126, count, type: "VEC3"}], meshes: [{primitives: [{attributes: {POSITION: 0}}]}],
      nodes: Array.from({length: 6000}, () => ({mesh: 0})), scenes: [{nodes: Array.from({length: 6000}, (_, i) => i)}]});
  });
  refused(/draws 30,000 pieces/, ({json}) => { json.meshes[0].primitives = Array.from({length: 15000}, () => json.meshes[0].primitives[0]); });
});

test("Pictures that are too large or no pictures are refused", () => {
  refused(/5,000 x 8 pixels/, ({bin}) => { bin.set(pngOf(5000, 8), 44); });
  refused(/not a PNG or JPEG/, ({bin}) => { bin.fill(0, 44); });
  refused(/not a PNG or JPEG/, ({bin}) => { bin.set(pngOf(0, 8), 44); });
  refused(/not a PNG or JPEG/, ({json}) => { json.images[0].mimeType = "image/svg+xml"; });
  refused(/not a PNG or JPEG/, ({json}) => { json.images[0].bufferView = 12; });
  refused(/65 textures/, ({json}) => { json.textures = Array.from({length: 65}, () => ({source: 0})); });
  refused(/names 3 of 1/, ({json}) => { json.textures[0].source = 3; });
  refused(/names 4 of 1/, ({json}) => { json.materials[0].pbrMetallicRoughness.baseColorTexture.index = 4; });
  refused(/invalid color/, ({json}) => { json.materials[0].pbrMetallicRoughness.baseColorFactor = [2, 0, 0, 1]; });
  refused(/50,331,648 pixels/, ({json, bin}) => {
    bin.set(pngOf(4096, 4096), 44);
    json.images = [0, 1, 2].map(() => ({bufferView: 2, mimeType: "image/png"}));
  });
  assert.deepEqual(sizeOfPicture(jpegOf(640, 480)), [640, 480]);
  assert.equal(sizeOfPicture(jpegOf(640, 480).subarray(0, 14)), null);
  assert.equal(sizeOfPicture(Uint8Array.of(0xFF, 0xD8, 0xFF, 0xFE, 0, 0, 0, 0, 0, 0, 0, 0, 0)), null);
});

test("The loader gets only what was checked", () => {
  const model = smallModel();
  Object.assign(model.json, {extras: {a: 1}, animations: [{}], skins: [{}], cameras: [{}], extensionsUsed: ["KHR_lights_punctual"], extensions: {KHR_lights_punctual: {lights: [{}]}}});
  Object.assign(model.json.nodes[1], {skin: 0, camera: 0, extensions: {X: 1}, extras: {}});
  Object.assign(model.json.meshes[0].primitives[0], {extensions: {KHR_draco_mesh_compression: {}}});
  model.json.meshes[0].primitives[0].attributes.JOINTS_0 = 99;
  const json = cleanJson(checkGlb(pack(model)).json);
  assert.doesNotMatch(JSON.stringify(json), /extras|extensions|animations|skin|camera|JOINTS|name/);
  assert.deepEqual(checkGlb(cleanGlb(checkGlb(pack(model)))).json.nodes[1], {mesh: 0, translation: [1, 0, 0]});
});
