// The plant in 3D, in a real browser whose 3D is computed by the processor: a plant without a model, the models of the examples, cameras that a
// trainer shows to everyone, models that are refused, a browser without WebGL.
//
// usage: node view3d_test.mjs PLAYWRIGHT_FOLDER AXE_FOLDER SYMPLANT
// Exit code: 0 passed, 1 failed, 77 there is no chromium
import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {join} from "node:path";
import {Browser, finish, kSoftware3d, runTests, until} from "./browser.mjs";
import {pack, smallModel} from "../../panel/unit/glb.mjs";
import {kProject, startProgram} from "./plants.mjs";

const [playwright, axe, symplant] = process.argv.slice(2);
const browser = await Browser.open({playwright, axe, graphics: kSoftware3d});

const run = async (plant, test) => {
  const program = await startProgram(symplant, ["run", plant, "--panel", "127.0.0.1:0"]);
  const page = await browser.page();
  await page.emulateMedia({reducedMotion: "reduce"});
  try {
    await test(page, program.link);
  } finally {
    await page.close();
    await program.stop();
  }
};

const open3d = async (page, link) => {
  await page.goto(link + "&view=3d");
  await until("a picture in 3D", async () => page.evaluate(() => (globalThis.symplant?.view3d?.drawn ?? 0) > 0), 30000);
};
const modelShown = (page) => until("the model", async () => page.evaluate(() => Boolean(symplant.view3d.stage.content.bound)), 20000);
const sentence = (page) => page.locator(".view3d > p").innerText();
const pressed = (page, name) => page.getByRole("button", {name}).getAttribute("aria-pressed");
const cameraAt = (page) => page.evaluate(() => symplant.view3d.stage.camera.position.toArray().map((value) => Math.round(value * 100) / 100));
const nodeAt = (page, device) => page.evaluate((name) => symplant.view3d.stage.content.bound.find(({key}) => key === name).node.object.position.toArray(), device);
const act = (page, ...acts) => page.evaluate((list) => symplant.api.acts(...list), acts);
const noFaults = async (page, where) => {
  await page.waitForFunction(() => document.body.dataset.ready === "1");
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({colorScheme, reducedMotion: "reduce"});
    assert.deepEqual(await browser.faults(page), [], where + ", " + colorScheme);
  }
};
/// Where a device is on the screen.
const screenOf = (page, device) => page.evaluate((name) => {
  const {stage} = symplant.view3d;
  const {center} = stage.content.outline({kind: "device", index: symplant.names.index("device", name)});
  const box = stage.canvas.getBoundingClientRect();
  const point = stage.camera.position.clone().set(...center).project(stage.camera);
  return [box.left + (point.x + 1) / 2 * box.width, box.top + (1 - point.y) / 2 * box.height];
}, device);

