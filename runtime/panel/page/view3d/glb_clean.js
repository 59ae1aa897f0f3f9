// Makes a GLB file with only that of a checked file which the view uses: so the loader reads nothing that was not checked.
import {kUsed} from "./glb_data.js";

const only = (object, keys) => Object.fromEntries(keys.filter((key) => object[key] !== undefined).map((key) => [key, object[key]]));
const each = (list, keys) => (list ?? []).map((object) => only(object, keys));

const materialOf = (material) => {
  const {pbrMetallicRoughness: color = {}} = material;
  const texture = color.baseColorTexture ? {baseColorTexture: {index: color.baseColorTexture.index}} : {};
  return {...(material.doubleSided === true ? {doubleSided: true} : {}), ...(material.alphaMode === "BLEND" ? {alphaMode: "BLEND"} : {}),
    pbrMetallicRoughness: {...only(color, ["baseColorFactor"]), ...texture, metallicFactor: 0, roughnessFactor: 1}};
};

const primitiveOf = ({attributes, indices, material, mode}) => ({attributes: Object.fromEntries(Object.entries(attributes).filter(([key]) => kUsed.has(key))),
  ...only({indices, material, mode}, ["indices", "material", "mode"])});

/// The JSON that the loader gets.
export const cleanJson = (json) => {
  const lists = {
    scenes: (json.scenes ?? []).map(({nodes}) => ({nodes})),
    nodes: each(json.nodes, ["children", "mesh", "matrix", "translation", "rotation", "scale"]),
    meshes: (json.meshes ?? []).map(({primitives}) => ({primitives: primitives.map(primitiveOf)})),
    materials: (json.materials ?? []).map(materialOf),
    textures: each(json.textures, ["source", "sampler"]),
    images: each(json.images, ["bufferView", "mimeType"]),
    samplers: each(json.samplers, ["magFilter", "minFilter", "wrapS", "wrapT"]),
    accessors: each(json.accessors, ["bufferView", "byteOffset", "componentType", "normalized", "count", "type", "min", "max"]),
    bufferViews: each(json.bufferViews, ["buffer", "byteOffset", "byteLength", "byteStride", "target"]),
    buffers: each(json.buffers, ["byteLength"]),
  };
  return {asset: {version: "2.0"}, scene: json.scene ?? 0, ...Object.fromEntries(Object.entries(lists).filter(([, list]) => list.length > 0))};
};

/// The file { json, bin } as the bytes of a GLB file.
export const packGlb = (json, bin) => {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const padded = (size) => Math.ceil(size / 4) * 4;
  const size = 12 + 8 + padded(text.length) + (bin.length > 0 ? 8 + padded(bin.length) : 0);
  const bytes = new Uint8Array(size);
  const view = new DataView(bytes.buffer);
  [0x46546C67, 2, size, padded(text.length), 0x4E4F534A].forEach((number, i) => view.setUint32(i * 4, number, true));
  bytes.fill(0x20, 20, 20 + padded(text.length)).set(text, 20);
  if (bin.length === 0) return bytes.buffer;
  const at = 20 + padded(text.length);
  view.setUint32(at, padded(bin.length), true);
  view.setUint32(at + 4, 0x004E4942, true);
  bytes.set(bin, at + 8);
  return bytes.buffer;
};

export const cleanGlb = ({json, bin}) => packGlb(cleanJson(json), bin);
