// A small GLB file for the tests: a triangle under three nodes, and a picture. Each test changes one thing of it.
import {packGlb} from "../../../runtime/panel/page/view3d/glb_clean.js";

/// The head of a PNG file.
export const pngOf = (wide, high) => {
  const bytes = new Uint8Array(28);
  const view = new DataView(bytes.buffer);
  [0x89504E47, 0x0D0A1A0A, 13, 0x49484452, wide, high].forEach((number, i) => view.setUint32(i * 4, number));
  return bytes;
};

/// The head of a JPEG file, with a comment before its frame.
export const jpegOf = (wide, high) => Uint8Array.of(0xFF, 0xD8, 0xFF, 0xFE, 0, 4, 1, 2, 0xFF, 0xC0, 0, 11, 8, high >> 8, high & 255, wide >> 8, wide & 255, 1, 1, 0x11, 0, 0);

/// { json, bin }: `json` can be changed before pack().
export const smallModel = () => {
  const bin = new Uint8Array(36 + 8 + 28);
  const view = new DataView(bin.buffer);
  [0, 0, 0, 1, 0, 0, 0, 2, 0].forEach((number, i) => view.setFloat32(i * 4, number, true));
  [0, 1, 2].forEach((number, i) => view.setUint16(36 + i * 2, number, true));
  bin.set(pngOf(16, 8), 44);
  const json = {
    asset: {version: "2.0"}, scene: 0, scenes: [{nodes: [0]}],
    nodes: [{name: "Cell", children: [1, 2]}, {name: "AGV", mesh: 0, translation: [1, 0, 0]}, {name: "Door", mesh: 0}],
    meshes: [{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 0}]}],
    materials: [{pbrMetallicRoughness: {baseColorFactor: [1, 0, 0, 1], baseColorTexture: {index: 0}}}],
    textures: [{source: 0}], images: [{bufferView: 2, mimeType: "image/png"}],
    accessors: [{bufferView: 0, componentType: 5126, count: 3, type: "VEC3"}, {bufferView: 1, componentType: 5123, count: 3, type: "SCALAR"}],
    bufferViews: [{buffer: 0, byteLength: 36}, {buffer: 0, byteOffset: 36, byteLength: 6}, {buffer: 0, byteOffset: 44, byteLength: 28}],
    buffers: [{byteLength: 72}],
  };
  return {json, bin};
};

export const pack = ({json, bin}) => packGlb(json, bin);
