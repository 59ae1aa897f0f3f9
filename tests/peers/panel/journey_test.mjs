// The journey of journey.mjs in a real browser, with one browser and one plant; then axe-core on every view in light and dark.
//
// usage: node journey_test.mjs PLAYWRIGHT_FOLDER AXE_FOLDER [SYMPLANT]   without SYMPLANT against the mock server
// Exit code: 0 passed, 1 failed, 77 there is no chromium
import {mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {Browser, finish} from "./browser.mjs";
import {kSteps} from "./journey.mjs";
import {startBodyShop} from "./plants.mjs";

const kViews = ["view=plan", "view=plan&station=BODY UNDER10&device=BODY_UNDER10_CLAMP1", "view=line", "view=line&station=BODY UNDER10&device=BODY_UNDER10_CLAMP1", "view=io&symbol=BODY_UNDER10_CLAMP1_I_CLOSE", "view=chart", "view=alarms", "view=findings",
  "view=links", "view=malfunctions", "view=exercises", "view=session", "view=utilization"];

const [playwright, axe, symplant] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "panel-journey-"));
const browser = await Browser.open({playwright, axe});
const plant = await startBodyShop(symplant, folder);
const page = await browser.page(/status of 422/);
let failed = 0;

/// Before the last step, which ends the plant.
const checkViews = async () => {
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({colorScheme, reducedMotion: "reduce"});
    for (const view of kViews) {
      await page.evaluate((hash) => { location.hash = hash; }, view);
      await page.waitForTimeout(600);
      const faults = await browser.faults(page);
      for (const fault of faults) console.log(colorScheme + ", " + view + ": " + fault);
      failed += faults.length;
    }
  }
  await page.evaluate(() => { location.hash = "view=session"; });
};

try {
  for (const [index, [what, step]] of kSteps.entries()) {
    if (index === kSteps.length - 1) await checkViews();
    const begin = Date.now();
    await step({page, link: plant.link, plant, folder, symplant});
    console.log("ok " + what + " (" + (Date.now() - begin) + " ms)");
  }
} catch (error) {
  ++failed;
  console.log(error.stack);
  if (process.env.SYMPLANT_SHOT) await page.screenshot({path: process.env.SYMPLANT_SHOT});
}
await finish(browser, failed, async () => {
  await plant.stop();
  rmSync(folder, {recursive: true, force: true});
});
