// Trends of an oven in a real browser: curves of values and of symbols that are numbers, axes, cursors with differences, bits and states, and the
// files that the chart writes. Then axe-core on the chart and on the line view.
//
// usage: node trends_test.mjs PLAYWRIGHT_FOLDER AXE_FOLDER SYMPLANT
// Exit code: 0 passed, 1 failed, 77 there is no chromium
import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {Browser, finish, runTests, until} from "./browser.mjs";
import {startProgram} from "./plants.mjs";

const kTemp = "oven.temp";
const kPower = "HEAT_O1_HEATER_O_POWER";
const kSensor = "HEAT_O1_OVEN_I_TEMP";
const kDoor = "HEAT_O1_DOOR";
const kRows = [kTemp, "oven.probe", kPower, kSensor, kDoor, "HEAT_O1_DOOR_I_OPEN"];

const [playwright, axe, symplant] = process.argv.slice(2);
const browser = await Browser.open({playwright, axe});
const start = (name) => startProgram(symplant, ["run", "examples/" + name + "/plant.json", "--panel", "127.0.0.1:0"]);
const plant = await start("oven");
const page = await browser.page();
const act = (...acts) => page.evaluate((list) => symplant.api.acts(...list), acts);
const time = (seconds) => until("plant time", () => page.evaluate((t) => symplant.clock.now() >= t * 1e9, seconds), 30000);
const view = (name) => page.getByRole("navigation", {name: "Views"}).getByRole("link", {name, exact: true}).click();
const details = page.getByRole("complementary", {name: "Details"});
const plot = page.getByRole("application", {name: /^Chart/});
const legend = page.getByRole("list", {name: "Rows of the chart, with their present values"});
const cursors = page.getByRole("region", {name: "Values at the cursors"});
const cells = async (name) => cursors.getByRole("row").filter({has: page.getByRole("rowheader", {name, exact: true})}).getByRole("cell").allInnerTexts();
const download = async (name) => {
  const [file] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", {name, exact: true}).click()]);
  return readFileSync(await file.path());
};
const number = (text) => Number.parseFloat(text);

