// A lesson in a real browser: a trainer and two trainees, each in a browser context; a malfunction starts, one trainee reacts, and the
// trainer's table shows the time. Then a message to all, and the files.
//
// usage: node training_test.mjs PLAYWRIGHT_FOLDER AXE_FOLDER SYMPLANT [FOLDER_FOR_PICTURES]
// Exit code: 0 passed, 1 failed, 77 there is no chromium
import assert from "node:assert/strict";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {Browser, finish, until} from "./browser.mjs";
import {startProgram} from "./plants.mjs";

const kPlant = "examples/gallery/malfunctions/plant.json";
const kMalfunction = "clamp 1 stuck";
const kCommand = "BB_S10_CLAMP1_O_SHUT";
const kReset = "BB_S10_ALARM_O_RESET";
const [playwright, axe, symplant, pictures] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "panel-training-"));
const browser = await Browser.open({playwright, axe});
const kTokens = {trainer: "a".repeat(32), trainee: "b".repeat(32), viewer: "c".repeat(32)};
const kLesson = {"symplant-scenario": 1, exercise: {title: "Shut the clamp", text: "Find why it stays open.", allow: [kReset]},
  steps: [{wait: "BB_S10_CLAMP1.SHUT", within: "10min", text: "Shut the clamp"}]};
writeFileSync(join(folder, "tokens"), Object.values(kTokens).join("\n"));
writeFileSync(join(folder, "clamp.json"), JSON.stringify(kLesson));
const plant = await startProgram(symplant, ["run", kPlant, "--panel", "127.0.0.1:0", "--panel-trainee", "--panel-token", join(folder, "tokens"),
  "--panel-files", folder, "--exercise", join(folder, "clamp.json")]);
let failed = 0;

/// A page in a separate browser context, with the exercises view.
const person = async (role) => {
  const context = await browser.context.browser().newContext({viewport: {width: 1280, height: 800}, acceptDownloads: true});
  const page = await context.newPage();
  page.on("pageerror", (error) => browser.problems.push(error.stack));
  page.on("console", (message) => { if (message.type() === "error" && !/status of 4(03|22)/.test(message.text())) browser.problems.push(message.text()); });
  await page.goto(plant.link.split("#")[0] + "#token=" + kTokens[role]);
  await page.waitForSelector("body[data-ready]");
  await page.getByRole("navigation", {name: "Views"}).getByRole("link", {name: "Exercises", exact: true}).click();
  return page;
};

const joins = async (page, name) => {
  await page.getByRole("textbox", {name: "Your name"}).fill(name);
  await page.getByRole("button", {name: "Join"}).click();
  await page.getByText("You are " + name).waitFor();
};

/// Sets an operation by its details, as a trainee does.
const setOn = async (page, name) => {
  await page.getByRole("combobox", {name: "Search"}).fill(name);
  await page.getByRole("option").filter({hasText: name}).first().click();
  await page.getByRole("complementary", {name: "Details"}).getByRole("button", {name: "Set on"}).first().click();
};

const effect = (page) => page.evaluate(() => symplant.store.training.malfunctions[0].effect);
const act = (page, ...acts) => page.evaluate((list) => symplant.api.acts(...list), acts);
const trainees = (page) => page.getByRole("table", {name: "Trainees"});
const reactions = (page) => page.getByRole("table", {name: "Reaction times"});

const check = async (page, name) => {
  for (const colorScheme of ["light", "dark"]) {
    for (const [width, height] of [[1280, 800], [390, 844]]) {
      await page.setViewportSize({width, height});
      await page.emulateMedia({colorScheme, reducedMotion: "reduce"});
      await page.waitForTimeout(200);
      if (width > 1000) {
        for (const fault of await browser.faults(page)) {
          console.log(name + ", " + colorScheme + ": " + fault);
          ++failed;
        }
      }
      if (pictures) await page.screenshot({path: join(pictures, name + "-" + width + "-" + colorScheme + ".png")});
    }
  }
  await page.setViewportSize({width: 1280, height: 800});
};

