// What a person operates at the panel, in a real browser: first at a real plant, a push button, a selector, a jog, a set point; then against
// the mock server of tests/panel, what a real plant does not do on demand: a release that gets lost, comments, buttons in no device.
//
// usage: node faceplates_test.mjs PLAYWRIGHT_FOLDER AXE_FOLDER [SYMPLANT]   without SYMPLANT against the mock server only
// Exit code: 0 passed, 1 failed, 77 there is no chromium
import assert from "node:assert/strict";
import {mkdtempSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {startServer} from "../../panel/mock/server.mjs";
import {Browser, until} from "./browser.mjs";
import {startProgram} from "./plants.mjs";

const [playwright, axe, symplant] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "panel-faceplates-"));
const browser = await Browser.open({playwright, axe});
const kExpected = /ERR_|Failed to fetch|status of 4\d\d|net::/;

const kList = [["START_I_PUSH", "X0", "BOOL", "FALSE"], ["MODE_I_AUTO", "X1", "BOOL", "FALSE"], ["CYL_I_RET", "X2", "BOOL", "TRUE"], ["CYL_I_ADV", "X3", "BOOL", "FALSE"],
  ["CYL_O_ADV", "Y0", "BOOL", "FALSE"], ["CYL_O_RET", "Y1", "BOOL", "FALSE"], ["CYL_O_SPEED", "%QW10", "INT", "0"]];
const kPlant = {symplant: 1, name: "faceplates", symbols: ["list.csv"], values: {"L_S1_CYL.load": {start: 20, min: 0, max: 200, unit: "kg"}}};

/// A plant of one station, written into the folder.
const startPlant = () => {
  writeFileSync(join(folder, "list.csv"), ["Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment",
    ...kList.map(([name, address, type, initial]) => ["VAR_GLOBAL", "L_S1_" + name, ...(address.startsWith("%") ? ["", address] : [address, ""]), type, initial, ""].join())].join("\n"));
  writeFileSync(join(folder, "plant.json"), JSON.stringify(kPlant));
  return startProgram(symplant, ["run", join(folder, "plant.json"), "--panel", "127.0.0.1:0"]);
};

const details = (page) => page.getByRole("complementary", {name: "Details"});
const ready = (page) => page.waitForSelector("body[data-ready]");
const open = (page, device) => page.evaluate((name) => { location.hash = "view=line&device=" + name; }, device).then(() => details(page).getByRole("heading", {name: device, exact: true}).waitFor());
const openSymbol = (page, name) => page.evaluate((of) => { location.hash = "view=line&symbol=" + of; }, name).then(() => details(page).getByRole("heading", {name, exact: true}).waitFor());
const value = (page, name) => page.evaluate((of) => symplant.store.values[symplant.names.index("symbol", of)], name);
const state = (page, name) => page.evaluate((of) => {
  const index = symplant.names.index("device", of);
  return symplant.plant.devices[index].states[symplant.store.state[index]];
}, name);
const shows = async (of, to) => {
  const now = await of;
  return now === to ? true : "it is " + now;
};
const becomes = (page, name, to) => until(name + " is " + to, () => shows(value(page, name), to));
const puts = (page, device, to) => until(device + " is in " + to, () => shows(state(page, device), to));
const press = async (page, element) => {
  await element.hover();
  await page.mouse.down();
};
const away = async (page) => page.mouse.move(5, 5);
const stays = async (page, name, of, time = 300) => {
  await page.waitForTimeout(time);
  assert.equal(await value(page, name), of, name);
};
const noFaults = async (page, where) => {
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({colorScheme, reducedMotion: "reduce"});
    assert.deepEqual(await browser.faults(page), [], where + ", " + colorScheme);
  }
};