const kSteps = [
  ["curves are chosen from details and by the field, and are there again after a reload", async () => {
    await page.goto(plant.link);
    await page.waitForSelector("body[data-ready]");
    await page.getByRole("combobox", {name: "Search"}).fill(kTemp);
    await page.keyboard.press("Enter");
    await details.getByRole("button", {name: "Show in chart"}).click();
    for (const name of kRows.slice(1)) {
      await page.getByRole("combobox", {name: "Add a symbol, device or value"}).fill(name);
      await page.getByRole("option").filter({hasText: name}).first().click();
    }
    await details.getByRole("button", {name: "Close the details"}).click();
    await page.reload();
    await page.waitForSelector("body[data-ready]");
    for (const name of kRows) await legend.getByRole("link", {name, exact: true}).or(legend.getByRole("button", {name: "Remove " + name})).first().waitFor();
  }],
  ["the legend has the present value of each row, with its unit", async () => {
    await act({set: {[kPower]: 20000}}, {state: {[kDoor]: "OPEN"}}, {speed: 20});
    const now = (name) => legend.locator('[data-row="' + name + '"] .present');
    await until("a warm oven", async () => number(await now(kTemp).innerText()) > 22);
    assert.match(await now(kTemp).innerText(), /^[\d.]+ degC$/);
    assert.equal(await now(kPower).innerText(), "20000");
    assert.equal(await now(kDoor).innerText(), "OPEN");
    assert.equal(await now("HEAT_O1_DOOR_I_OPEN").innerText(), "on");
    await time(20);
    await act({state: {[kDoor]: "NOT_OPEN"}}, {set: {[kPower]: 8000}});
    await time(40);
    await act({freeze: true});
    await page.getByRole("button", {name: "All", exact: true}).click();
    await until("all data", () => page.evaluate(() => symplant.chart.until >= symplant.store.t));
    // The axes took width from the plot: its canvases follow.
    await until("canvases as wide as the plot", () => plot.evaluate((element) => {
      const widths = [...element.children].map((canvas) => canvas.clientWidth);
      return widths.every((width) => width === element.clientWidth) || [element.clientWidth, ...widths].join();
    }));
  }],
  ["two cursors show the time and value of each row at both, and the differences", async () => {
    const {width} = await plot.boundingBox();
    await plot.click({position: {x: Math.round(width * .2), y: 120}});
    await plot.click({position: {x: Math.round(width * .8), y: 120}, modifiers: ["Shift"]});
    await until("the differences", async () => (await cells(kTemp)).length === 3 || await cells(kTemp));
    assert.deepEqual(await cursors.getByRole("columnheader").allInnerTexts(), ["Row", "A", "B", "B − A"]);
    const [a, b, between] = (await cells("Time")).map(number);
    assert.ok(Math.abs(b - a - between) < .001 && between > 10, [a, b, between].join());
    const [before, after, rise] = (await cells(kTemp)).map(number);
    assert.ok(rise > 0 && Math.abs(after - before - rise) < .02, [before, after, rise].join());
    assert.match((await cells(kTemp))[2], /^\+[\d.]+ degC$/);
    assert.deepEqual(await cells(kPower), ["20000", "8000", "-12000"]);
    assert.deepEqual(await cells(kDoor), ["OPEN", "NOT_OPEN", "1 change"]);
    assert.deepEqual(await cells("HEAT_O1_DOOR_I_OPEN"), ["on", "off", "1 change"]);
    await page.getByRole("status").filter({hasText: /^A [\d.]+ s, B [\d.]+ s, from A to B/}).waitFor();
  }],
  ["the cursors obey the keys", async () => {
    await plot.focus();
    await page.keyboard.press("c");
    await until("no table", async () => !await cursors.isVisible());
    await page.keyboard.press("a");
    await until("one column", async () => (await cells(kPower)).length === 1);
    await page.keyboard.press("Shift+ArrowRight");  // to the change of the door
    await page.keyboard.press("b");
    await until("two cursors", async () => (await cells(kPower)).length === 3);
  }],
  ["CSV has all rows with units, and each change", async () => {
    const lines = (await download("Export CSV")).toString().trim().split("\n").map((line) => line.split(","));
    assert.deepEqual(lines[0], ["time [s]", "oven.temp [degC]", "oven.probe [degC]", ...kRows.slice(2)]);
    assert.ok(lines.every((line) => line.length === lines[0].length));
    const column = (name) => lines.slice(1).map((line) => line[lines[0].findIndex((head) => head.startsWith(name))]);
    assert.ok(column("time").every((t, i, all) => i === 0 || Number(t) > Number(all[i - 1])));
    assert.deepEqual([...new Set(column(kPower))].filter((text) => text), ["0", "20000", "8000"]);
    assert.ok(column(kDoor + "_I_OPEN").includes("true") && column(kDoor).includes("OPEN"));
    assert.ok(new Set(column("oven.temp")).size > 20);
  }],
  ["VCD has all rows: reals with their units, integers, bits and states", async () => {
    const text = (await download("Export VCD")).toString();
    for (const [kind, name] of [["real 64", kTemp], ["real 64", "oven.probe"], ["integer 64", kPower], ["integer 64", kSensor], ["string 1", kDoor], ["wire 1", kDoor + "_I_OPEN"]]) {
      const id = text.match(new RegExp("\\$var " + kind + " (\\S+) " + name + " \\$end"))?.[1];
      assert.ok(id, name);
      const changes = text.split("\n").filter((line) => line.endsWith(kind === "wire 1" ? id : " " + id) && !line.startsWith("$"));
      assert.ok(changes.length > 1, name + " has " + changes.length + " changes");
    }
    assert.match(text, /\$comment oven.temp is in degC \$end/);
  }],
  ["PNG has twice the resolution, with names, axes and curves", async () => {
    const png = await download("Export PNG");
    assert.equal(png.subarray(1, 4).toString(), "PNG");
    const size = {width: png.readUInt32BE(16), height: png.readUInt32BE(20)};
    const shown = await plot.evaluate(({clientWidth, clientHeight}) => ({clientWidth, clientHeight}));
    assert.ok(size.width > 2 * (shown.clientWidth + 300) && size.height >= 2 * shown.clientHeight, JSON.stringify([size, shown]));
    // The colors of the curves are in the plot and in the legend at its left.
    const found = await page.evaluate(async ({bytes, names}) => {
      const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)], {type: "image/png"}));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext("2d");
      context.drawImage(bitmap, 0, 0);
      const {data} = context.getImageData(0, 0, canvas.width, canvas.height);
      const style = getComputedStyle(document.documentElement);
      const has = (name, from, until) => {
        const color = style.getPropertyValue("--" + name).trim();
        const wanted = [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16));
        for (let i = 0; i < data.length; i += 4) {
          const x = i / 4 % canvas.width;
          if (x >= from && x < until && wanted.every((part, k) => Math.abs(data[i + k] - part) < 12)) return true;
        }
        return false;
      };
      return names.map((name) => [has(name, 0, 100), has(name, canvas.width - 400, canvas.width)]);
    }, {bytes: [...png], names: ["trend0", "trend1", "trend2"]});
    assert.deepEqual(found, [[true, true], [true, true], [true, true]]);
  }],
  ["whole ranges are offered where a value has limits, and remembered", async () => {
    const whole = page.getByRole("button", {name: "Whole ranges"});
    assert.ok(!await whole.isVisible(), "the oven's values have no limits");
    const tank = await start("gallery/tank");
    try {
      await page.goto(tank.link);
      await page.waitForSelector("body[data-ready]");
      await page.evaluate(() => symplant.chart.addValue(symplant.names.index("value", "level")));
      await page.getByRole("button", {name: "Freeze"}).click();
      await page.waitForTimeout(600);
      const axis = () => page.locator(".chart-scales canvas").evaluate((canvas) => canvas.toDataURL());
      const automatic = await axis();
      await whole.click();
      await until("another axis", async () => await axis() !== automatic);
      await page.reload();
      await until("pressed after a reload", async () => await whole.getAttribute("aria-pressed") === "true");
      await plot.press("y");
      await until("the axis of what is in view", async () => await axis() === automatic);
    } finally {
      await page.goto(plant.link);
      await page.waitForSelector("body[data-ready]");
      await tank.stop();
    }
  }],
  ["no fault in the chart, the tiles and the plan, in light and dark", async () => {
    for (const colorScheme of ["light", "dark"]) {
      await page.emulateMedia({colorScheme, reducedMotion: "reduce"});
      for (const name of ["Chart", "Tiles", "Plan"]) {
        await view(name);
        await page.waitForTimeout(600);
        assert.deepEqual(await browser.faults(page), [], colorScheme + ", " + name);
      }
    }
  }],
];

await finish(browser, await runTests(kSteps, {inOrder: true, page}), () => plant.stop());
