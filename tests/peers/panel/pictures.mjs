// Makes the pictures of docs/panel.md from real runs: docs/pictures/panel-*.png.
//
// usage: node pictures.mjs PLAYWRIGHT_FOLDER AXE_FOLDER SYMPLANT FOLDER
import {execFileSync} from "node:child_process";
import {mkdtempSync, rmSync, statSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {Browser, kSoftware3d, until} from "./browser.mjs";
import {kExercise, kProject, startProgram} from "./plants.mjs";

const kMost = 150000;  // bytes of a picture
const [playwright, axe, symplant, folder] = process.argv.slice(2);
const browser = await Browser.open({playwright, axe, graphics: kSoftware3d});
const work = mkdtempSync(join(tmpdir(), "panel-pictures-"));
const page = await browser.page(/./);
await page.setViewportSize({width: 1120, height: 700});

const picture = async (name) => {
  const path = join(folder, "panel-" + name + ".png");
  await page.screenshot({path});
  const {size} = statSync(path);
  console.log(path + ": " + size + " bytes");
  if (size > kMost) throw new Error(path + " is too large");
};
const open = async (link) => {
  await page.goto("about:blank");
  await page.goto(link);
  await page.waitForSelector("body[data-ready]");
};
const view = async (hash) => {
  await page.evaluate((to) => { location.hash = to; }, hash);
  await page.waitForTimeout(700);
};
const act = (...acts) => page.evaluate((list) => symplant.api.acts(...list), acts);
const time = (seconds) => until("plant time", () => page.evaluate((t) => symplant.clock.now() >= t * 1e9, seconds), 120000);
/// The 3D view, when its model is loaded.
const view3d = async () => {
  await view("view=3d");
  await until("3D", () => page.evaluate(() => Boolean(symplant.view3d?.drawn > 0 && (!symplant.plant.view3d?.model || symplant.view3d.stage.content.bound))), 30000);
};
/// At rest it is drawn with all pixels.
const sharp = () => page.waitForTimeout(1200);
const withPlant = async (args, use) => {
  const plant = await startProgram(symplant, [...args, "--panel", "127.0.0.1:0"]);
  try {
    await open(plant.link);
    await use();
  } finally {
    await page.goto("about:blank");
    await plant.stop();
  }
};

await withPlant(["run", "examples/body-shop/plant.json", "--scenario", "examples/body-shop/cycle.json"], async () => {
  await time(5);
  await page.setViewportSize({width: 1360, height: 800});
  await page.waitForTimeout(500);
  await picture("plan");
  await page.setViewportSize({width: 1120, height: 700});
  await view("view=line");
  await picture("line");
  await view3d();
  await page.evaluate(() => {
    const {x, y, w, h} = symplant.layout.placed.frames.find(({name}) => name === "BODY SIDE20");
    symplant.view3d.stage.goTo({from: [x + w + 1, 8, y + h + 5], to: [x + w / 2, 0, y + h / 2]}, true);
  });
  await act({freeze: true});
  await sharp();
  await picture("3d");
});
await withPlant(["run", "examples/harbour-crane/plant.json"], async () => {
  await view3d();
  await act({set: {"hoist.height": 22, "slew.angle": -25, "luff.radius": 26, load: 18}});
  await page.getByRole("combobox", {name: "Camera"}).selectOption("quay");
  await act({freeze: true});
  await sharp();
  await picture("3d-crane");
});
await withPlant(["run", "examples/cell/plant.json"], async () => {
  await page.emulateMedia({colorScheme: "dark", reducedMotion: "reduce"});
  await view3d();
  await act({state: {EXLINE_MB_DOOR: "OPEN2"}}, {force: {EXLINE_MB_AGV_O_P2: true}});
  await until("the vehicle on its way", () => page.evaluate(() => symplant.view3d.stage.content.bound[0].node.object.position.x > 2.2));
  await act({freeze: true}, {force: {EXLINE_S1_STOPPER1_O_ADV: true}});
  await page.getByRole("combobox", {name: "Camera"}).selectOption("machine");
  await sharp();
  await picture("3d-cell");
  await page.emulateMedia({colorScheme: "light", reducedMotion: "no-preference"});
});
await withPlant(["run", "examples/sorting/plant.json", "--scenario", "examples/sorting/by-hand.json"], async () => {
  await time(6.2);
  await act({freeze: true});
  await page.waitForTimeout(700);
  await picture("plan-sorting");
});
await withPlant(["run", "examples/oven/plant.json"], async () => {
  await page.setViewportSize({width: 1120, height: 840});
  await act({set: {HEAT_O1_HEATER_O_POWER: 27648}}, {speed: 50});
  await page.evaluate(() => {
    const rows = {value: ["oven.temp", "oven.probe"], symbol: ["HEAT_O1_HEATER_O_POWER", "HEAT_O1_LIMITER_I_HOT"], device: ["HEAT_O1_DOOR"]};
    for (const [kind, names] of Object.entries(rows)) for (const name of names) symplant.chart.add(kind, symplant.names.index(kind, name));
    symplant.chart.showTime();
  });
  await time(100);
  await act({state: {HEAT_O1_DOOR: "OPEN"}});
  await time(130);
  await act({state: {HEAT_O1_DOOR: "NOT_OPEN"}});
  await time(240);
  await act({freeze: true});
  await page.waitForTimeout(700);
  await page.getByRole("button", {name: "All", exact: true}).click();
  await page.getByRole("application").click({position: {x: 160, y: 60}});
  await page.getByRole("application").click({position: {x: 330, y: 60}, modifiers: ["Shift"]});
  await page.waitForTimeout(700);
  await picture("chart");
  await page.setViewportSize({width: 1120, height: 700});
});
await withPlant(["run", "examples/body-shop/plant.json", "--exercise", kExercise], async () => {
  await act({state: {BODY_UNDER10_AIR: "NOT_GOOD"}}, {set: {BODY_UNDER10_CLAMP1_O_CLOSE: true}});
  await act({force: {BODY_UNDER10_DOOR1_I_SHUT: false}});
  await view("view=line&station=BODY+UNDER10&device=BODY_UNDER10_CLAMP1");
  await picture("station");
  await view("view=io");
  await page.getByRole("searchbox", {name: "Filter by name, address or comment"}).fill("under10");
  await page.setViewportSize({width: 1120, height: 480});
  await page.waitForTimeout(500);
  await picture("io");
  await page.setViewportSize({width: 1120, height: 700});
  const name = "BODY_UNDER10_CLAMP";
  await act({state: {BODY_UNDER10_AIR: "GOOD"}}, {set: {[name + "1_O_OPEN"]: true, [name + "2_O_OPEN"]: true, [name + "2_O_CLOSE"]: true, [name + "3_O_OPEN"]: true, [name + "3_O_CLOSE"]: true}});
  await act({set: {[name + "3_O_OPEN"]: false}});
  await act({acknowledge: "finding: conflicting operations of " + name + "2"}, {shelve: "finding: conflicting operations of " + name + "1", for: "10min"});
  await page.setViewportSize({width: 1120, height: 640});
  await view("view=alarms");
  await picture("alarms");
  await page.setViewportSize({width: 1120, height: 700});
  await act({exercise: "no-air"});
  await act({state: {BODY_UNDER10_AIR: "GOOD"}});
  await view("view=exercises");
  await picture("exercise");
});
await withPlant(["run", "examples/gallery/machining/plant.json", "--scenario", "examples/gallery/machining/scenario.json"], async () => {
  await view("view=line");
  await time(15.2);
  await picture("material");
});
const trace = join(work, "machining.jsonl");
execFileSync(symplant, ["run", "examples/gallery/machining/plant.json", "--scenario", "examples/gallery/machining/scenario.json", "--trace", trace], {cwd: kProject});
await withPlant(["show", trace, "examples/gallery/machining/plant.json"], async () => {
  await view("view=line");
  await page.getByRole("slider").fill("4000");
  await page.waitForTimeout(700);
  await picture("recording");
});

await browser.close();
rmSync(work, {recursive: true, force: true});
process.exit(0);
