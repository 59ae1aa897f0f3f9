// The page against the mock server of tests/panel, for what a real plant does not do on demand: a lost connection, a restart, hostile and
// long names, a panel that only shows, a missing token, a recording; keys; overlaps in narrow and wide windows.
//
// usage: node page_test.mjs PLAYWRIGHT_FOLDER AXE_FOLDER [WORDS]   only the tests whose names contain WORDS
// Exit code: 0 passed, 1 failed, 77 there is no chromium
import assert from "node:assert/strict";
import {startServer} from "../../panel/mock/server.mjs";
import {Browser, finish, runTests, until} from "./browser.mjs";
import {kEveryday} from "./everyday_cases.mjs";
import {kCases} from "./page_cases.mjs";

const [playwright, axe] = process.argv.slice(2);
const browser = await Browser.open({playwright, axe});
const kLost = /ERR_|Failed to fetch|status of 4\d\d|net::/;

const ready = (page) => page.waitForSelector("body[data-ready]");
const withServer = async (options, use) => {
  const server = await startServer(options);
  const page = await browser.page(kLost);
  try {
    await use(page, server);
  } finally {
    await page.close();
    await server.stop();
  }
};
const view = async (page, hash) => {
  await page.evaluate((to) => { location.hash = to; }, hash);
  await page.waitForTimeout(500);
};
const noFaults = async (page, where) => assert.deepEqual(await browser.faults(page), [], where);
const alertText = (page) => page.getByRole("alert").innerText();