/// [what, step] at the real plant, in order.
const kSteps = [
  ["a push button is on while the mouse button is down, in one step, in its tile", async (page) => {
    const hold = page.getByRole("region", {name: "Station L S1"}).getByRole("button", {name: "Hold, L_S1_START"});
    await press(page, hold);
    await becomes(page, "L_S1_START_I_PUSH", true);
    assert.equal(await state(page, "L_S1_START"), "PUSH");
    await stays(page, "L_S1_START_I_PUSH", true);
    assert.equal(await hold.getAttribute("aria-pressed"), "true");
    await page.mouse.up();
    await becomes(page, "L_S1_START_I_PUSH", false);
  }],
  ["a push button is on while a key is down on it, in its faceplate", async (page) => {
    await open(page, "L_S1_START");
    await details(page).getByRole("button", {name: "Hold PUSH"}).focus();
    for (const key of ["Space", "Enter"]) {
      await page.keyboard.down(key);
      await becomes(page, "L_S1_START_I_PUSH", true);
      await page.keyboard.down(key);  // as a key that repeats
      await stays(page, "L_S1_START_I_PUSH", true);
      await page.keyboard.up(key);
      await becomes(page, "L_S1_START_I_PUSH", false);
    }
    await page.keyboard.down("Space");
    await becomes(page, "L_S1_START_I_PUSH", true);
    await page.keyboard.press("Tab");  // the focus leaves it
    await becomes(page, "L_S1_START_I_PUSH", false);
    await page.keyboard.up("Space");
    await noFaults(page, "the faceplate of a button");
  }],
  ["a selector is switched in one step, and back", async (page) => {
    const change = () => page.getByRole("region", {name: "Station L S1"}).getByRole("button", {name: /^→ .*L_S1_MODE/});
    await change().click();
    await puts(page, "L_S1_MODE", "AUTO");
    await becomes(page, "L_S1_MODE_I_AUTO", true);
    await until("its text", async () => /NOT_AUTO/.test(await change().innerText()));
    await open(page, "L_S1_MODE");
    await until("the marked state", async () => await details(page).getByRole("button", {name: "AUTO", exact: true}).getAttribute("aria-pressed") === "true");
    await details(page).getByRole("button", {name: "NOT_AUTO", exact: true}).click();
    await puts(page, "L_S1_MODE", "NOT_AUTO");
  }],
  ["a jog that is let go outside of the button is off", async (page) => {
    await open(page, "L_S1_CYL");
    const jog = details(page).getByRole("listitem").filter({hasText: "L_S1_CYL_O_ADV"}).getByRole("button", {name: "Jog"});
    await press(page, jog);
    await becomes(page, "L_S1_CYL_O_ADV", true);
    await away(page);
    await becomes(page, "L_S1_CYL_O_ADV", false);  // already when the pointer leaves it
    await page.mouse.up();
    await stays(page, "L_S1_CYL_O_ADV", false);
  }],
  ["a jog ends with the focus of the window, and with its faceplate", async (page) => {
    const jog = details(page).getByRole("listitem").filter({hasText: "L_S1_CYL_O_ADV"}).getByRole("button", {name: "Jog"});
    await press(page, jog);
    await becomes(page, "L_S1_CYL_O_ADV", true);
    await page.evaluate(() => dispatchEvent(new Event("blur")));
    await becomes(page, "L_S1_CYL_O_ADV", false);
    await page.mouse.up();
    await press(page, jog);
    await becomes(page, "L_S1_CYL_O_ADV", true);
    await page.keyboard.press("Escape");
    await page.mouse.up();
    await becomes(page, "L_S1_CYL_O_ADV", false);
  }],
  ["a jog ends when the page is closed or loaded again", async (page) => {
    await open(page, "L_S1_CYL");
    await press(page, details(page).getByRole("listitem").filter({hasText: "L_S1_CYL_O_ADV"}).getByRole("button", {name: "Jog"}));
    await becomes(page, "L_S1_CYL_O_ADV", true);
    await page.reload();
    await ready(page);
    await page.mouse.up();
    await becomes(page, "L_S1_CYL_O_ADV", false);
  }],
  ["on and off of an operation act at once, and show what is", async (page) => {
    await open(page, "L_S1_CYL");
    const item = details(page).getByRole("listitem").filter({hasText: "L_S1_CYL_O_ADV"});
    await item.getByRole("button", {name: "Set on"}).click();
    await becomes(page, "L_S1_CYL_O_ADV", true);
    await puts(page, "L_S1_CYL", "ADV");
    await until("the marked button", async () => await item.getByRole("button", {name: "Set on"}).getAttribute("aria-pressed") === "true");
    await item.getByRole("button", {name: "Set off"}).click();
    await becomes(page, "L_S1_CYL_O_ADV", false);
  }],
  ["a set point is entered, and moved by its slider", async (page) => {
    const item = details(page).getByRole("listitem").filter({hasText: "L_S1_CYL_O_SPEED"});
    await item.getByRole("textbox", {name: "Number for L_S1_CYL_O_SPEED"}).fill("1500");
    await page.keyboard.press("Enter");
    await becomes(page, "L_S1_CYL_O_SPEED", 1500);
    const slider = item.getByRole("slider", {name: "L_S1_CYL_O_SPEED"});
    await until("the range of the slider", async () => await slider.getAttribute("max") === "2000");
    await slider.focus();
    await page.keyboard.press("Home");
    await becomes(page, "L_S1_CYL_O_SPEED", 0);
    const load = details(page).getByRole("slider", {name: "L_S1_CYL.load"});
    await load.focus();
    await page.keyboard.press("End");
    await until("the load", async () => await page.evaluate(() => symplant.store.numbers[0]) === 200);
    await item.getByRole("textbox", {name: "Number for L_S1_CYL_O_SPEED"}).fill("fast");
    await page.keyboard.press("Enter");
    await until("the error", async () => /`fast` is not a number/.test(await details(page).getByRole("status").first().innerText()));
    await noFaults(page, "the faceplate of a cylinder");
  }],
];

