// The plan of the training line in a real browser: the first view, moving parts, zoom, keys, and a layout that is edited, saved and loaded again.
//
// usage: node plan_test.mjs PLAYWRIGHT_FOLDER AXE_FOLDER SYMPLANT
// Exit code: 0 passed, 1 failed, 77 there is no chromium
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {Browser, finish, runTests, until} from "./browser.mjs";
import {kProject, startProgram} from "./plants.mjs";

const kPicture = '<svg xmlns="http://www.w3.org/2000/svg" width="80" height="20"><script>globalThis.attacked = true</script><rect width="80" height="20" fill="#123456"/></svg>\n';
const kRam = "FT_C2_RAM";

const [playwright, axe, symplant] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "panel-plan-"));
const example = join(folder, "line");
const files = join(folder, "files");
cpSync(join(kProject, "examples/training-line"), example, {recursive: true});
mkdirSync(files);
writeFileSync(join(files, "hall.svg"), kPicture);
const start = (...more) => startProgram(symplant, ["run", join(example, "plant.json"), "--panel", "127.0.0.1:0", "--panel-files", files, ...more]);
const browser = await Browser.open({playwright, axe});
let plant = await start("--scenario", join(example, "shift.json"));
const page = await browser.page(/willReadFrequently|files\/hall\.svg/);
await page.setViewportSize({width: 1280, height: 800});

const board = (of = page) => of.getByRole("application", {name: "Plan of the plant"});
const bar = page.getByRole("group", {name: "Edit layout"});
const press = (name) => bar.getByRole("button", {name, exact: true}).click();
const details = page.getByRole("complementary", {name: "Details"});
const said = () => page.locator(".plan-view > [role=status]").innerText();
const load = async (of) => {
  await of.goto(plant.link);
  await of.waitForSelector("body[data-ready]");
  await of.waitForTimeout(400);
};
const go = async (hash) => {
  await page.evaluate((to) => { location.hash = to; }, hash);
  await page.waitForTimeout(500);
};

/// In the page: the middle of the pixels of the live layer that have the color of the first kind of parts; 0 without any.
const middleOfParts = () => page.evaluate(() => {
  const canvas = document.querySelector(".board .live");
  const {data, width} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let [sum, count] = [0, 0];
  for (let i = 0; i < data.length; i += 4) if (data[i] === 0xff && data[i + 1] === 0xcb && data[i + 2] === 0x30) [sum, count] = [sum + i / 4 % width, count + 1];
  return count === 0 ? 0 : sum / count;
});
const pictureOf = (layer) => page.evaluate((name) => document.querySelector(".board ." + name).toDataURL(), layer);
const placed = (of = page) => of.evaluate((name) => {
  const {layout: {placed: {devices, frames}}, names} = symplant;
  const {x, y, turn, frame} = devices[names.index("device", name)];
  return {x, y, turn, frame: frames[frame].name};
}, kRam);

/// The pixel of a device on the screen, once the view is at rest: it changes when the details close, two frames later.
const pixelOf = async (name) => {
  let at = await pixelNow(name);
  await until("a view at rest", async () => {
    await new Promise((done) => setTimeout(done, 100));
    const before = at;
    at = await pixelNow(name);
    return at.join() === before.join();
  });
  return at;
};
const pixelNow = async (name) => {
  const box = await board().boundingBox();
  const at = await page.evaluate((of) => {
    const {names} = symplant;
    const {camera, placed: now} = symplant.planView;
    const {x, y} = now.devices[names.index("device", of)];
    return camera.toScreen([x, y]);
  }, name);
  return [box.x + at[0], box.y + at[1]];
};