const kTests = [
  ["a lost connection is said, and the page goes on when the plant answers again", async () => {
    await withServer({name: "cell"}, async (page, server) => {
      await page.goto(server.link);
      await ready(page);
      for (const stream of server.streams) stream.destroy();
      await until("the notice", async () => /is lost/.test(await alertText(page)) || await alertText(page));
      await until("the end of the notice", async () => await alertText(page) === "" || await alertText(page));
    });
  }],
  ["all tabs of a browser share one stream, which goes on when the first one closes, and ends with the last one", async () => {
    await withServer({name: "cell"}, async (page, server) => {
      const pages = [page, await browser.page(kLost), await browser.page(kLost)];
      for (const each of pages) {
        await each.goto(server.link);
        await ready(each);
      }
      assert.equal(server.streams.size, 1);
      for (const stream of server.streams) stream.destroy();
      for (const each of pages) await until("the loss", async () => await each.evaluate(() => document.body.dataset.connection) === "lost");
      for (const each of pages) await until("its end", async () => await each.evaluate(() => document.body.dataset.connection) === "open");
      assert.equal(server.streams.size, 1);
      await pages[1].close();
      await pages[0].getByRole("button", {name: "Freeze"}).click();
      await until("a frozen plant in the last tab", async () => pages[2].evaluate(() => symplant.store.clock.state === "frozen"));
      await pages[2].close();
      assert.equal(server.streams.size, 1);
      await page.goto("about:blank");
      await until("the end of the stream", async () => server.streams.size === 0);
    });
  }],
  ["an act to which the server gets too late is not done", async () => {
    let wait = 0;
    await withServer({name: "cell", delay: () => wait}, async (page, server) => {
      await page.goto(server.link);
      await ready(page);
      wait = 5000;
      await page.getByRole("button", {name: "Freeze"}).click();
      await until("the result", async () => /no answer within 3 s: not done/.test(await page.getByRole("banner").innerText()));
      await page.waitForTimeout(3000);
      assert.equal(server.plant.clock.state, "running");
      wait = 0;
      await page.getByRole("button", {name: "Freeze"}).click();
      await until("a frozen plant", async () => server.plant.clock.state === "frozen");
    });
  }],
  ["next to a PLC the session offers no scenario, and says why", async () => {
    await withServer({name: "cell"}, async (page, server) => {
      server.plant.description.with_plc = true;
      await page.goto(server.link + "&view=session");
      await ready(page);
      const files = page.getByRole("region", {name: "Files"});
      assert.deepEqual((await files.getByRole("button").allInnerTexts()).filter((text) => /Download/.test(text)), ["Download Session as JSON", "Download JUnit"]);
      assert.match(await files.innerText(), /what the PLC wrote is not recorded/);
      await noFaults(page, "session");
    });
  }],
  ["a restart with another run is said, and the page shows the new plant", async () => {
    await withServer({name: "cell"}, async (page, server) => {
      await page.goto(server.link);
      await ready(page);
      const port = Number(new URL(server.address).port);
      await server.stop();
      await until("the notice", async () => /is lost/.test(await alertText(page)) || await alertText(page));
      const next = await startServer({name: "material", port});
      await until("the new plant", async () => await page.title() === "material - symplant", 15000);
      assert.match(await alertText(page), /The plant was restarted/);
      assert.match(await alertText(page), /token of this page is not valid/);
      await page.getByRole("button", {name: "Enter the token"}).click();
      await page.getByRole("textbox", {name: "Token, or the whole link"}).fill(next.link);
      await page.getByRole("button", {name: "Use it"}).click();
      await page.getByRole("button", {name: "Freeze"}).waitFor();
      await next.stop();
    });
  }],
  ["a page of an earlier run cannot act: it loads the new one", async () => {
    await withServer({name: "cell"}, async (page, server) => {
      await page.goto(server.link);
      await ready(page);
      server.plant.description.run = "another";
      await page.getByRole("button", {name: "Freeze"}).click();
      await until("the notice", async () => /The plant was restarted/.test(await alertText(page)));
      assert.equal(server.plant.clock.state, "running");
    });
  }],
  ["names are shown as text, whatever they contain, and do not overlap", async () => {
    await withServer({name: "names", activity: 5}, async (page, server) => {
      await page.setViewportSize({width: 1024, height: 700});
      await page.goto(server.link);
      await ready(page);
      for (const hash of ["view=plan", "view=line", "view=io", "view=alarms", "view=findings", "view=malfunctions", "view=exercises", "view=session"]) {
        await view(page, hash);
        await noFaults(page, hash);
      }
      for (const [kind, list] of Object.entries({device: "devices", symbol: "symbols", location: "locations", requirement: "requirements"})) {
        await view(page, new URLSearchParams({view: "line", [kind]: server.plant.description[list][0].name}).toString());
        await noFaults(page, kind);
      }
      assert.equal(await page.locator("main b, main img, main script, main i, main u, aside b, aside img, aside script, aside u, h1 b").count(), 0);
      assert.equal(await page.evaluate(() => document.scripts.length), 1);
      await view(page, "view=chart");
      await page.evaluate(() => symplant.chart.addDevice(0));
      await page.waitForTimeout(800);
      await noFaults(page, "chart");
    });
  }],
  ["a panel that only shows has no controls, and says so once", async () => {
    await withServer({name: "cell", viewOnly: true}, async (page, server) => {
      await page.goto(server.link);
      await ready(page);
      assert.equal(await page.getByText("only shows").count(), 1);
      for (const hash of ["view=plan&device=EXLINE_MB_AGV", "view=line&device=EXLINE_MB_AGV", "view=io&symbol=EXLINE_MB_AGV_I_P1", "view=malfunctions", "view=session", "view=exercises"]) {
        await view(page, hash);
        const names = await page.getByRole("button").allInnerTexts();
        for (const name of names) assert.match(name, /^(\?|✕|\+|−|Whole plant|Horn|Ask again|Show in chart|Skip to the view|Download .*|Trainee|Trainer)$/, hash);
      }
      await noFaults(page, "only shows");
    });
  }],
  ["without a token the page shows, and says how to act", async () => {
    await withServer({name: "cell"}, async (page, server) => {
      await page.goto(server.address);
      await page.evaluate(() => sessionStorage.clear());
      await page.reload();
      await ready(page);
      assert.match(await alertText(page), /token/);
      assert.equal(await page.getByRole("button", {name: "Freeze"}).count(), 0);
    });
  }],
  ["where looking needs a token, the page asks for it", async () => {
    await withServer({name: "cell", deny: (path) => path === "plant" ? 401 : 0}, async (page, server) => {
      await page.goto(server.address);
      await until("the notice", async () => /needs a token/.test(await alertText(page)));
    });
  }],
  ["a recording plays, has a slider, a chart and no acts", async () => {
    await withServer({name: "recording"}, async (page, server) => {
      await page.goto(server.link);
      await ready(page);
      const time = page.getByRole("timer");
      assert.equal(await time.innerText(), "0:00:00.0");
      await page.getByRole("combobox", {name: "Speed"}).selectOption("10");
      await page.getByRole("button", {name: "Play"}).click();
      await until("time passes", async () => await time.innerText() > "0:00:03.0");
      assert.ok(await page.evaluate(() => symplant.store.t > 1e9), "no picture while it plays");
      await page.getByRole("button", {name: "Pause"}).click();
      await page.getByRole("slider", {name: "Time"}).fill("5000");
      await until("the middle", async () => await time.innerText() === "0:00:30.0");
      await until("its picture", async () => page.evaluate(() => symplant.store.t === 30e9));
      await page.evaluate(() => symplant.chart.addDevice(symplant.plant.devices.findIndex(({operations}) => operations.length > 1)));
      await until("the chart", async () => page.evaluate(() => symplant.chart.rows[0].data.times.length > 0));
      await noFaults(page, "recording");
      assert.equal(await page.getByRole("button", {name: /^(Set|Force|Release|Freeze|Run|Reset)/}).count(), 0);
    });
  }],
  ["keys: search, help, views, tiles, details; nothing holds the focus", async () => {
    await withServer({name: "body-shop"}, async (page, server) => {
      await page.goto(server.link + "&view=line&station=BODY+UNDER10");
      await ready(page);
      const focused = () => page.evaluate(() => document.activeElement.dataset.device ?? document.activeElement.textContent);
      const first = page.locator(".tile[tabindex='0']");
      await first.focus();
      const before = await focused();
      await page.keyboard.press("ArrowRight");
      assert.notEqual(await focused(), before);
      await page.keyboard.press("Enter");
      await page.getByRole("complementary", {name: "Details"}).getByRole("heading", {name: await focused(), exact: true}).waitFor();
      await page.keyboard.press("Escape");
      await until("closed details", async () => !await page.getByRole("complementary", {name: "Details"}).isVisible());
      await page.keyboard.press("?");
      await page.getByRole("dialog").getByText("Keys of the page").waitFor({state: "attached"});
      await page.keyboard.press("Escape");
      await page.keyboard.press("/");
      await page.keyboard.type("under20 robot1");
      await page.keyboard.press("ArrowDown");
      await page.keyboard.press("Enter");
      await page.getByRole("complementary", {name: "Details"}).getByRole("heading", {name: /BODY_UNDER20_ROBOT1/}).first().waitFor();
      await page.evaluate(() => document.activeElement.blur());
      await page.keyboard.press("4");
      await page.getByRole("table", {name: "Symbols"}).waitFor();
      const seen = new Set();
      for (let i = 0; i < 80; ++i) {
        await page.keyboard.press("Tab");
        seen.add(await page.evaluate(() => {
          const of = document.activeElement;
          return of === document.body ? "body" : (of.closest("header, nav, main, aside, footer")?.tagName ?? "page");
        }));
      }
      for (const part of ["HEADER", "NAV", "MAIN", "ASIDE", "FOOTER"]) assert.ok(seen.has(part), part + " is not reached by Tab: " + [...seen]);
      const table = page.getByRole("table", {name: "Symbols"});
      await table.getByRole("link").first().focus();
      await page.keyboard.press("End");
      await until("the last symbol", async () => page.evaluate(() => document.activeElement.textContent === symplant.plant.symbols[symplant.plant.symbols.length - 1].name));
    });
  }],
  ["a part is put, changed and taken by hand", async () => {
    await withServer({name: "material"}, async (page, server) => {
      await page.goto(server.link);
      await ready(page);
      const {locations} = server.plant.description;
      await view(page, new URLSearchParams({view: "line", location: "BUFFER"}).toString());
      const details = page.getByRole("complementary", {name: "Details"});
      const kinds = async () => (await details.getByRole("table", {name: "Parts"}).getByRole("cell").allInnerTexts()).join();
      const buffer = server.plant.places[locations.filter(({kind}) => kind === "place").findIndex(({name}) => name === "BUFFER")];
      buffer.length = 0;
      await details.getByLabel("Kind of the part").selectOption("tall box");
      await details.getByRole("button", {name: "Put"}).click();
      await until("the tall box", async () => await kinds() === "tall box" || await kinds());
      await details.getByLabel("Kind of the part").selectOption("tray");
      await details.getByRole("button", {name: "Change the kind"}).click();
      await until("the tray", async () => await kinds() === "tray" || await kinds());
      await details.getByRole("button", {name: "Take"}).click();
      await until("no part", async () => buffer.length === 0);
      await view(page, new URLSearchParams({view: "line", location: locations[0].name}).toString());
      await noFaults(page, "the details of a track");
      assert.ok(await details.getByRole("button", {name: /Change the kind of part/}).count() > 0);
    });
  }],
  ["all views of plants of all sizes are without overlaps, narrow and wide", async () => {
    for (const [name, width, height, scheme] of [["cell", 1024, 700, "dark"], ["material", 1920, 1080, "light"], ["body-shop", 1024, 700, "light"], ["body-shop", 768, 1024, "dark"]]) {
      await withServer({name, activity: 20}, async (page, server) => {
        await page.emulateMedia({colorScheme: scheme, reducedMotion: "reduce"});
        await page.setViewportSize({width, height});
        await page.goto(server.link);
        await ready(page);
        await page.waitForTimeout(1500);
        const symbol = server.plant.description.symbols[0].name;
        const device = server.plant.description.devices[0].name;
        await page.evaluate(() => symplant.chart.addDevice(0));
        for (const hash of ["view=plan", "view=plan&device=" + device, "view=line", "view=line&device=" + device, "view=io&symbol=" + symbol, "view=chart", "view=findings", "view=links", "view=session"]) {
          await view(page, hash);
          await noFaults(page, name + " " + width + " " + hash);
        }
      });
    }
  }],
];

for (const [what, name, check] of [...kCases, ...kEveryday]) kTests.push([what, () => withServer({name}, async (page, server) => {
  const setWidth = (width) => page.setViewportSize({width, height: 700});
  await page.emulateMedia({colorScheme: "light", reducedMotion: "reduce"});
  await setWidth(1280);
  await page.goto(server.link + "&view=line");
  await ready(page);
  await check({page, server, setWidth, view: (hash) => view(page, hash)});
})]);

await finish(browser, await runTests(kTests, {only: process.argv[4]}));
