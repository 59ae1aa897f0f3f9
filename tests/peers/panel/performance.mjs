// Measures the page in headless Chromium: the first picture of a large plant, frames with moving parts, a stream of many changes.
// The mock server runs in its own process. Nothing is asserted: run it by hand on a machine that does nothing else.
//
// usage: node performance.mjs PLAYWRIGHT_FOLDER AXE_FOLDER
import {spawn} from "node:child_process";
import {join} from "node:path";
import {Browser} from "./browser.mjs";
import {kProject} from "./plants.mjs";

const kSeconds = 10;
const [playwright, axe] = process.argv.slice(2);
const browser = await Browser.open({playwright, axe});

const startMock = async (...args) => {
  const child = spawn(process.execPath, [join(kProject, "tests/panel/mock/server.mjs"), ...args]);
  const link = await new Promise((done) => child.stdout.on("data", (piece) => done(/http\S+/.exec(piece)[0])));
  return {link, stop: () => child.kill()};
};

const metrics = async (session) => Object.fromEntries((await session.send("Performance.getMetrics")).metrics.map(({name, value}) => [name, value]));

/// Frames that the page drew in a second, how long the longest task was, and the share of time that the page's thread worked.
const measure = async (page) => {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable");
  await page.evaluate(() => {
    globalThis.longest = 0;
    globalThis.events = 0;
    globalThis.changes = 0;
    globalThis.endCount?.();
    globalThis.endCount = symplant.store.listen(({devices}) => {
      ++globalThis.events;
      globalThis.changes += devices.length;
    });
    new PerformanceObserver((list) => { for (const {duration} of list.getEntries()) globalThis.longest = Math.max(globalThis.longest, duration); })
      .observe({type: "longtask"});
    globalThis.framesBefore = symplant.frames.count;
  });
  const before = await metrics(session);
  await page.waitForTimeout(kSeconds * 1000);
  const after = await metrics(session);
  const seen = await page.evaluate(() => ({frames: symplant.frames.count - globalThis.framesBefore, longest: globalThis.longest, events: globalThis.events,
    changes: globalThis.changes}));
  const wall = after.Timestamp - before.Timestamp;
  const percent = (key) => (100 * (after[key] - before[key]) / wall).toFixed(0) + " %";
  return (seen.frames / wall).toFixed(1) + " frames/s, " + (seen.events / wall).toFixed(1) + " events/s with " + (seen.changes / wall).toFixed(0) + " changes of devices/s, longest task " + seen.longest.toFixed(0) + " ms, thread busy "
    + percent("TaskDuration") + " (script " + percent("ScriptDuration") + ", style and layout " + (100 * (after.LayoutDuration + after.RecalcStyleDuration
    - before.LayoutDuration - before.RecalcStyleDuration) / wall).toFixed(0) + " %), heap " + (after.JSHeapUsedSize / 1e6).toFixed(0) + " MB";
};

/// From a press on a view's name until it is drawn.
const response = async (page, name) => page.evaluate(async (text) => {
  const link = [...document.querySelectorAll("nav a")].find((of) => of.textContent === text);
  const begin = performance.now();
  link.click();
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  return (performance.now() - begin).toFixed(0) + " ms";
}, name);

const open = async (plant, ...args) => {
  const server = await startMock(plant, ...args);
  const page = await browser.page(/./);
  await page.goto(server.link);
  await page.waitForSelector("body[data-ready]", {timeout: 30000});
  return {server, page};
};

for (let i = 0; i < 3; ++i) {
  const {server, page} = await open("body-shop", "--activity", "100");
  const drawn = await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(performance.now())))));
  const ready = await page.evaluate(() => performance.getEntriesByName("first picture")[0]?.startTime ?? NaN);
  console.log("first picture of 1,185 devices: " + ready.toFixed(0) + " ms after the navigation, drawn before " + drawn.toFixed(0) + " ms");
  await page.close();
  server.stop();
}
{
  const {server, page} = await open("symbols");
  console.log("plan of 1,000 devices, 200 parts: " + await measure(page));
  await page.evaluate(() => symplant.router.view("line"));
  await page.waitForSelector(".material");
  await page.evaluate(() => document.querySelector(".material").scrollIntoView());
  console.log("3,000 symbols, 200 parts, tracks in view: " + await measure(page));
  await page.setViewportSize({width: 1920, height: 3200});
  await page.evaluate(() => document.querySelector(".material").scrollIntoView());
  console.log("the same in a window of 1920 x 3200, all tracks in view: " + await measure(page));
  await page.close();
  server.stop();
}
{
  const {server, page} = await open("large");
  await page.setViewportSize({width: 1280, height: 800});
  console.log("10,000 devices, 10,667 motions/s, plan: " + await measure(page));
  await page.evaluate(() => symplant.router.view("line"));
  console.log("overview: " + await measure(page));
  for (const name of ["I/O", "Findings", "Tiles", "Plan"]) console.log("  " + name + " is drawn " + await response(page, name) + " after the click");
  await page.evaluate(() => symplant.router.view("line", {station: symplant.plant.stations[3].name}));
  console.log("one station: " + await measure(page));
  await page.evaluate(() => symplant.router.view("io"));
  console.log("I/O: " + await measure(page));
  await page.evaluate(() => { symplant.chart.addDevice(40); symplant.chart.addDevice(41); });
  console.log("chart: " + await measure(page));
  await page.close();
  server.stop();
}
await browser.close();
process.exit(0);