/// [what, test] against the mock server; each gets a separate page, and the server.
const kMockTests = [
  ["a release that is lost is tried until it is done, and the page says so until then", async (page, server, net) => {
    await openSymbol(page, "LINE_S1_PB_I_START");
    const button = details(page).getByRole("button", {name: /Press|still pressed/});
    await press(page, button);
    await becomes(page, "LINE_S1_PB_I_START", true);
    net.lost = true;
    for (const stream of server.streams) stream.destroy();
    await until("the button", async () => await button.innerText() === "still pressed");
    await until("the notice", async () => /LINE_S1_PB_I_START is still pressed/.test(await page.getByRole("alert").innerText()));
    const index = server.plant.description.symbols.findIndex(({name}) => name === "LINE_S1_PB_I_START");
    assert.equal(server.plant.value(index), true);
    await noFaults(page, "a button that is still pressed");
    net.lost = false;
    await until("the release", async () => server.plant.value(index) === false);
    await until("the end of the notice", async () => !/still pressed/.test(await page.getByRole("alert").innerText()));
    await until("the button", async () => await button.innerText() === "Press");
    await page.mouse.up();
  }],
  ["what was held when the page was loaded again without a connection is released as soon as it has one", async (page, server, net) => {
    await openSymbol(page, "LINE_S1_PB_I_START");
    await press(page, details(page).getByRole("button", {name: "Press"}));
    await becomes(page, "LINE_S1_PB_I_START", true);
    Object.assign(net, {lost: true, status: 503});  // the browser sends a last request that the test cannot hold back
    await page.reload();
    await page.waitForTimeout(300);
    const index = server.plant.description.symbols.findIndex(({name}) => name === "LINE_S1_PB_I_START");
    assert.equal(server.plant.value(index), true);
    Object.assign(net, {lost: false, status: 0});
    await until("the release", async () => server.plant.value(index) === false);
    await page.mouse.up();
  }],
  ["an act that the plant refuses is shown at the control, and leaves nothing held", async (page, server, net) => {
    net.status = 403;
    const start = page.getByRole("region", {name: "Station LINE S1"}).getByRole("button", {name: "Hold, LINE_S1_START"});
    await press(page, start);
    await until("the reason", async () => /denied by the test/.test(await start.locator("xpath=ancestor::*[contains(@class,'tile-box')]").innerText()));
    await page.mouse.up();
    assert.equal(await start.getAttribute("aria-pressed"), "false");
    net.status = 0;
    assert.equal(await page.evaluate(() => symplant.holds.held.size), 0);
  }],
  ["a button in no device has its comment and acts in one step; an inverted one is on by its meaning, with a mark", async (page, server) => {
    const panel = page.getByRole("region", {name: "Operator panel of LINE S1"});
    await press(page, panel.getByRole("button", {name: "Press LINE_S1_PB_I_STOP"}));
    await becomes(page, "LINE_S1_PB_I_STOP", false);
    await page.mouse.up();
    await becomes(page, "LINE_S1_PB_I_STOP", true);
    const entry = panel.getByRole("listitem").filter({hasText: "Stop (opener)"});
    assert.equal(await entry.getByTitle(/^inverted/).count(), 1);
    assert.doesNotMatch(await entry.innerText(), /bit/);
    await panel.getByRole("listitem").filter({hasText: "Start"}).getByRole("button", {name: "Set on"}).click();
    await becomes(page, "LINE_S1_PB_I_START", true);
    await noFaults(page, "the operator panel");
  }],
  ["comments are in tiles, details, I/O and search", async (page) => {
    const tile = page.getByRole("region", {name: "Station LINE S1"}).getByRole("link", {name: /^CLAMP1/});
    assert.match(await tile.innerText(), /Clamp 1 left side/);
    assert.match(await tile.getAttribute("title"), /O_CLOSE: Clamp 1 left side, close/);
    await page.getByRole("combobox", {name: "Search"}).fill("spindle speed");
    await page.getByRole("option").filter({hasText: "LINE_S1_MOTOR_O_SPEED"}).click();
    await until("the comment", async () => /Spindle speed in 1\/min/.test(await details(page).innerText()));
    await page.evaluate(() => { location.hash = "view=io"; });
    await page.getByRole("searchbox", {name: "Filter by name, address or comment"}).fill("no such comment");
    await until("no rows", async () => /^0 of/.test(await page.getByRole("main").getByRole("status").first().innerText()));
    await page.getByRole("searchbox", {name: "Filter by name, address or comment"}).fill("automatic");
    await until("the row", async () => await page.getByRole("row").filter({hasText: "Selector automatic"}).count() === 1);
  }],
  ["an operation that a PLC writes can only be forced, and says what writes it", async (page) => {
    await open(page, "LINE_S1_PUMP");
    const item = details(page).getByRole("listitem").filter({hasText: "LINE_S1_PUMP_O_RUN"});
    assert.match(await item.innerText(), /written by the PLC over modbus-tcp-server/);
    assert.equal(await item.getByRole("button", {name: /Jog|Set/}).count(), 0);
    await item.getByRole("button", {name: "Force on"}).click();
    await becomes(page, "LINE_S1_PUMP_O_RUN", true);
    await noFaults(page, "the faceplate of a pump");
  }],
  ["an act in progress is shown until its answer", async (page, server, net) => {
    net.delay = 800;
    const change = page.getByRole("region", {name: "Station LINE S1"}).getByRole("button", {name: /^→ .*LINE_S1_DOOR/});
    await change.click();
    assert.equal(await change.getAttribute("aria-busy"), "true");
    await until("the answer", async () => await change.getAttribute("aria-busy") === null);
    await puts(page, "LINE_S1_DOOR", "NOT_SHUT");
  }],
];

