// Measures the 3D view in headless Chromium, whose 3D is computed by the processor: the bytes that it loads, its first picture, and frames with 200
// devices and 100 moving parts. Nothing is asserted: run it by hand on a machine that does nothing else.
//
// usage: node performance_3d.mjs PLAYWRIGHT_FOLDER AXE_FOLDER [LINK]   LINK: of the panel of a program, whose bytes are compressed
import {Browser, kSoftware3d} from "./browser.mjs";
import {startServer} from "../../panel/mock/server.mjs";

const kSeconds = 10;
const [playwright, axe, link = null] = process.argv.slice(2);
const browser = await Browser.open({playwright, axe, graphics: kSoftware3d});
const server = link ? null : await startServer({name: "scene"});
const page = await browser.page(/./);
const session = await page.context().newCDPSession(page);
let bytes = 0;
await session.send("Network.enable");
await page.goto(link ?? server.link);
await page.waitForSelector("body[data-ready]");
await page.waitForTimeout(500);
session.on("Network.loadingFinished", ({encodedDataLength}) => { bytes += encodedDataLength; });
const opened = await page.evaluate(async () => {
  const begin = performance.now();
  symplant.router.view("3d");
  while (!(symplant.view3d?.drawn > 0)) await new Promise((done) => requestAnimationFrame(done));
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  return performance.now() - begin;
});
console.log("the first picture in 3D: " + opened.toFixed(0) + " ms after the click");
await page.waitForTimeout(500);
console.log("loaded for it: " + (bytes / 1000).toFixed(0) + " kB");

const measure = async (what) => {
  const drawn = () => page.evaluate(() => [symplant.view3d.drawn, performance.now()]);
  const [before, from] = await drawn();
  await page.waitForTimeout(kSeconds * 1000);
  const [after, to] = await drawn();
  console.log(what + ": " + ((after - before) / (to - from) * 1000).toFixed(1) + " frames/s");
};
const {devices, parts} = await page.evaluate(() => ({devices: symplant.plant.devices.length, parts: symplant.store.tracks.reduce((sum, track) => sum + track.parts.length, 0)}));
await measure(devices + " devices, " + parts + " parts, everything in view");
await page.evaluate(() => symplant.view3d.stage.zoom(.3));
await measure("the same, near");
await browser.close();
process.exit(0);