const kSteps = [
  ["the plan is the first view, and a part moves on its belt", async () => {
    await load(page);
    assert.match(page.url(), /#view=plan$/);
    assert.equal(await page.getByRole("navigation", {name: "Views"}).getByRole("link", {name: "Plan"}).getAttribute("aria-current"), "page");
    await until("a part", async () => await middleOfParts() > 0);
    await until("a part that moves to the right", async () => {
      const before = await middleOfParts();
      await page.waitForTimeout(300);
      return before > 0 && await middleOfParts() > before + 2;
    });
  }],
  ["nothing is drawn while nothing changes", async () => {
    await page.getByRole("button", {name: "Freeze"}).click();
    await page.getByRole("button", {name: "Run", exact: true}).waitFor();
    await page.waitForTimeout(1000);
    const [frames, live] = [await page.evaluate(() => symplant.frames.count), await pictureOf("live")];
    await page.waitForTimeout(1500);
    assert.ok(await page.evaluate(() => symplant.frames.count) - frames < 6, "the page draws frames");
    assert.equal(await pictureOf("live"), live);
  }],
  ["the wheel zooms at the pointer, and keys zoom, move the view and show the whole", async () => {
    const scale = () => page.evaluate(() => symplant.planView.camera.scale);
    await page.mouse.move(...await pixelOf(kRam));
    const [before, pixel] = [await scale(), await pixelOf(kRam)];
    await page.mouse.wheel(0, -600);
    await until("a larger scale", async () => await scale() > before * 1.5);
    (await pixelOf(kRam)).forEach((at, i) => assert.ok(Math.abs(at - pixel[i]) < 3, "the device under the pointer moved"));
    await board().focus();
    await page.keyboard.press("0");
    assert.equal(await scale(), before);
    await page.keyboard.press("+");
    assert.ok(await scale() > before);
    await page.keyboard.press("-");
    await page.keyboard.press("Shift+ArrowRight");
    assert.notDeepEqual(await pixelOf(kRam), pixel);
    await page.keyboard.press("0");
    await page.mouse.move(600, 300);
    await page.mouse.down();
    await page.mouse.move(700, 300, {steps: 3});
    await page.mouse.up();
    assert.ok(Math.abs((await pixelOf(kRam))[0] - pixel[0] - 100) < 3, "dragging moves the view");
    await page.getByRole("button", {name: "Whole plant"}).click();
  }],
  ["arrow keys move between things, a screen reader gets name and state, Enter and a click open the details", async () => {
    await board().focus();
    await page.keyboard.press("ArrowRight");
    const first = await said();
    assert.match(first, /^FT_C\d_\w+, \w+, .+, /);
    await page.keyboard.press("ArrowRight");
    await until("another thing", async () => await said() !== first);
    const name = (await said()).split(",")[0];
    await page.keyboard.press("Enter");
    await details.getByRole("heading", {name, exact: true}).waitFor();
    await page.keyboard.press("Escape");
    await details.waitFor({state: "hidden"});
    await page.mouse.click(...await pixelOf(kRam));
    await details.getByRole("heading", {name: kRam, exact: true}).waitFor();
    await page.keyboard.press("Escape");
  }],
  ["a station is among the things, and Enter shows it", async () => {
    const frame = await page.evaluate(() => symplant.planView.placed.frames.findIndex(({name}) => name === "FT C2"));
    await board().focus();
    await page.evaluate((index) => symplant.planView.focus({kind: "frame", index}), frame);
    assert.match(await said(), /^FT C2, station, 6 devices, /);
    await page.keyboard.press("Enter");
    await until("the station", async () => page.evaluate(() => symplant.router.route.station === "FT C2"));
    await page.keyboard.press("0");
    await until("the whole", async () => /#view=plan$/.test(page.url()) && page.evaluate(() => symplant.planView.camera.isWhole));
  }],
  ["a link and the search show a station", async () => {
    const scale = () => page.evaluate(() => symplant.planView.camera.scale);
    const whole = await scale();
    await go("view=plan&station=FT C3");
    assert.ok(await scale() > whole * 1.2);
    await go("view=io");
    await page.getByRole("combobox", {name: "Search"}).fill("ft c2");
    await page.getByRole("option").filter({hasText: "station"}).first().click();
    await until("the station", async () => /view=plan&station=FT\+C2/.test(page.url()));
    await until("its name in the list", async () => await page.getByRole("combobox", {name: "Station"}).inputValue() === "FT C2");
    await go("view=plan");
  }],
  ["a layout is edited: dragged on the grid, moved and turned by keys, undone, grouped", async () => {
    const before = await placed();
    await page.getByRole("button", {name: "Edit layout"}).click();
    const [x, y] = await pixelOf(kRam);
    const scale = await page.evaluate(() => symplant.planView.camera.scale);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 2.1 * scale, y - 1.1 * scale, {steps: 4});
    await page.mouse.up();
    const now = () => page.evaluate((name) => symplant.planView.placed.devices[symplant.names.index("device", name)], kRam);
    assert.deepEqual([(await now()).x, (await now()).y], [before.x + 2, before.y - 1]);
    await board().focus();
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("r");
    assert.deepEqual([(await now()).x, (await now()).turn], [before.x + 1.5, 90]);
    await page.keyboard.press("Control+z");
    assert.equal((await now()).turn, 0);
    await press("Redo");
    assert.equal((await now()).turn, 90);
    await page.mouse.click(...await pixelOf("FT_C3_RAM"));
    await page.keyboard.down("Shift");
    await page.mouse.click(...await pixelOf("FT_C3_LIFT"));
    await page.keyboard.up("Shift");
    await bar.getByRole("textbox", {name: "Name of the group"}).fill("Safety");
    await press("Group");
    assert.ok(await page.evaluate(() => symplant.planView.placed.frames.some(({name, devices}) => name === "Safety" && devices.length === 2)));
    assert.deepEqual(await placed(), before, "the layout of all changed before it was saved");
  }],
  ["a stray key, another view or Cancel loses no edit without a question", async () => {
    await board().focus();
    await page.keyboard.press("Escape");
    await go("view=io");
    await go("view=plan");
    assert.ok(await bar.isVisible());
    await press("Cancel");
    await page.getByRole("dialog").getByRole("button", {name: "Cancel"}).click();
    assert.ok(await bar.isVisible());
    assert.equal(await page.evaluate((name) => symplant.planView.placed.devices[symplant.names.index("device", name)].turn, kRam), 90);
  }],
  ["a picture of the folder is behind it, and no script in it runs", async () => {
    const choice = bar.getByRole("combobox", {name: "Picture behind the plan"});
    await until("the pictures", async () => await choice.getByRole("option").count() === 2);
    await choice.selectOption("hall.svg");
    await bar.getByRole("spinbutton", {name: "Opacity of the picture"}).fill("1");
    await bar.getByRole("spinbutton", {name: "Opacity of the picture"}).press("Enter");
    await until("its color", () => page.evaluate(() => {
      const canvas = document.querySelector(".board .still");
      const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      for (let i = 0; i < data.length; i += 4) if (data[i] === 0x12 && data[i + 1] === 0x34 && data[i + 2] === 0x56) return true;
      return false;
    }));
    assert.equal(await page.evaluate(() => "attacked" in globalThis), false);
    assert.deepEqual(await browser.faults(page), []);
  }],
  ["a picture that is missing or broken is reported, and can be loaded again", async () => {
    const note = page.getByRole("alert").filter({hasText: "hall.svg"});
    const again = async () => page.evaluate(() => symplant.planView.background.load());
    rmSync(join(files, "hall.svg"));
    await again();
    assert.match(await note.innerText(), /The picture hall\.svg is not shown: .*hall\.svg.* is neither in the folder/);
    writeFileSync(join(files, "hall.svg"), "<svg");
    await note.getByRole("button", {name: "Try again"}).click();
    await note.filter({hasText: "the browser cannot show it"}).waitFor();
    assert.deepEqual(await browser.faults(page), []);
    writeFileSync(join(files, "hall.svg"), kPicture);
    await note.getByRole("button", {name: "Try again"}).click();
    await until("the picture", () => page.evaluate(() => symplant.planView.background.shown()?.image.width === 4096));
    assert.ok(!await note.isVisible());
  }],
  ["it is saved: others see it at once, and the page says what to add to plant.json", async () => {
    const other = await browser.page();
    await load(other);
    const before = await placed();
    await press("Save");
    const note = page.locator(".plan-view .note:not([role])");
    await note.waitFor();
    assert.match(await note.innerText(), /layout\.json\. Add "include": \["layout\.json"\] to plant\.json/);
    assert.ok(!await bar.isVisible());
    await until("the layout in another tab", async () => (await placed(other)).turn === 90);
    assert.deepEqual(await placed(other), {...before, x: before.x + 1.5, y: before.y - 1, turn: 90});
    await other.close();
  }],
  ["the saved layout is loaded again from plant.json", async () => {
    const saved = await placed();
    await page.goto("about:blank");
    await plant.stop();
    assert.ok(existsSync(join(files, "layout.json")));
    cpSync(join(files, "layout.json"), join(example, "layout.json"));
    const text = readFileSync(join(example, "plant.json"), "utf8");
    writeFileSync(join(example, "plant.json"), text.replace('"symplant": 1,', '"symplant": 1, "include": ["layout.json"],'));
    plant = await start();
    await load(page);
    await until("the layout", async () => (await placed()).turn === 90);
    assert.deepEqual(await placed(), saved);
    assert.ok(await page.evaluate(() => symplant.layout.placed.frames.some(({name}) => name === "Safety")));
  }],
  ["Automatic goes back to the layout without positions", async () => {
    await page.getByRole("button", {name: "Edit layout"}).click();
    await press("Automatic");
    assert.ok(!await page.evaluate(() => symplant.planView.placed.frames.some(({name}) => name === "Safety")));
    await press("Undo");
    assert.ok(await page.evaluate(() => symplant.planView.placed.frames.some(({name}) => name === "Safety")));
    await press("Cancel");
  }],
  ["a recording has the plan, too", async () => {
    const trace = join(folder, "shift.jsonl");
    execFileSync(symplant, ["run", join(example, "plant.json"), "--scenario", join(example, "shift.json"), "--trace", trace]);
    const shown = await startProgram(symplant, ["show", trace, join(example, "plant.json"), "--panel", "127.0.0.1:0"]);
    const other = await browser.page(/status of 404/);  // a recording has no folder of pictures
    await other.goto(shown.link);
    await other.waitForSelector("body[data-ready]");
    await until("its layout", async () => (await placed(other)).turn === 90);
    assert.equal(await other.getByRole("button", {name: "Edit layout"}).count(), 0);
    await other.goto("about:blank");
    await shown.stop();
    await other.close();
  }],
  ["no fault at three sizes, in light and dark", async () => {
    for (const [width, height] of [[1440, 900], [1024, 768], [390, 844]]) {
      await page.setViewportSize({width, height});
      for (const colorScheme of ["light", "dark"]) {
        await page.emulateMedia({colorScheme, reducedMotion: "reduce"});
        await page.waitForTimeout(400);
        assert.deepEqual(await browser.faults(page), [], width + " " + colorScheme);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= width, "wider than " + width);
      }
    }
  }],
];

await finish(browser, await runTests(kSteps, {inOrder: true, page}), async () => {
  await plant.stop();
  rmSync(folder, {recursive: true, force: true});
});
