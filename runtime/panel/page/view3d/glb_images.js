// Checks of a GLB file: textures and the sizes of their pictures, which are read from the first bytes of PNG and JPEG files.
import {checkIndex, isIndex, listOf, refuse, whole} from "./glb_words.js";

const kMostTextures = 64;
const kMostSide = 4096;
const kMostPixels = 32 * 2 ** 20;  // of all together: 128 MiB of memory of the graphics
const kMostMaterials = 10000;

const sizeOfPng = (view) => view.byteLength >= 24 && view.getUint32(12) === 0x49484452 ? [view.getUint32(16), view.getUint32(20)] : null;

const sizeOfJpeg = (view) => {
  for (let at = 2; at + 9 <= view.byteLength;) {
    if (view.getUint8(at) !== 0xFF) return null;
    const marker = view.getUint8(at + 1);
    if (marker === 0xFF) {
      ++at;
      continue;
    }
    // The frame begins with one of these; others have a length and are skipped.
    if (marker >= 0xC0 && marker <= 0xCF && ![0xC4, 0xC8, 0xCC].includes(marker)) return [view.getUint16(at + 7), view.getUint16(at + 5)];
    const length = view.getUint16(at + 2);
    if (length < 2) return null;
    at += 2 + length;
  }
  return null;
};

/// [width, height] of a PNG or JPEG file; null if it is neither.
export const sizeOfPicture = (bytes) => {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 12) return null;
  if (view.getUint32(0) === 0x89504E47 && view.getUint32(4) === 0x0D0A1A0A) return sizeOfPng(view);
  return view.getUint16(0) === 0xFFD8 ? sizeOfJpeg(view) : null;
};

const checkTextureOf = (info, textures, what) => { if (info !== undefined) checkIndex(info?.index ?? -1, textures, what); };

export const checkImages = (json, bin) => {
  const images = listOf(json, "images", kMostTextures);
  const textures = listOf(json, "textures", kMostTextures);
  const samplers = listOf(json, "samplers", kMostTextures);
  let pixels = 0;
  images.forEach(({uri, bufferView, mimeType}, i) => {
    if (uri !== undefined) refuse("its picture " + i + " is in another file, or text: export it as one GLB file");
    if (!isIndex(bufferView, json.bufferViews?.length ?? 0) || !["image/png", "image/jpeg"].includes(mimeType)) refuse("its picture " + i + " is not a PNG or JPEG file");
    const {byteOffset = 0, byteLength} = json.bufferViews[bufferView];
    const size = sizeOfPicture(bin.subarray(byteOffset, byteOffset + byteLength));
    if (!size || size.includes(0)) refuse("its picture " + i + " is not a PNG or JPEG file");
    if (Math.max(...size) > kMostSide) refuse("its picture " + i + " has " + size.map(whole).join(" x ") + " pixels, and " + whole(kMostSide) + " on each side are possible");
    pixels += size[0] * size[1];
  });
  if (pixels > kMostPixels) refuse("its pictures have " + whole(pixels) + " pixels, and " + whole(kMostPixels) + " are possible");
  textures.forEach(({source, sampler}, i) => {
    checkIndex(source ?? -1, images, "its texture " + i);
    checkIndex(sampler, samplers, "its texture " + i);
  });
  listOf(json, "materials", kMostMaterials).forEach((material, i) => {
    const what = "its material " + i;
    checkTextureOf(material.pbrMetallicRoughness?.baseColorTexture, textures, what);
    const color = material.pbrMetallicRoughness?.baseColorFactor;
    if (color !== undefined && !(Array.isArray(color) && color.length === 4 && color.every((part) => part >= 0 && part <= 1))) refuse(what + " has an invalid color");
  });
};