let failed = 0;
const step = async (what, page, run) => {
  const begin = Date.now();
  try {
    await run();
    console.log("ok " + what + " (" + (Date.now() - begin) + " ms)");
    return true;
  } catch (error) {
    ++failed;
    console.log("not ok " + what + "\n" + error.stack);
    if (process.env.SYMPLANT_SHOT) await page.screenshot({path: process.env.SYMPLANT_SHOT});
    return false;
  }
};

const atPlant = async () => {
  const plant = await startPlant();
  const page = await browser.page();
  await page.goto(plant.link + "&view=line");
  await ready(page);
  for (const [what, run] of kSteps) if (!await step(what, page, () => run(page))) break;
  await page.close();
  await plant.stop();
};

const atServer = async (what, test) => {
  const net = {lost: false, status: 0, delay: 0};
  const server = await startServer({name: "operated", deny: (path) => path === "acts" ? net.status : 0, delay: () => net.delay});
  const page = await browser.page(kExpected);
  await page.route("**/*", (route) => net.lost && route.request().url().includes("/api/") ? route.abort() : route.fallback());
  await page.goto(server.link + "&view=line");
  await ready(page);
  await step(what, page, () => test(page, server, net));
  await page.close();
  await server.stop();
};

if (symplant) await atPlant();
for (const [what, test] of kMockTests) await atServer(what, test);
for (const problem of browser.problems) console.log("the browser reports: " + problem);
failed += browser.problems.length;
await browser.close();
rmSync(folder, {recursive: true, force: true});
console.log(failed === 0 ? "passed" : failed + " failed");
process.exit(failed === 0 ? 0 : 1);
