// Checks a GLB file before a loader sees it: its chunks, its JSON, and that what it names is there and not too large. Pure functions.
import {checkData} from "./glb_data.js";
import {checkImages} from "./glb_images.js";
import {checkNodes} from "./glb_nodes.js";
import {refuse, whole} from "./glb_words.js";

export const kMostBytes = 32 * 2 ** 20;
const kMostJson = 16 * 2 ** 20;
const kMostNested = 64;  // levels of brackets
const [kMagic, kJson, kBin] = [0x46546C67, 0x4E4F534A, 0x004E4942];
const kKnownExtensions = new Set(["KHR_materials_unlit"]);

/// { json, bin } of the chunks of a GLB file.
const chunksOf = (buffer) => {
  const {byteLength: size} = buffer;
  if (size > kMostBytes) refuse("it has " + whole(size) + " bytes, and " + whole(kMostBytes) + " (32 MiB) are possible");
  const view = new DataView(buffer);
  if (size < 20 || view.getUint32(0, true) !== kMagic) refuse("it is not a GLB file");
  if (view.getUint32(4, true) !== 2) refuse("it is of version " + view.getUint32(4, true) + " of GLB, and only version 2 is possible");
  if (view.getUint32(8, true) !== size) refuse("its header says " + whole(view.getUint32(8, true)) + " bytes, and it has " + whole(size) + ": it is cut off or damaged");
  const found = [];
  for (let at = 12; at < size;) {
    if (size - at < 8) refuse("its last chunk is cut off");
    const [length, kind] = [view.getUint32(at, true), view.getUint32(at + 4, true)];
    if (length % 4 !== 0 || length > size - at - 8) refuse("a chunk of " + whole(length) + " bytes does not fit into it");
    found.push({kind, bytes: new Uint8Array(buffer, at + 8, length)});
    at += 8 + length;
  }
  if (found[0].kind !== kJson) refuse("its first chunk is not JSON");
  return {text: found[0].bytes, bin: found[1]?.kind === kBin ? found[1].bytes : new Uint8Array(0)};
};

/// Fails if brackets are nested too deep; text in quotes does not count.
const checkNesting = (bytes) => {
  let depth = 0;
  let quoted = false;
  for (let i = 0; i < bytes.length; ++i) {
    const byte = bytes[i];
    if (quoted) {
      if (byte === 0x5C) ++i;
      else if (byte === 0x22) quoted = false;
    } else if (byte === 0x22) quoted = true;
    else if (byte === 0x5B || byte === 0x7B) {
      if (++depth > kMostNested) refuse("its JSON is nested more than " + kMostNested + " levels deep");
    } else if (byte === 0x5D || byte === 0x7D) --depth;
  }
};

const parsed = (bytes) => {
  if (bytes.length > kMostJson) refuse("its JSON has " + whole(bytes.length) + " bytes, and " + whole(kMostJson) + " are possible");
  checkNesting(bytes);
  try {
    return JSON.parse(new TextDecoder("utf-8", {fatal: true}).decode(bytes));
  } catch {
    return refuse("its JSON is not valid");
  }
};

/// Fails on a number that JSON reads as infinite, such as 1e999, and on keys that change objects.
const checkValues = (value) => {
  if (typeof value === "number" && !Number.isFinite(value)) refuse("it has a number that is not finite");
  if (typeof value !== "object" || value === null) return;
  for (const key of Object.keys(value)) {
    if (key === "__proto__") refuse("it has a key `__proto__`");
    checkValues(value[key]);
  }
};

/// { json, bin } of a GLB file; an Error says what is wrong.
export const checkGlb = (buffer) => {
  const {text, bin} = chunksOf(buffer);
  const json = parsed(text);
  if (typeof json !== "object" || json === null || Array.isArray(json)) refuse("its JSON is not an object");
  checkValues(json);
  if (!/^2\.\d+$/.test(json.asset?.version)) refuse("its `asset.version` is not 2");
  const unknown = (Array.isArray(json.extensionsRequired) ? json.extensionsRequired : []).filter((name) => !kKnownExtensions.has(name));
  if (unknown.length > 0) refuse("it needs the extension `" + String(unknown[0]).slice(0, 60) + "`, which is not supported: export it without compression and extensions");
  const meshes = checkData(json, bin);
  checkImages(json, bin);
  checkNodes(json, meshes);
  return {json, bin};
};