try {
  const [trainer, anna, ben] = [await person("trainer"), await person("trainee"), await person("trainee")];
  await trainer.getByText("No trainee has joined").waitFor();
  await joins(anna, "Anna");
  await joins(ben, "민준");
  await trainees(trainer).getByRole("rowheader", {name: "Anna"}).waitFor();
  await trainees(trainer).getByRole("rowheader", {name: "민준"}).waitFor();

  await trainer.getByRole("button", {name: "Start Shut the clamp", exact: true}).click();
  await anna.getByRole("status").filter({hasText: "Shut the clamp"}).waitFor();
  await trainer.getByRole("button", {name: "Start " + kMalfunction, exact: true}).click();
  await reactions(trainer).getByRole("rowheader", {name: kMalfunction}).waitFor();
  assert.equal(await effect(trainer), null);  // the clamp has no command yet
  await act(trainer, {set: {[kCommand]: true}});
  await until("the first effect", async () => await effect(trainer) !== null);
  await setOn(anna, kReset);
  await until("the reaction", () => trainer.evaluate(() => symplant.store.training.malfunctions[0].reactions.length === 1));
  const [[who, time]] = await trainer.evaluate(() => symplant.store.training.malfunctions[0].reactions);
  assert.equal(who, 0);
  const {t} = await trainer.evaluate(() => symplant.store.acts.find(({name, act: {set}}) => name === "Anna" && set));
  assert.equal(time, t - await effect(trainer));
  const row = reactions(trainer).getByRole("row").filter({hasText: kMalfunction});
  const cells = await row.getByRole("cell").allInnerTexts();
  assert.match(cells[3], /^[\d.]+ (ms|s)$/);
  assert.equal(cells[4], "-");
  const table = await trainees(trainer).getByRole("row").filter({hasText: "Anna"}).getByRole("cell").allInnerTexts();
  assert.equal(table[2], "1");
  assert.equal(table[4], cells[3]);

  await trainer.getByRole("textbox", {name: "Message"}).fill("Which valve did not open?\nSay it before you act.");
  await trainer.getByRole("button", {name: "Send"}).click();
  for (const page of [anna, ben]) {
    await page.getByRole("navigation", {name: "Views"}).getByRole("link", {name: "Tiles", exact: true}).click();
    await page.getByRole("log", {name: "Messages of the trainer"}).getByText("Which valve did not open?").waitFor();
  }
  await check(ben, "message");
  await anna.getByRole("button", {name: /^Close the message/}).click();
  await until("the message is gone", async () => await anna.getByText("Which valve did not open?").count() === 0);
  await anna.reload();
  await anna.waitForSelector("body[data-ready]");
  assert.equal(await anna.getByText("Which valve did not open?").count(), 0);
  await anna.getByRole("navigation", {name: "Views"}).getByRole("link", {name: "Exercises", exact: true}).click();
  await anna.getByText("You are Anna").waitFor();
  assert.equal(await ben.getByText("Which valve did not open?").count(), 1);
  await check(trainer, "trainer");
  await check(anna, "trainee");

  for (const [label, expected] of [["Trainees as CSV", /^name,first seen \[s\],[^]*\r\nAnna,[^]*\r\n민준,/], ["Reaction times as CSV", new RegExp("\r\n" + kMalfunction + ",[^]*,Anna,[0-9.]+\r\n")]]) {
    const [file] = await Promise.all([trainer.waitForEvent("download"), trainer.getByRole("button", {name: label}).click()]);
    assert.match(readFileSync(await file.path(), "utf8"), expected);
  }
  console.log("ok a lesson with a trainer and two trainees");
} catch (error) {
  ++failed;
  console.log(error.stack);
}
await finish(browser, failed, async () => {
  await plant.stop();
  rmSync(folder, {recursive: true, force: true});
});
