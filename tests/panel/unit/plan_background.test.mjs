// The picture behind the plan: it is loaded once, and again after a fault.
import assert from "node:assert/strict";
import {test} from "node:test";
import {Background} from "../../../runtime/panel/page/plan/background.js";
import {bitmapSize, openPicture} from "../../../runtime/panel/page/plan/picture.js";

const pause = () => new Promise((done) => setTimeout(done));
const kHall = {file: "a hall.svg", x: 0, y: 0, width: 4};

/// A background whose files are those of a map; `texts`: what failed.
const of = (files) => {
  const asked = [];
  const texts = [];
  const file = async (path) => {
    asked.push(path);
    if (!files.has(path)) throw new Error("no such file");
    return files.get(path);
  };
  let loads = 0;
  const background = new Background({api: {file}}, async (blob) => {
    if (blob === "broken") throw new Error("the browser cannot show it");
    return blob;
  }, {loaded: () => ++loads, failed: (text) => texts.push(text)});
  return {background, asked, texts, loads: () => loads};
};

test("A picture is loaded once for its file, and is gone with it", async () => {
  const {background, asked, loads} = of(new Map([["files/a%20hall.svg", "hall"], ["files/b.png", "other"]]));
  background.show(kHall);
  await pause();
  background.show({...kHall, x: 3});
  assert.deepEqual(background.shown(), {...kHall, x: 3, image: "hall"});
  assert.deepEqual([asked.length, loads()], [1, 1]);
  background.show({...kHall, file: "b.png"});
  assert.equal(background.shown(), null);
  background.show(undefined);
  await pause();
  assert.deepEqual([background.shown(), loads()], [null, 1]);
});

test("A picture that is missing or broken is reported, and can be loaded again", async () => {
  const files = new Map();
  const {background, texts} = of(files);
  const reload = async () => (background.load(), pause());
  background.show(kHall);
  await pause();
  assert.equal(texts.at(-1), "The picture a hall.svg is not shown: no such file.");
  files.set("files/a%20hall.svg", "broken");
  await reload();
  assert.equal(texts.at(-1), "The picture a hall.svg is not shown: the browser cannot show it.");
  files.set("files/a%20hall.svg", "hall");
  await reload();
  assert.deepEqual([texts.at(-1), background.shown().image], ["", "hall"]);
});

test("A bitmap has at most 4096 pixels in each direction; an SVG has as many, a small PNG its own", () => {
  assert.deepEqual(bitmapSize(80, 20, true), [4096, 1024]);
  assert.deepEqual(bitmapSize(80, 20, false), [80, 20]);
  assert.deepEqual(bitmapSize(10000, 20000, false), [2048, 4096]);
  assert.deepEqual(bitmapSize(1e6, 1, false), [4096, 1]);
});

test("The address of a picture's bytes is given back, also if it is broken", async () => {
  const open = new Set();
  URL.createObjectURL = () => (open.add("blob:1"), "blob:1");
  URL.revokeObjectURL = (url) => open.delete(url);
  let decode = async () => {};
  globalThis.Image = class {
    constructor() { Object.assign(this, {naturalWidth: 80, naturalHeight: 20, decode: () => decode()}); }
  };
  globalThis.document = {createElement: () => ({getContext: () => ({drawImage: () => assert.equal(open.size, 1)})})};
  assert.equal((await openPicture({type: "image/svg+xml"})).height, 1024);
  assert.equal(open.size, 0);
  decode = async () => { throw new Error("x"); };
  await assert.rejects(openPicture({type: "image/png"}), /the browser cannot show it/);
  assert.equal(open.size, 0);
});
