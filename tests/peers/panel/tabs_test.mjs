// Several tabs of one browser, and acts without an answer, with a real plant: a browser opens only six connections to a server, and
// queues what comes after them.
//
// usage: node tabs_test.mjs PLAYWRIGHT_FOLDER AXE_FOLDER SYMPLANT
// Exit code: 0 passed, 1 failed, 77 there is no chromium
import assert from "node:assert/strict";
import {Browser, until} from "./browser.mjs";
import {startProgram} from "./plants.mjs";

const kTabs = 8;
const kPlant = ["run", "examples/cell/plant.json", "--panel"];

const [playwright, axe, symplant] = process.argv.slice(2);
const browser = await Browser.open({playwright, axe});
const kLost = /ERR_|Failed to fetch|status of 4\d\d/;

const start = (port = 0) => startProgram(symplant, [...kPlant, "127.0.0.1:" + port]);
const open = async (link) => {
  const page = await browser.page(kLost);
  await page.goto(link);
  await page.waitForSelector("body[data-ready]", {timeout: 20000});
  return page;
};
const stateOf = (page) => page.evaluate(() => symplant.store.clock.state);
const resultOf = (page) => page.getByRole("banner").getByRole("status").first().innerText();
const press = (page, name) => page.getByRole("button", {name, exact: true}).click();

/// [what, test({plant})]; each has its own plant.
const kTests = [
  ["with eight tabs an act in the last one is done at once, and all tabs see it", async ({plant}) => {
    const pages = [];
    for (let i = 0; i < kTabs; ++i) pages.push(await open(plant.link));
    await press(pages[kTabs - 1], "Freeze");
    await until("the result", async () => /^froze at/.test(await resultOf(pages[kTabs - 1])) || await resultOf(pages[kTabs - 1]), 3000);
    for (const page of pages) await until("a frozen plant", async () => await stateOf(page) === "frozen");
    await pages[0].close();
    await press(pages[1], "Run");
    for (const page of pages.slice(1)) await until("a running plant", async () => await stateOf(page) === "running");
    const before = await pages[2].evaluate(() => symplant.store.t);
    await until("plant time goes on", async () => await pages[2].evaluate(() => symplant.store.t) > before);
    for (const page of pages.slice(1)) await page.close();
  }],
  ["a tab without a token shows next to one with a token, and does not act", async ({plant}) => {
    const [trainer, viewer] = [await open(plant.link), await open(new URL("/", plant.link).href)];
    await press(trainer, "Freeze");
    await until("a frozen plant", async () => await stateOf(viewer) === "frozen");
    assert.equal(await viewer.getByRole("button", {name: "Run", exact: true}).count(), 0);
    for (const page of [trainer, viewer]) await page.close();
  }],
  ["a browser without shared workers has a stream for each tab", async ({plant}) => {
    const page = await browser.page(kLost);
    await page.addInitScript(() => { delete globalThis.SharedWorker; });
    await page.goto(plant.link);
    await page.waitForSelector("body[data-ready]");
    await press(page, "Freeze");
    await until("a frozen plant", async () => await stateOf(page) === "frozen");
    await page.close();
  }],
  ["an act to a program that does not answer is shown as not done, and is not done later", async ({plant}) => {
    const [page, other] = [await open(plant.link), await open(plant.link)];
    plant.signal("SIGSTOP");
    await press(page, "Freeze");
    await until("the result", async () => /no answer within 3 s: not done/.test(await resultOf(page)) || await resultOf(page));
    plant.signal("SIGCONT");
    const since = await other.evaluate(() => symplant.store.t);
    await until("the plant goes on", async () => await other.evaluate(() => symplant.store.t) > since + 1e9);
    assert.equal(await stateOf(other), "running");
    assert.deepEqual(await other.evaluate(() => symplant.store.acts), []);
    await press(page, "Freeze");
    await until("a frozen plant", async () => await stateOf(other) === "frozen");
    for (const of of [page, other]) await of.close();
  }],
  ["a link pasted into a tab without a token is taken over at once, and its token leaves the address bar", async ({plant}) => {
    const page = await open(new URL("/#view=io", plant.link).href);
    await page.goto(plant.link + "&view=session");
    await until("the token is gone", async () => new URL(page.url()).hash === "#view=session" || page.url());
    await press(page, "Freeze");
    await until("a frozen plant", async () => await stateOf(page) === "frozen");
    await page.close();
  }],
  ["a link of a new run pasted into an old tab is taken over with its run", async ({plant}) => {
    const page = await open(plant.link);
    await page.evaluate(() => { location.hash = "view=io"; });
    await plant.stop();
    await until("the loss", async () => await page.evaluate(() => document.body.dataset.connection) === "lost");
    const next = await start(new URL(plant.link).port);
    try {
      await page.goto(next.link + "&view=session");
      await until("the new run", async () => {
        const answer = await (await fetch(new URL("/api/v1/plant", next.link))).json();
        return await page.evaluate(() => globalThis.symplant?.api.run).catch(() => null) === answer.run;
      });
      await page.waitForSelector("body[data-ready]");
      assert.equal(new URL(page.url()).hash, "#view=session");
      await press(page, "Freeze");
      await until("a frozen plant", async () => await stateOf(page) === "frozen");
      await page.close();
    } finally {
      await next.stop();
    }
  }],
  ["a token in the query of a link is taken too", async ({plant}) => {
    const {origin, hash} = new URL(plant.link);
    const page = await open(origin + "/?" + hash.slice(1) + "#view=io");
    assert.equal(page.url(), origin + "/#view=io");
    assert.equal(await page.getByRole("button", {name: "Freeze", exact: true}).count(), 1);
    await page.close();
  }],
];

let failed = 0;
for (const [what, test] of kTests) {
  if (process.argv[5] && !what.includes(process.argv[5])) continue;
  const plant = await start();
  try {
    await test({plant});
    console.log("ok " + what);
  } catch (error) {
    ++failed;
    console.log("not ok " + what + "\n" + error.stack);
  } finally {
    await plant.stop();
  }
  for (const page of browser.context.pages().slice(1)) await page.close();  // without its last page the browser ends
}
for (const problem of browser.problems) console.log("the browser reports: " + problem);
failed += browser.problems.length;
await browser.close();
console.log(failed === 0 ? "passed" : failed + " failed");
process.exit(failed === 0 ? 0 : 1);
