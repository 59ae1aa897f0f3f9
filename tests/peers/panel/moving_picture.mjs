// Makes the moving picture of README.md from a real run: docs/pictures/panel.png, an animated PNG.
//
// usage: node moving_picture.mjs PLAYWRIGHT_FOLDER AXE_FOLDER UPNG_FOLDER SYMPLANT FILE
import {writeFileSync} from "node:fs";
import {createRequire} from "node:module";
import {join} from "node:path";
import {Browser, until} from "./browser.mjs";
import {startProgram} from "./plants.mjs";

const kFolder = "examples/gallery/machining/";
const kEnd = 20, kStep = 0.5;     // of plant time, in s
const kFrame = 250;               // ms that a frame is shown
const kSize = [1000, 680];
const kColors = 64;
const kMost = 700000;             // bytes of the picture

const [playwright, axe, upng, symplant, file] = process.argv.slice(2);
const UPNG = createRequire(join(upng, "node_modules/"))("upng-js");
const browser = await Browser.open({playwright, axe});
const plant = await startProgram(symplant, ["run", kFolder + "plant.json", "--scenario", kFolder + "scenario.json", "--panel", "127.0.0.1:0"]);
const page = await browser.page(/./);
await page.setViewportSize({width: kSize[0], height: kSize[1]});
await page.goto(plant.link);
await page.waitForSelector("body[data-ready]");

const frames = [];
for (let at = 0; at <= kEnd; at += kStep) {
  await until("plant time", () => page.evaluate((t) => symplant.clock.now() >= t * 1e9, at), 60000);
  frames.push(UPNG.toRGBA8(UPNG.decode(await page.screenshot()))[0]);
}
const bytes = Buffer.from(UPNG.encode(frames, ...kSize, kColors, frames.map(() => kFrame)));
writeFileSync(file, bytes);
console.log(file + ": " + frames.length + " frames, " + bytes.length + " bytes");
if (bytes.length > kMost) throw new Error(file + " is too large");

await page.goto("about:blank");
await plant.stop();
await browser.close();
process.exit(0);
