// The page on a phone: no view of real plants is wider than 390 pixels, nothing overlaps, and axe-core finds no fault.
//
// usage: node phone_test.mjs PLAYWRIGHT_FOLDER AXE_FOLDER SYMPLANT
// Exit code: 0 passed, 1 failed, 77 there is no chromium
import {Browser} from "./browser.mjs";
import {startProgram} from "./plants.mjs";

const kSize = {width: 390, height: 844};
const kPlants = [["body-shop", "--exercise", "examples/body-shop/no-air.json"], ["oven"]];

const [playwright, axe, symplant] = process.argv.slice(2);
const browser = await Browser.open({playwright, axe});
const page = await browser.page();
await page.setViewportSize(kSize);
await page.emulateMedia({reducedMotion: "reduce"});
let failed = 0;

/// The fragments of all views, and of the details of a thing of each kind.
const fragments = () => page.evaluate(() => {
  const {plant} = symplant;
  const lists = {device: plant.devices, symbol: plant.symbols, location: plant.locations, requirement: plant.requirements, value: plant.values};
  const of = (fragment) => new URLSearchParams(fragment).toString();
  return [...[...document.querySelectorAll("#views a")].map(({hash}) => hash.slice(1)), of({view: "plan", station: plant.stations[0].name}), of({view: "line", station: plant.stations[0].name}),
    ...Object.entries(lists).filter(([, list]) => list.length > 0).map(([kind, [{name}]]) => of({view: "line", [kind]: name}))];
});

/// How wide the page is, and what reaches out of it without being cut by something that scrolls.
const width = () => page.evaluate(() => document.documentElement.scrollWidth);

for (const [name, ...more] of kPlants) {
  const plant = await startProgram(symplant, ["run", "examples/" + name + "/plant.json", "--panel", "127.0.0.1:0", ...more]);
  await page.goto("about:blank");
  await page.goto(plant.link);
  await page.waitForSelector("body[data-ready]");
  await page.evaluate(() => {
    symplant.chart.addDevice(0);
    if (symplant.plant.values.length > 0) symplant.chart.addValue(0);
  });
  await page.waitForTimeout(500);
  await page.getByRole("application", {name: /^Chart/}).click({position: {x: 60, y: 60}});
  await page.getByRole("button", {name: "Freeze"}).click();
  for (const fragment of await fragments()) {
    await page.evaluate((to) => { location.hash = to; }, fragment);
    await page.waitForTimeout(350);
    const wide = await width();
    const faults = [...(wide > kSize.width ? ["is " + wide + " pixels wide"] : []), ...await browser.faults(page)];
    for (const fault of faults) console.log("not ok " + name + " " + fragment + ": " + fault);
    failed += faults.length;
  }
  console.log("looked at " + name);
  await plant.stop();
}
for (const problem of browser.problems) console.log("the browser reports: " + problem);
failed += browser.problems.length;
await browser.close();
console.log(failed === 0 ? "passed" : failed + " failed");
process.exit(failed === 0 ? 0 : 1);