const kCell = "examples/cell/plant.json";
const kTests = [
  ["the first views do not load three.js; the 3D view does, and shows devices, belts and moving parts without a model", () => run("examples/training-line/plant.json", async (page, link) => {
    const loaded = [];
    page.on("request", (request) => loaded.push(new URL(request.url()).pathname));
    await page.goto(link + "&view=line");
    await page.waitForSelector("body[data-ready]");
    await page.waitForTimeout(500);
    assert.ok(!loaded.some((path) => /three|view3d_scene|glb/i.test(path)), "too early");
    await page.getByRole("link", {name: "3D"}).click();
    await until("a picture in 3D", async () => page.evaluate(() => (symplant.view3d?.drawn ?? 0) > 0), 30000);
    assert.ok(loaded.includes("/build/three.module.js"));
    const partsAt = () => page.evaluate(() => [...symplant.view3d.stage.content.parts.batch.positions.array].join());
    await until("a part", async () => page.evaluate(() => symplant.view3d.stage.content.parts.shown > 0));
    const before = await partsAt();
    await act(page, {force: {FT_C1_BELT_O_RUN: false}});  // inverted: it runs
    await until("a part moves", async () => await partsAt() !== before);
    await noFaults(page, "3D without a model");
  })],
  ["a device is selected by a click, as in the tiles, and has an outline", () => run("examples/training-line/plant.json", async (page, link) => {
    await open3d(page, link);
    const name = await page.evaluate(() => symplant.plant.devices[0].name);
    await page.mouse.click(...await screenOf(page, name));
    await page.getByRole("complementary", {name: "Details"}).getByRole("heading", {name, exact: true}).waitFor();
    assert.equal(await page.evaluate(() => symplant.view3d.stage.outline.children.length), 1);
  })],
  ["keys move, turn and zoom the camera, show everything, and see through housings", () => run("examples/training-line/plant.json", async (page, link) => {
    await open3d(page, link);
    await page.locator("canvas").focus();
    const home = await cameraAt(page);
    for (const key of ["ArrowLeft", "ArrowUp", "Shift+ArrowRight", "Shift+ArrowUp", "+", "-"]) {
      const before = await cameraAt(page);
      await page.keyboard.press(key);
      assert.notDeepEqual(await cameraAt(page), before, key);
    }
    await page.keyboard.press("0");
    assert.deepEqual(await cameraAt(page), home);
    await page.keyboard.press("t");
    assert.equal(await pressed(page, "See through"), "true");
    assert.equal(await page.evaluate(() => symplant.view3d.stage.content.housings.material.transparent), true);
    await page.keyboard.press("t");
    assert.equal(await pressed(page, "See through"), "false");
    assert.equal(await page.evaluate(() => symplant.router.route.view), "3d");
  })],
  ["keys go from device to device, open details, and a screen reader hears which device it is", () => run("examples/training-line/plant.json", async (page, link) => {
    await open3d(page, link);
    await page.locator("canvas").focus();
    const names = await page.evaluate(() => symplant.plant.devices.map(({name}) => name));
    const said = () => page.locator(".view3d > [role=status].hidden-text").innerText();
    for (const [key, index] of [["]", 0], ["]", 1], ["[", 0], ["[", names.length - 1], ["]", 0], ["]", 1]]) {
      await page.keyboard.press(key);
      assert.ok((await said()).startsWith(names[index] + ", "), key + ": " + await said());
      assert.equal(await page.evaluate(() => symplant.view3d.stage.outline.children.length), 1);
    }
    await page.keyboard.press("Enter");
    await page.getByRole("complementary", {name: "Details"}).getByRole("heading", {name: names[1], exact: true}).waitFor();
  })],
  ["a track and a place of a model have outlines and parts", () => run("examples/training-line/plant.json", async (page, link) => {
    const {json, bin} = smallModel();
    const untextured = {...json, images: [], textures: [], materials: [{}]};
    await page.route("**/api/v1/files/small.glb", (route) => route.fulfill({body: Buffer.from(pack({json: untextured, bin})), contentType: "model/gltf-binary"}));
    await page.route("**/api/v1/plant", async (route) => {
      const plant = await (await route.fetch()).json();
      const nodes = Object.fromEntries(plant.locations.slice(0, 2).map(({name}, i) => [name, {node: ["AGV", "Door"][i], from: [0, .5, 0], to: [2, .5, 0]}]));
      await route.fulfill({json: {...plant, view3d: {model: "small.glb", cameras: {}, nodes}}});
    });
    await open3d(page, link);
    await modelShown(page);
    await until("a part", async () => page.evaluate(() => symplant.view3d.stage.content.parts.some(({parts}) => parts.shown > 0)));
    const outline = () => page.evaluate(() => symplant.view3d.stage.content.outline({kind: "location", index: 0}));
    const before = await outline();
    assert.ok([...before.center, ...before.size].every(Number.isFinite), JSON.stringify(before));
    await page.waitForTimeout(300);
    assert.deepEqual(await outline(), before);
    await page.evaluate(() => symplant.router.select("location", symplant.plant.locations[0].name));
    await until("an outline", async () => page.evaluate(() => symplant.view3d.stage.outline.children.length === 1));
    assert.deepEqual(await sentence(page), "");
  })],
  ["a view that is left while its model is loaded shows it when it is back", () => run(kCell, async (page, link) => {
    let answer = () => {};
    const asked = new Promise((done) => { answer = done; });
    await page.route("**/api/v1/files/cell.glb", (route) => answer(route));
    await open3d(page, link);
    const route = await asked;
    await page.getByRole("link", {name: "Plan"}).click();
    await page.evaluate(() => symplant.view3d.changed());
    await route.continue();
    await modelShown(page);
    await page.waitForTimeout(300);
    await page.getByRole("link", {name: "3D"}).click();
    await until("everything", () => page.evaluate(() => {
      const {stage} = symplant.view3d;
      const {clientWidth, clientHeight} = stage.canvas.parentElement;
      const at = stage.camera.position.toArray();
      const isWhole = stage.overview().from.every((value, i) => Math.abs(value - at[i]) < 1e-6);
      return (isWhole && stage.camera.aspect === clientWidth / clientHeight) || JSON.stringify([at, stage.overview(), stage.camera.aspect, clientWidth, clientHeight]);
    }));
  })],
  ["after a failure there is a sentence, nothing stays behind, and the view is tried again when it is next shown", () => run("examples/training-line/plant.json", async (page, link) => {
    await page.goto(link + "&view=plan");
    await page.waitForSelector("body[data-ready]");
    const listeners = () => page.evaluate(() => symplant.layout.listeners.size);
    const before = await listeners();
    await page.evaluate(() => {
      const {layout} = symplant;
      Object.defineProperty(layout, "placed", {configurable: true, get: () => { throw new Error("no layout"); }});
    });
    await page.evaluate(() => symplant.router.view("3d"));
    await until("the sentence", async () => /^The 3D view cannot be shown: no layout\. See the plant as a plan$/.test(await sentence(page)) || await sentence(page));
    assert.deepEqual([await page.locator("canvas").count(), await listeners(), await page.evaluate(() => symplant.view3d)], [0, before, null]);
    await page.evaluate(() => { delete symplant.layout.placed; });
    await page.getByRole("link", {name: "See the plant as a plan"}).click();
    await page.getByRole("link", {name: "3D"}).click();
    await until("a picture in 3D", async () => page.evaluate(() => (symplant.view3d?.drawn ?? 0) > 0), 30000);
    assert.equal(await sentence(page), "");
    assert.ok(await page.getByRole("button", {name: "Show everything"}).isVisible());
  })],
  ["a node of the model moves with its device, and back when the command turns around", () => run(kCell, async (page, link) => {
    await open3d(page, link);
    await modelShown(page);
    assert.deepEqual(await nodeAt(page, "EXLINE_MB_AGV"), [0, 0, 0]);
    const before = await page.locator("canvas").screenshot();
    await act(page, {force: {EXLINE_MB_AGV_O_P2: true}});
    await until("the vehicle moves", async () => (await nodeAt(page, "EXLINE_MB_AGV"))[0] > .2);
    await act(page, {force: {EXLINE_MB_AGV_O_P2: false, EXLINE_MB_AGV_O_P1: true}});
    await until("the vehicle is back", async () => (await nodeAt(page, "EXLINE_MB_AGV"))[0] === 0);
    await act(page, {force: {EXLINE_MB_AGV_O_P1: false, EXLINE_MB_AGV_O_P2: true}});
    await until("the vehicle is at the machine", async () => (await nodeAt(page, "EXLINE_MB_AGV"))[0] === 3);
    await page.waitForTimeout(300);
    assert.ok(!before.equals(await page.locator("canvas").screenshot()), "the picture is the same");
    await page.mouse.click(...await screenOf(page, "EXLINE_MB_AGV"));
    await page.getByRole("complementary", {name: "Details"}).getByRole("heading", {name: "EXLINE_MB_AGV", exact: true}).waitFor();
    await noFaults(page, "3D with a model");
  })],
  ["values turn, move and color the nodes of the crane", () => run("examples/harbour-crane/plant.json", async (page, link) => {
    await open3d(page, link);
    await modelShown(page);
    const load = () => page.evaluate(() => symplant.view3d.stage.content.bound.find(({key}) => key === "load").node.meshes[0].material.color.getHex());
    const [height, cold] = [await nodeAt(page, "height"), await load()];
    await act(page, {set: {"hoist.height": 20, "slew.angle": 90, load: 40}});
    await until("the height", async () => Math.abs((await nodeAt(page, "height"))[1] - height[1] - 10) < .01);
    await until("the color", async () => await load() !== cold);
    const turned = await page.evaluate(() => symplant.view3d.stage.content.bound.find(({key}) => key === "slewing").node.object.rotation.y * 180 / Math.PI);
    assert.ok(Math.abs(turned - 90) < .1, String(turned));
  })],
  ["a trainer shows a camera to everyone, and everything again", () => run(kCell, async (page, link) => {
    await open3d(page, link);
    await modelShown(page);
    const viewer = await browser.page();
    await viewer.emulateMedia({reducedMotion: "reduce"});
    await viewer.goto(link.replace(/#.*/, "#view=3d"));
    await until("a picture in 3D", async () => viewer.evaluate(() => (globalThis.symplant?.view3d?.drawn ?? 0) > 0), 30000);
    await modelShown(viewer);
    const home = await cameraAt(viewer);
    assert.equal(await viewer.getByRole("button", {name: "For everyone"}).count(), 0);
    await page.getByRole("combobox", {name: "Camera"}).selectOption("machine");
    await until("the camera of the trainer", async () => (await cameraAt(page)).join() === "1,3,5");
    assert.deepEqual(await cameraAt(viewer), home);
    await page.getByRole("button", {name: "For everyone"}).click();
    await until("the camera of the viewer", async () => (await cameraAt(viewer)).join() === "1,3,5");
    assert.equal(await viewer.getByRole("combobox", {name: "Camera"}).inputValue(), "machine");
    await page.getByRole("combobox", {name: "Camera"}).selectOption("Overview");
    await page.getByRole("button", {name: "For everyone"}).click();
    await until("everything", async () => (await cameraAt(viewer)).join() === home.join() || [await cameraAt(viewer), home, await viewer.evaluate(() => symplant.store.camera), await page.locator(".view3d .result").innerText()]);
    await viewer.close();
  })],
  ["a model that is cut off, hostile or missing is refused with a sentence, and boxes are shown", () => run(kCell, async (page, link) => {
    const model = readFileSync(join(kProject, "examples/cell/cell.glb"));
    const cycle = Buffer.from(model.toString("latin1").replace(/"children":\[1,/, '"children":[0,'), "latin1");
    for (const [body, words] of [[model.subarray(0, 5000), /cut off or damaged/], [Buffer.from("<html>"), /not a GLB file/], [cycle, /two parents|cycle|has a parent/]]) {
      await page.route("**/api/v1/files/cell.glb", (route) => route.fulfill({body, contentType: "model/gltf-binary"}));
      await page.goto("about:blank");
      await open3d(page, link);
      await until("the sentence", async () => words.test(await sentence(page)) || await sentence(page));
      assert.match(await sentence(page), /^The model cell\.glb cannot be shown: .*\. Boxes are shown instead\.$/);
      assert.ok(await page.evaluate(() => symplant.view3d.stage.content.devices.length > 0));
      await page.unroute("**/api/v1/files/cell.glb");
    }
    await noFaults(page, "a refused model");
  })],
  ["without WebGL there is one sentence, with a link to the plan", () => run(kCell, async (page, link) => {
    await page.addInitScript(() => {
      const getContext = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...more) { return kind.startsWith("webgl") ? null : getContext.call(this, kind, ...more); };
    });
    await page.goto(link + "&view=3d");
    await until("the sentence", async () => /^This browser shows no 3D: WebGL is off or missing\. See the plant as a plan$/.test(await sentence(page)) || await sentence(page));
    await noFaults(page, "no WebGL");
    await page.getByRole("link", {name: "See the plant as a plan"}).click();
    await until("the plan", async () => page.evaluate(() => symplant.router.route.view === "plan"));
  })],
];

await finish(browser, await runTests(kTests, {only: process.argv[5]}));
