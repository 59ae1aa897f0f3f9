// What a commissioner and a trainer do at the panel of the body-shop line, step by step, by roles and names as a user sees them.
import assert from "node:assert/strict";
import {readFileSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {until} from "./browser.mjs";
import {lastRun, replay} from "./plants.mjs";

const kClamp = "BODY_UNDER10_CLAMP1";

const open = async (page, view) => page.getByRole("navigation", {name: "Views"}).getByRole("link", {name: view, exact: true}).click();
const details = (page) => page.getByRole("complementary", {name: "Details"});
const textOf = (locator) => locator.innerText();

const kConflict = "finding: conflicting operations of " + kClamp;
const alarmRow = (page, name) => page.locator(".alarm-row[data-alarm='" + name + "']:visible");
const isAlarm = async (page, name, state) => await alarmRow(page, name).count() === 1 && (await textOf(alarmRow(page, name))).includes("\n" + state + "\n");

/// Selects a device or symbol by the search field.
const find = async (page, text, name) => {
  await page.getByRole("combobox", {name: "Search"}).fill(text);
  await page.getByRole("option").filter({hasText: name}).first().click();
  await details(page).getByRole("heading", {name, exact: true}).waitFor();
};

const setState = async (page, device, state) => {
  await find(page, device, device);
  await details(page).getByRole("group", {name: "State of " + device}).getByRole("button", {name: state, exact: true}).click();
  await until(device + " in " + state, async () => (await textOf(details(page))).includes(state + "\n"));
};

const setSymbol = async (page, name, label) => {
  const item = details(page).getByRole("listitem").filter({hasText: name});
  await item.getByRole("button", {name: label}).click();
  await until("the result", async () => / at [\d.]+ s/.test(await textOf(details(page).getByRole("status").first())));
};

/// [what, step] in order; each gets { page, link, plant, folder, symplant }.
export const kSteps = [
  ["the overview shows the stations of the line", async ({page, link}) => {
    await page.goto(link);
    await page.getByRole("application", {name: "Plan of the plant"}).waitFor();
    await open(page, "Tiles");
    await page.getByRole("region", {name: "Stations"}).waitFor();
    assert.ok(await page.getByRole("region", {name: "Stations"}).getByRole("link").count() >= 40);
    assert.ok(!page.url().includes("token"), "the token is still in the address bar");
  }],
  ["air fails, a clamp is commanded and waits", async ({page}) => {
    await setState(page, "BODY_UNDER10_AIR", "NOT_GOOD");
    await page.getByRole("region", {name: "Stations"}).getByRole("link", {name: /^BODY UNDER10 /}).click();
    await page.getByRole("region", {name: "Station BODY UNDER10"}).getByRole("link", {name: /^CLAMP1/}).click();
    await setSymbol(page, kClamp + "_O_CLOSE", "Set on");
    await until("blocked", async () => /has a command and does not move/.test(await textOf(details(page))));
  }],
  ["why says that the air disables it, and leads there", async ({page}) => {
    const why = details(page).getByRole("region", {name: "Why"});
    await until("why", async () => /BODY_UNDER10_AIR/.test(await textOf(why)));
    await why.getByRole("link", {name: "BODY_UNDER10_AIR", exact: true}).first().click();
    await setState(page, "BODY_UNDER10_AIR", "GOOD");
    await find(page, kClamp, kClamp);
    await until("the clamp closed", async () => /\nCLOSE\n/.test(await textOf(details(page))));
  }],
  ["a sensor is forced in the I/O view", async ({page}) => {
    await open(page, "I/O");
    await page.getByRole("searchbox", {name: "Filter by name, address or comment"}).fill(kClamp + "_I_CLOSE");
    const row = page.getByRole("row").filter({hasText: kClamp + "_I_CLOSE"});
    await row.getByRole("button", {name: "Force off"}).click();
    await until("forced", async () => /off, forced/.test(await textOf(row)));
    await page.getByRole("link", {name: "1 forced"}).waitFor();
  }],
  ["the plant is frozen, stepped and a snapshot is taken", async ({page}) => {
    await page.getByRole("button", {name: "Freeze"}).click();
    await page.getByRole("button", {name: "Run", exact: true}).waitFor();
    const time = page.getByRole("timer", {name: "Plant time"});
    const before = await textOf(time);
    await page.waitForTimeout(400);
    assert.equal(await textOf(time), before);
    await page.getByRole("button", {name: "Step cycle"}).click();
    await until("the result of the step", async () => /ran one cycle at/.test(await textOf(page.getByRole("banner"))));
    await open(page, "Session");
    await page.getByRole("textbox", {name: "Name of the snapshot"}).fill("clamp forced");
    await page.getByRole("button", {name: "Take snapshot"}).click();
    await page.getByRole("button", {name: "Restore clamp forced"}).waitFor();
  }],
  ["the snapshot is restored with its force", async ({page}) => {
    await page.getByRole("button", {name: "Run", exact: true}).click();
    await page.getByRole("button", {name: "Release all"}).click();
    await page.getByRole("link", {name: "0 forced"}).waitFor();
    await page.getByRole("button", {name: "Restore clamp forced"}).click();
    await page.getByRole("link", {name: "1 forced"}).waitFor();
    await page.getByRole("button", {name: "Release all"}).click();
    const run = page.getByRole("button", {name: "Run", exact: true});
    if (await run.count() > 0) await run.click();
    await page.getByRole("button", {name: "Freeze"}).waitFor();
  }],
  ["a malfunction sticks a clamp and is stopped", async ({page}) => {
    await find(page, "UNDER10 CLAMP2", "BODY_UNDER10_CLAMP2");
    await details(page).getByRole("button", {name: "stuck", exact: true}).click();
    await page.getByRole("link", {name: "1 malfunction"}).click();
    const active = page.getByRole("region", {name: "Active malfunctions"});
    await active.getByRole("rowheader", {name: "BODY_UNDER10_CLAMP2 stuck"}).waitFor();
    await setSymbol(page, "BODY_UNDER10_CLAMP2_O_CLOSE", "Set on");
    await until("stuck", async () => /has a command and does not move/.test(await textOf(details(page))));
    await active.getByRole("button", {name: "Stop BODY_UNDER10_CLAMP2 stuck"}).click();
    await page.getByRole("link", {name: "0 malfunctions"}).waitFor();
  }],
  ["the chart shows the clamp", async ({page}) => {
    await find(page, kClamp, kClamp);
    await details(page).getByRole("button", {name: "Show in chart"}).click();
    // The restore began the chart again. Since then the release of the sensor is sure to be in it, but no move of the clamp.
    await until("data", async () => page.evaluate((name) => {
      const row = symplant.chart.rows.find(({kind, index}) => kind === "symbol" && symplant.names.name(kind, index) === name);
      return row.data.times.length > 1;
    }, kClamp + "_I_CLOSE"));
    const plot = page.getByRole("application", {name: /^Chart/});
    await plot.click({position: {x: 100, y: 60}});
    await plot.press("Shift+ArrowLeft");
    await plot.click({position: {x: 300, y: 60}, modifiers: ["Shift"]});
    await until("the time between the cursors", async () => /from A to B/.test(await textOf(page.getByRole("main"))));
    const [vcd] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", {name: "Export VCD"}).click()]);
    assert.match(readFileSync(await vcd.path(), "utf8"), /\$var string 1 ! BODY_UNDER10_CLAMP1 \$end/);
    const [png] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", {name: "Export PNG"}).click()]);
    assert.equal(readFileSync(await png.path()).subarray(1, 4).toString(), "PNG");
  }],
  ["utilization counts the moves of the clamp, as a table and as CSV, and begins again", async ({page}) => {
    await open(page, "Utilization");
    const main = page.getByRole("main");
    await main.getByRole("group", {name: "Rows"}).getByRole("button", {name: "Devices"}).click();
    await main.getByRole("searchbox", {name: "Filter by name"}).fill(kClamp);
    const row = main.getByRole("row").filter({has: page.getByRole("link", {name: kClamp, exact: true})});
    const {index, moves, whole} = await page.evaluate(async (name) => {
      const of = symplant.names.index("device", name);
      const {devices, from, to} = await symplant.api.utilization();
      return {index: of, moves: devices[of][2], whole: Math.abs(devices[of][0].reduce((a, b) => a + b) - (to - from))};
    }, kClamp);
    assert.ok(whole < 1, "the times of a device do not add up to the whole time");
    await until(moves + " moves", async () => (await row.getByRole("cell").allInnerTexts())[5] === String(moves) || await row.getByRole("cell").allInnerTexts());
    await row.getByRole("button", {name: "Times of " + kClamp}).click();
    const {states} = await page.evaluate((of) => symplant.api.utilization(of), index);
    const dialog = page.getByRole("dialog");
    for (const state of Object.keys(states)) await dialog.getByRole("rowheader", {name: state, exact: true}).waitFor();
    await dialog.getByRole("button", {name: "Close"}).click();
    await main.getByRole("columnheader", {name: "Moving"}).getByRole("button").click();
    assert.equal(await main.getByRole("columnheader", {name: "Moving"}).getAttribute("aria-sort"), "descending");
    const [csv] = await Promise.all([page.waitForEvent("download"), main.getByRole("button", {name: "Download CSV"}).click()]);
    assert.equal(csv.suggestedFilename(), "utilization.csv");
    await main.getByRole("button", {name: "Count again"}).click();
    await until("the result", async () => /began to count utilization again at/.test(await textOf(main)));
  }],
  ["an exercise is done to its score", async ({page}) => {
    await open(page, "Exercises");
    await page.getByRole("button", {name: "Trainee", exact: true}).click();
    await page.getByRole("button", {name: "Start Clamps without air"}).click();
    await page.getByRole("status").filter({hasText: "Bring the air back"}).waitFor();
    await setState(page, "BODY_UNDER10_AIR", "GOOD");
    await page.getByRole("status").filter({hasText: "Close clamp 1"}).waitFor();
    await find(page, kClamp, kClamp);
    await setSymbol(page, kClamp + "_O_CLOSE", "Set on");
    await page.getByRole("main").getByText("The exercise is over.").waitFor();
    assert.match(await textOf(page.getByRole("region", {name: "Exercise", exact: true})), /20 of 20 points/);
  }],
  ["an alarm comes, is acknowledged, goes, and leaves the list", async ({page, plant}) => {
    if (!plant.real) return;
    await open(page, "Alarms");
    assert.equal(await alarmRow(page, kConflict).count(), 0);
    await page.evaluate((name) => symplant.api.acts({set: {[name + "_O_OPEN"]: true}}), kClamp);  // next to CLOSE
    await until("active", () => isAlarm(page, kConflict, "active"));
    assert.match(await textOf(page.getByRole("group", {name: "Alarms that are not acknowledged"})), /[1-9]\d* medium/);
    const acknowledge = alarmRow(page, kConflict).getByRole("button", {name: "Acknowledge " + kConflict});
    await acknowledge.focus();
    await page.keyboard.press("Enter");
    await until("acknowledged", () => isAlarm(page, kConflict, "acknowledged"));
    await page.evaluate((name) => symplant.api.acts({set: {[name + "_O_OPEN"]: false}}), kClamp);
    await until("no alarm", async () => await alarmRow(page, kConflict).count() === 0);
  }],
  ["an alarm is shelved, comes back after its plant time, and all that is shown is acknowledged", async ({page, plant}) => {
    if (!plant.real) return;
    await page.evaluate((name) => symplant.api.acts({set: {[name + "_O_OPEN"]: true}}), kClamp);
    await until("active", () => isAlarm(page, kConflict, "active"));
    await page.getByRole("combobox", {name: "Shelve for"}).selectOption("1 min");
    await alarmRow(page, kConflict).getByRole("button", {name: "Shelve " + kConflict + " for 1 min"}).click();
    const shelved = page.getByRole("region", {name: "Shelved alarms"}).getByRole("row").filter({hasText: kClamp});
    await shelved.waitFor();
    await until("gone from the list", async () => await alarmRow(page, kConflict).count() === 0);
    await page.getByRole("combobox", {name: "Speed"}).selectOption("100 x");
    await until("active again", () => isAlarm(page, kConflict, "active"), 30000);
    assert.equal(await shelved.count(), 0);
    await page.getByRole("combobox", {name: "Speed"}).selectOption("1 x");
    await page.getByRole("combobox", {name: "Priority"}).selectOption("Medium");
    await page.getByRole("button", {name: "Acknowledge all shown"}).click();
    await until("acknowledged", () => isAlarm(page, kConflict, "acknowledged"));
    await page.getByRole("combobox", {name: "Priority"}).selectOption("All priorities");
  }],
  ["the horn sounds for an urgent alarm in a browser that switched it on, until it is silenced", async ({page, plant}) => {
    if (!plant.real) return;
    await page.evaluate((name) => symplant.api.acts({state: {[name]: "CLOSE", BODY_UNDER10_PIN1: "DOWN"}}), kClamp);
    await until("a violated requirement", () => isAlarm(page, "requirement: UNDER10: clamps close on raised pins only", "active"));
    assert.equal(await page.evaluate(() => symplant.store.alarms.horn), true);
    const horn = page.getByRole("button", {name: "Horn"});
    assert.equal(await horn.getAttribute("aria-pressed"), "false");
    await horn.click();
    assert.equal(await horn.getAttribute("aria-pressed"), "true");
    await page.getByRole("button", {name: "Silence"}).click();
    await until("silence", async () => !await page.evaluate(() => symplant.store.alarms.horn));
    await horn.click();
  }],
  ["an act that is not possible shows the server's text", async ({page}) => {
    await open(page, "Session");
    await page.getByRole("textbox", {name: "Name of the snapshot"}).fill("../climbs");
    await page.getByRole("button", {name: "Take snapshot"}).click();
    await until("the error", async () => await page.locator(".result.wrong").count() === 1);
  }],
  ["the session is a scenario that replays to the same trace", async ({page, plant, folder, symplant}) => {
    const [file] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", {name: "Download Scenario"}).click()]);
    const scenario = join(folder, "session.scenario.json");
    writeFileSync(scenario, readFileSync(await file.path()));
    assert.match(readFileSync(scenario, "utf8"), /BODY_UNDER10_CLAMP1_O_CLOSE/);
    if (!plant.real) return;
    const replayed = await replay(symplant, scenario, folder);
    await page.goto("about:blank");
    await plant.stop();
    const live = lastRun(join(folder, "live.jsonl"));
    assert.ok(replayed.length > 3);
    assert.deepEqual(live.slice(0, replayed.length), replayed);
    assert.ok(live.slice(replayed.length).every(({t}) => t > replayed[replayed.length - 1].t));
  }],
];
