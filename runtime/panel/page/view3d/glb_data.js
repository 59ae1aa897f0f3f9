// Checks of a GLB file: buffers, views, accessors, meshes.
import {isIndex, listOf, refuse, whole, checkIndex} from "./glb_words.js";

const kMostLists = 100000;
const kBytes = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4};
const kNumbers = {SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4};
const kFloat = 5126;
const kMostRead = 4e7;  // numbers: more than a file of the greatest size has, if its data is not used many times
const kAttributes = {POSITION: ["VEC3"], NORMAL: ["VEC3"], TANGENT: ["VEC4"], TEXCOORD_0: ["VEC2"], TEXCOORD_1: ["VEC2"], COLOR_0: ["VEC3", "VEC4"]};
/// Attributes that the view uses; others are left out.
export const kUsed = new Set(Object.keys(kAttributes));

const checkViews = (json, bin) => {
  const buffers = listOf(json, "buffers", 1);
  for (const {uri, byteLength} of buffers) {
    if (uri !== undefined) refuse("it refers to another file, or has data as text: export it as one GLB file");
    if (!isIndex(byteLength, bin.length + 1)) refuse("its buffer has " + JSON.stringify(byteLength) + " bytes, and the file " + whole(bin.length));
  }
  const views = listOf(json, "bufferViews", kMostLists);
  views.forEach(({buffer, byteOffset = 0, byteLength, byteStride}, i) => {
    const size = buffers[buffer]?.byteLength;
    if (!isIndex(buffer, buffers.length) || !isIndex(byteOffset, size + 1) || !isIndex(byteLength, size - byteOffset + 1)) refuse("its buffer view " + i + " is outside of its buffer");
    if (byteStride !== undefined && !(Number.isInteger(byteStride) && byteStride >= 4 && byteStride <= 252 && byteStride % 4 === 0)) refuse("its buffer view " + i + " has an invalid stride");
  });
  return views;
};

const checkAccessors = (json, views) => {
  const accessors = listOf(json, "accessors", kMostLists);
  accessors.forEach((accessor, i) => {
    const {bufferView, byteOffset = 0, componentType, type, count, sparse} = accessor;
    const what = "its accessor " + i;
    if (sparse !== undefined || type?.startsWith?.("MAT")) refuse(what + " is of a form that is not supported (sparse, or a matrix)");
    const size = kBytes[componentType] * kNumbers[type];
    if (!(size > 0)) refuse(what + " has an unknown type");
    if (!Number.isInteger(count) || count < 1) refuse(what + " has an invalid count");
    if (!isIndex(bufferView, views.length)) refuse(what + " has no data");
    const {byteLength, byteStride = size, byteOffset: begin = 0} = views[bufferView];
    if (!Number.isInteger(byteOffset) || byteOffset < 0) refuse(what + " has an invalid offset");
    if (byteStride < size || (begin + byteOffset) % kBytes[componentType] !== 0) refuse(what + " is not aligned");
    if (byteOffset + (count - 1) * byteStride + size > byteLength) refuse(what + " is outside of its buffer view");
    Object.assign(accessor, {min: undefined, max: undefined});  // what the file says of them is not read
  });
  return accessors;
};

/// `look(number, k)` for each number of an accessor; `k`: which one of its vector.
const eachNumber = (json, bin, seen, {bufferView, byteOffset = 0, componentType, type, count}, look) => {
  seen.numbers += count * kNumbers[type];
  if (seen.numbers > kMostRead) refuse("its meshes use the same data too often");
  const view = json.bufferViews[bufferView];
  const data = new DataView(bin.buffer, bin.byteOffset);
  const read = {5121: "getUint8", 5123: "getUint16", 5125: "getUint32", 5126: "getFloat32"}[componentType];
  const bytes = kBytes[componentType];
  const stride = view.byteStride ?? bytes * kNumbers[type];
  for (let i = 0, at = (view.byteOffset ?? 0) + byteOffset; i < count; ++i, at += stride) {
    for (let k = 0; k < kNumbers[type]; ++k) look(data[read](at + k * bytes, true), k);
  }
};

/// A cube of 200 km: what is farther away is no plant.
const isNear = (number) => Math.abs(number) <= 1e5;

const checkNumbers = (json, bin, seen, accessor, key, what) => {
  const [min, max] = [[Infinity, Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity, -Infinity]];
  eachNumber(json, bin, seen, accessor, (number, k) => {
    if (!isNear(number)) refuse(what + " has a number that is not finite, or too large, in " + key);
    min[k] = Math.min(min[k], number);
    max[k] = Math.max(max[k], number);
  });
  if (key === "POSITION") Object.assign(accessor, {min: min.slice(0, 3), max: max.slice(0, 3)});
};

/// Returns how many vertices it draws. `seen`: what was looked at, and how many numbers.
const checkPrimitive = (json, bin, accessors, {attributes, indices, material, mode = 4, targets}, what, seen) => {
  if (!isIndex(mode, 7)) refuse(what + " has an unknown mode");
  if (targets !== undefined) refuse(what + " has morph targets, which are not supported");
  checkIndex(material, listOf(json, "materials", kMostLists), what);
  const positions = accessors[attributes?.POSITION];
  if (!isIndex(attributes?.POSITION, accessors.length) || positions.type !== "VEC3" || positions.componentType !== kFloat) refuse(what + " has no positions");
  for (const [key, index] of Object.entries(attributes)) {
    if (!kUsed.has(key)) continue;
    if (!isIndex(index, accessors.length) || !kAttributes[key].includes(accessors[index].type)) refuse(what + " has invalid data for " + key);
    if (accessors[index].count !== positions.count) refuse(what + " has " + whole(positions.count) + " positions, and " + whole(accessors[index].count) + " of " + key);
    if (accessors[index].componentType !== kFloat || seen.keys.has(key + index)) continue;
    seen.keys.add(key + index);
    checkNumbers(json, bin, seen, accessors[index], key, what);
  }
  if (indices === undefined) return positions.count;
  const of = accessors[indices];
  if (!isIndex(indices, accessors.length) || of.type !== "SCALAR" || ![5121, 5123, 5125].includes(of.componentType)) refuse(what + " has invalid indices");
  let greatest = 0;
  const key = indices + " of " + positions.count;
  if (!seen.keys.has(key)) eachNumber(json, bin, seen, of, (number) => { greatest = Math.max(greatest, number); });
  seen.keys.add(key);
  if (greatest >= positions.count) refuse(what + " has the index " + whole(greatest) + " of " + whole(positions.count) + " vertices");
  return Math.max(positions.count, of.count);
};

/// Checks all data, and sets `min` and `max` of positions to what they are; returns what each mesh draws: { vertices, calls }.
export const checkData = (json, bin) => {
  const accessors = checkAccessors(json, checkViews(json, bin));
  const seen = {keys: new Set(), numbers: 0};
  return listOf(json, "meshes", kMostLists).map(({primitives}, mesh) => {
    if (!Array.isArray(primitives) || primitives.length === 0 || primitives.length > kMostLists) refuse("its mesh " + mesh + " has no primitives");
    const vertices = primitives.map((primitive, i) => checkPrimitive(json, bin, accessors, primitive ?? {}, "its mesh " + mesh + ", primitive " + i + ",", seen));
    return {vertices: vertices.reduce((sum, each) => sum + each, 0), calls: vertices.length};
  });
};
