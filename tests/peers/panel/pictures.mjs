// Makes the pictures of docs/panel.md from real runs: docs/pictures/panel-*.png.
//
// usage: node pictures.mjs PLAYWRIGHT_FOLDER AXE_FOLDER SYMPLANT FOLDER
import {execFileSync} from "node:child_process";
import {mkdtempSync, rmSync, statSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {Browser, until} from "./browser.mjs";
import {kExercise, kProject, startProgram} from "./plants.mjs";

const kMost = 150000;  // bytes of a picture
const [playwright, axe, symplant, folder] = process.argv.slice(2);
const browser = await Browser.open({playwright, axe});
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
  await picture("line");
  await page.evaluate(() => symplant.chart.addDevice(symplant.names.index("device", "BODY_UNDER10_CLAMP1")));
  await page.evaluate(() => symplant.chart.addDevice(symplant.names.index("device", "BODY_UNDER10_ROBOT1")));
  await time(9);
  await page.getByRole("application").click({position: {x: 160, y: 60}});
  await page.getByRole("application").click({position: {x: 300, y: 60}, modifiers: ["Shift"]});
  await page.waitForTimeout(700);
  await picture("chart");
});
await withPlant(["run", "examples/body-shop/plant.json", "--exercise", kExercise], async () => {
  await act({state: {BODY_UNDER10_AIR: "NOT_GOOD"}}, {set: {BODY_UNDER10_CLAMP1_O_CLOSE: true}});
  await act({force: {BODY_UNDER10_DOOR1_I_SHUT: false}});
  await view("view=line&station=BODY+UNDER10&device=BODY_UNDER10_CLAMP1");
  await picture("station");
  await view("view=io");
  await page.getByRole("searchbox", {name: "Filter by name or address"}).fill("under10");
  await page.setViewportSize({width: 1120, height: 480});
  await page.waitForTimeout(500);
  await picture("io");
  await page.setViewportSize({width: 1120, height: 700});
  await act({exercise: "no-air"});
  await act({state: {BODY_UNDER10_AIR: "GOOD"}});
  await view("view=exercises");
  await page.getByRole("button", {name: "Trainer", exact: true}).click();
  await picture("exercise");
});
await withPlant(["run", "examples/gallery/machining/plant.json", "--scenario", "examples/gallery/machining/scenario.json"], async () => {
  await time(15.2);
  await picture("material");
});
const trace = join(work, "machining.jsonl");
execFileSync(symplant, ["run", "examples/gallery/machining/plant.json", "--scenario", "examples/gallery/machining/scenario.json", "--trace", trace], {cwd: kProject});
await withPlant(["show", trace, "examples/gallery/machining/plant.json"], async () => {
  await page.getByRole("slider").fill("4000");
  await page.waitForTimeout(700);
  await picture("recording");
});

await browser.close();
rmSync(work, {recursive: true, force: true});
process.exit(0);
