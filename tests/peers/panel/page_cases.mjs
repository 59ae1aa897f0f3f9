// What a user of the page must be able to rely on: controls that stay where they are, words and times that can be read, and views that
// follow the width of the window. [what, plant, check] against the mock server.
import assert from "node:assert/strict";
import {until} from "./browser.mjs";

const kClamp = "BODY_UNDER10_CLAMP1";
const details = (page) => page.getByRole("complementary", {name: "Details"});
const boxOf = (locator) => locator.evaluate((element) => {
  const {left, right, top, bottom} = element.getBoundingClientRect();
  return {left, right, top, bottom};
});
/// Whether an element can be clicked at its middle: nothing covers or clips it.
const isOpen = (locator) => locator.evaluate((element) => {
  const {left, right, top, bottom} = element.getBoundingClientRect();
  return element.contains(document.elementFromPoint((left + right) / 2, (top + bottom) / 2));
});
const isOff = async (locator) => await locator.getAttribute("aria-disabled") === "true";

export const kCases = [
  ["the field for ordinary malfunctions shows what it found: devices and BOOL events", "cell", async ({page, view}) => {
    await view("view=malfunctions");
    const field = page.getByRole("combobox", {name: "Find a device or an event"});
    const options = page.getByRole("listbox", {name: "Find a device or an event: found"}).getByRole("option");
    await field.fill("spindle");
    assert.deepEqual(await options.allInnerTexts(), ["EXLINE_MC_SPINDLE device", "EXLINE_MC_SPINDLE_I_RUN symbol, %IX9"]);
    await field.fill("i_");
    assert.ok(await options.count() > 5);
    for (const item of [field, ...await options.all()]) assert.ok(await isOpen(item), "the list is covered or clipped at " + await item.innerText());
    await field.fill("spindle");
    await options.last().click();
    await page.getByRole("button", {name: "stuck on"}).waitFor();
  }],
  ["results, and the list of active malfunctions, move no control", "body-shop", async ({page, view}) => {
    await view("view=io&device=" + kClamp);
    const stay = async (what, control, act) => {
      const before = await boxOf(control);
      await act();
      assert.deepEqual(await boxOf(control), before, what);
    };
    const table = page.getByRole("table", {name: "Symbols"});
    const result = (text) => until(text, async () => (await page.getByRole("status").allInnerTexts()).join("\n").includes(text));
    await stay("force in the table", table, async () => {
      await page.getByRole("button", {name: "Force on: BODY_UNDER10_AIR_I_GOOD"}).click();
      await result("forced BODY_UNDER10_AIR_I_GOOD on at");
    });
    await stay("set in the details", details(page).getByRole("heading", {name: "State"}), async () => {
      await details(page).getByRole("button", {name: "Set on"}).first().click();
      await result("set " + kClamp + "_O_OPEN on at");
    });
    await view("view=malfunctions");
    const start = page.getByRole("button", {name: "Start air hose burst"});
    await stay("an active malfunction", page.getByRole("combobox", {name: "Find a device or an event"}), async () => {
      await start.click();
      await page.getByRole("button", {name: "Stop air hose burst"}).first().waitFor();
    });
  }],
  ["a result goes after some seconds", "cell", async ({page}) => {
    const results = page.getByRole("banner").getByRole("status").first();
    await page.getByRole("button", {name: "Step cycle"}).click();
    await until("the result", async () => /^ran one cycle at/.test(await results.innerText()));
    await until("its end", async () => await results.innerText() === "", 12000);
  }],
  ["Release all is at its place before anything is forced, and the link next to it does not move", "cell", async ({page}) => {
    const releaseAll = page.getByRole("button", {name: "Release all"});
    const link = page.getByRole("link", {name: /\d forced/});
    const before = [await boxOf(releaseAll), await boxOf(link)];
    assert.ok(await isOff(releaseAll));
    await page.evaluate(() => symplant.api.acts({force: {EXLINE_MB_AGV_I_P1: false}}));
    await until("enabled", async () => !await isOff(releaseAll));
    assert.deepEqual([await boxOf(releaseAll), await boxOf(link)], before);
    await releaseAll.click();
    await page.getByRole("link", {name: "0 forced"}).waitFor();
    await until("disabled again", () => isOff(releaseAll));
  }],
  ["tiles flow again when the window or the details take width", "body-shop", async ({page, view, setWidth}) => {
    await view("view=line&station=BODY+UNDER10");
    const cutTiles = () => page.evaluate(() => {
      const right = document.getElementById("main").getBoundingClientRect().right;
      return [...document.querySelectorAll(".tile")].filter((tile) => tile.getBoundingClientRect().right > right).length;
    });
    assert.equal(await cutTiles(), 0);
    await page.getByRole("link", {name: /^CLAMP4/}).click();
    await until("no cut tile with details", async () => await cutTiles() === 0 || await cutTiles());
    await setWidth(820);
    await until("no cut tile in a narrow window", async () => await cutTiles() === 0 || await cutTiles());
    assert.ok(await isOpen(page.locator(".tile[aria-current]")), "the selected tile is out of view");
  }],
  ["without a connection nothing acts, and the header says so", "body-shop", async ({page, view, server}) => {
    await view("view=malfunctions&device=" + kClamp);
    await view("view=io&device=" + kClamp);
    const banner = page.getByRole("banner");
    assert.match(await banner.innerText(), /running, 1 x/);
    await server.stop();
    await until("no connection", async () => /no connection/.test(await banner.innerText()));
    assert.doesNotMatch(await banner.innerText(), /running/);
    for (const name of ["Freeze", "Step cycle", "Reset", "Snapshot"]) assert.ok(await isOff(page.getByRole("button", {name, exact: true})), name);
    assert.ok(await isOff(details(page).getByRole("button", {name: "Set state"})));
    assert.ok(await page.getByRole("combobox", {name: "Speed"}).isDisabled());
    await view("view=malfunctions");
    assert.ok(await isOff(page.getByRole("button", {name: "Start air hose burst"})), "a view that was made before");
  }],
  ["the header shows the speed that was chosen", "cell", async ({page}) => {
    await page.getByRole("combobox", {name: "Speed"}).selectOption("10");
    await until("10 x", async () => /running, 10 x/.test(await page.getByRole("banner").innerText()));
  }],
  ["a device with a finding still shows that a malfunction acts on it", "body-shop", async ({page, view, server}) => {
    await view("view=line&station=BODY+UNDER10");
    await page.evaluate((name) => symplant.api.acts({start: name + " stuck"}), kClamp);
    const letters = () => page.locator(".tile[data-device=" + kClamp + "] .letter:visible").allInnerTexts();
    await until("M", async () => (await letters()).join() === "M" || await letters());
    const finding = {n: server.plant.findings.length, t: server.plant.t, finding: "no-feedback", of: kClamp, severity: "warning", text: "late"};
    server.plant.findings.push(finding);
    server.plant.changed.findings.push(finding);
    await until("both", async () => (await letters()).join() === "M,!" || await letters());
    assert.match(await page.getByRole("link", {name: /^CLAMP1/}).innerText(), /a finding in the last minute, a malfunction acts on it/);
  }],
  ["an explanation is asked again while plant time runs, one question at a time", "cell", async ({page, view}) => {
    let open = 0;
    let most = 0;
    let asked = 0;
    await page.route("**/api/v1/why*", async (route) => {
      ++asked;
      most = Math.max(most, ++open);
      await new Promise((done) => setTimeout(done, 300));
      --open;
      await route.fulfill({json: {text: "", trees: [{sentence: "answer " + asked + " since 10.740225793 s", about: [], because: []}]}}).catch(() => {});
    });
    await view("view=line&device=EXLINE_MC_GUARD");
    const why = details(page).getByRole("region", {name: "Why"});
    await until("a third answer", async () => /answer 3 since 10.74 s/.test(await why.innerText()));
    assert.match(await why.innerText(), /at \d+(\.\d{1,3})? s/);
    assert.equal(most, 1);
    await page.getByRole("button", {name: "Freeze"}).click();
    await page.getByRole("button", {name: "Run", exact: true}).waitFor();
    await page.waitForTimeout(1200);
    const before = asked;
    await page.waitForTimeout(3000);
    assert.equal(asked, before, "a frozen plant is asked again");
  }],
  ["force is in view at each width, and names can be told apart", "body-shop", async ({page, view, setWidth}) => {
    for (const [width, hash] of [[1280, "view=io&device=" + kClamp], [900, "view=io"], [900, "view=io&device=" + kClamp], [700, "view=io"]]) {
      await setWidth(width);
      await view(hash);
      const table = await boxOf(page.getByRole("table", {name: "Symbols"}));
      const last = await boxOf(page.getByRole("button", {name: /^Release: /}).first());
      assert.ok(last.right <= table.right, width + " " + hash + ": the buttons end at " + last.right + ", the table at " + table.right);
      const texts = await page.locator(".io-row:not([hidden]) .io-symbol a").allInnerTexts();
      assert.equal(new Set(texts).size, texts.length, width + " " + hash);
      const cut = await page.locator(".io-symbol:visible").evaluateAll((cells) => cells.filter((cell) => cell.scrollHeight > cell.clientHeight + 1 || cell.scrollWidth > cell.clientWidth).map((cell) => cell.textContent));
      assert.deepEqual(cut, [], width + " " + hash);
    }
  }],
  ["heads of tables do not break inside words", "material", async ({page, view, setWidth}) => {
    await setWidth(900);
    await view("view=line&location=CONV_S00_BELT");
    const high = await details(page).getByRole("columnheader").evaluateAll((heads) => heads.map((head) => {
      const range = document.createRange();
      range.selectNodeContents(head);
      return [head.textContent, range.getClientRects().length, head.textContent.split(" ").length];
    }));
    for (const [text, lines, words] of high) assert.ok(lines <= words, text + " has " + lines + " lines");
    await details(page).getByRole("button", {name: "Take at", exact: true}).waitFor();
  }],
  ["a finding can be read to its end", "cell", async ({page, view, server}) => {
    const text = "the clamp did not arrive, ".repeat(30) + "and this is the end at 10.740225793 s";
    const add = (of) => {
      const finding = {n: server.plant.findings.length, t: 10740225793, finding: "no-feedback", of: "EXLINE_MB_AGV", severity: "warning", text: of};
      server.plant.findings.push(finding);
      server.plant.changed.findings.push(finding);
    };
    add("short");
    add(text);
    await view("view=findings");
    const more = page.getByRole("button", {name: /^More of the finding/});
    await until("one button", async () => await more.count() === 1 || await more.count());
    await more.click();
    await page.getByRole("dialog").getByText("and this is the end at 10.74 s").waitFor();
    await page.getByRole("dialog").getByRole("button", {name: "Close"}).click();
    assert.equal(await page.locator(".finding .time").first().innerText(), "10.74 s");
    assert.equal(await page.locator(".finding .time").first().getAttribute("title"), "10.740225793 s");
  }],
  ["placeholders can be read in the dark", "cell", async ({page, view}) => {
    await page.emulateMedia({colorScheme: "dark"});
    await view("view=io");
    const contrast = await page.getByPlaceholder("Name, address or comment").evaluate((input) => {
      const light = (color) => {
        const [r, g, b] = color.match(/[\d.]+/g).map((part) => part / 255).map((part) => part <= .03928 ? part / 12.92 : ((part + .055) / 1.055) ** 2.4);
        return .2126 * r + .7152 * g + .0722 * b;
      };
      const [a, b] = [light(getComputedStyle(input, "::placeholder").color), light(getComputedStyle(input).backgroundColor)].sort((x, y) => y - x);
      return (a + .05) / (b + .05);
    });
    assert.ok(contrast >= 4.5, "the contrast is " + contrast);
  }],
  ["a snapshot is named by the time at which it is taken, and acts are listed in words", "cell", async ({page, view, server}) => {
    await view("view=session");
    await page.waitForTimeout(700);
    await page.getByRole("button", {name: "Snapshot", exact: true}).click();
    await until("the snapshot", async () => server.plant.snapshots.length === 1);
    const [{name, t}] = server.plant.snapshots;
    assert.ok(Math.abs(Number(name.match(/^at ([\d.]+) s$/)[1]) - t / 1e9) < .15, name + " at " + t / 1e9);
    await page.evaluate(() => symplant.api.acts({force: {EXLINE_MB_AGV_I_P1: false}}));
    const acts = page.getByRole("table", {name: "Acts, the newest first"});
    await acts.getByText("forced EXLINE_MB_AGV_I_P1 off").waitFor();
    assert.equal(await acts.getByText("forced EXLINE_MB_AGV_I_P1 off").getAttribute("title"), '{"force":{"EXLINE_MB_AGV_I_P1":false}}');
    await page.getByRole("button", {name: "Reset"}).click();
    await page.getByRole("dialog").getByText("a scenario that runs").waitFor();
  }],
];
