// What is in view every day: the band of a frozen plant, colors of kinds, running drives, keys after a search. [what, plant, check] against the
// mock server, as in page_cases.mjs.
import assert from "node:assert/strict";
import {until} from "./browser.mjs";

const kViews = ["line", "io", "chart", "findings", "links", "malfunctions", "exercises", "session"];
const bandOf = (page) => page.getByRole("region", {name: "State of the plant"});
const details = (page) => page.getByRole("complementary", {name: "Details"});
const backOf = (locator) => locator.evaluate((element) => getComputedStyle(element).backgroundColor);

/// In the page: { bytes, turning } of a canvas. It is copied first, since reading a canvas changes how it is drawn.
const readStrip = (canvas) => {
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", {willReadFrequently: true});
  copy.drawImage(canvas, 0, 0);
  const {data} = copy.getImageData(0, 0, canvas.width, canvas.height);
  const hex = getComputedStyle(document.documentElement).getPropertyValue("--moving").trim();
  const color = [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
  let turning = 0;
  for (let i = 0; i < data.length; i += 4) if (color.every((part, k) => data[i + k] === part)) ++turning;
  return {bytes: data.join(), turning};
};

export const kEveryday = [
  ["a frozen plant says so across each view, with its time, and can be run from there", "cell", async ({page, view}) => {
    assert.ok(!await bandOf(page).isVisible(), "a band while plant time passes");
    await page.getByRole("button", {name: "Freeze"}).click();
    await bandOf(page).waitFor();
    const time = await page.getByRole("timer").innerText();
    for (const colorScheme of ["light", "dark"]) {
      await page.emulateMedia({colorScheme, reducedMotion: "reduce"});
      for (const key of kViews) {
        await view("view=" + key);
        assert.equal((await bandOf(page).getByRole("status").innerText()).trim(), "FROZEN at " + time, key);
        const {width, height, wide} = await bandOf(page).evaluate((element) => ({...element.getBoundingClientRect().toJSON(), wide: innerWidth}));
        assert.ok(width === wide && height > 25, key + ": " + width + " x " + height);
      }
    }
    const freeze = await page.getByRole("button", {name: "Run", exact: true}).boundingBox();
    await bandOf(page).getByRole("button", {name: "Run the plant"}).click();
    await until("the end of the band", async () => !await bandOf(page).isVisible());
    assert.deepEqual(await page.getByRole("button", {name: "Freeze"}).boundingBox(), freeze, "the band moves the controls");
  }],
  ["the band has no button where it would do nothing: an ended plant, a lost one, a trainee", "cell", async ({page, server}) => {
    const setClock = (state) => {
      server.plant.clock = {...server.plant.clock, state};
      server.plant.changed.keys.add("clock");
    };
    setClock("ended");
    await until("ended", async () => /^ENDED at/.test(await bandOf(page).innerText()));
    assert.equal(await bandOf(page).getByRole("button").count(), 0);
    setClock("frozen");
    await bandOf(page).getByRole("button").waitFor();
    server.plant.description.role = "trainee";
    await page.reload();
    await until("frozen", async () => /^FROZEN at/.test(await bandOf(page).innerText()));
    assert.equal(await bandOf(page).getByRole("button").count(), 0);
    await server.stop();
    await until("lost", async () => /^NO CONNECTION, the state of/.test(await bandOf(page).innerText()));
  }],
  ["after a search the focus is on what was found, and keys of one letter act again", "body-shop", async ({page}) => {
    const tag = () => page.evaluate(() => document.activeElement.tagName + " " + document.activeElement.textContent);
    const search = async (text) => {
      await page.keyboard.press("/");
      await page.keyboard.type(text);
      await page.keyboard.press("Enter");
    };
    await search("under20 robot1");
    await until("the focus on the heading", async () => /^H2 BODY_UNDER20_ROBOT1/.test(await tag()) || await tag());
    await page.keyboard.press("4");
    await page.getByRole("table", {name: "Symbols"}).waitFor();
    await search("under20 robot1");  // what is selected already
    await until("the focus again", async () => /^H2 BODY_UNDER20_ROBOT1/.test(await tag()) || await tag());
    await search("body under10");
    await until("the focus on the station", async () => /^DIV/.test(await tag()) || await tag());
    assert.match(await page.evaluate(() => location.hash), /view=plan&station=BODY\+UNDER10/);
    await page.keyboard.press("p");
    await bandOf(page).waitFor();
  }],
  ["Esc leaves the search, keeps the details open, and gives the focus back", "body-shop", async ({page, view}) => {
    await view("view=line&station=BODY+UNDER10&device=BODY_UNDER10_CLAMP1");
    const tile = page.locator(".tile[tabindex='0']");
    await tile.focus();
    const focused = () => page.evaluate(() => document.activeElement.dataset.device ?? document.activeElement.id);
    const before = await focused();
    await page.keyboard.press("/");
    await page.keyboard.type("clamp");
    await page.keyboard.press("Escape");
    assert.equal(await focused(), before);
    assert.equal(await page.getByRole("combobox", {name: "Search"}).inputValue(), "");
    assert.ok(await details(page).isVisible());
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press("/");
    await page.keyboard.press("Escape");
    assert.equal(await focused(), "main");
    await page.keyboard.press("4");
    await page.getByRole("table", {name: "Symbols"}).waitFor();
  }],
  ["a kind of part has one color: in the legend, on tracks, in places and in details", "material", async ({page, view, server}) => {
    const legend = page.getByRole("group", {name: "Kinds of parts"});
    const kinds = server.plant.description.part_kinds.map(({name}) => name);
    const colors = new Map();
    for (const name of kinds) colors.set(name, await backOf(legend.getByText(name, {exact: true})));
    assert.equal(new Set(colors.values()).size, kinds.length);
    const place = page.locator("[data-location=BUFFER] .slot[data-part-kind]").first();
    await page.locator("[data-location=BUFFER]").scrollIntoViewIfNeeded();
    assert.equal(await backOf(place), colors.get(await place.innerText()));
    await view("view=line&location=CONV_S00_BELT");
    const cell = details(page).getByRole("table", {name: "Parts"}).locator(".kind").first();
    assert.equal(await backOf(cell), colors.get(await cell.innerText()));
    await page.locator("[data-location=CONV_S00_BELT]").scrollIntoViewIfNeeded();
    // The canvas of the first track has the color of each kind that is on it.
    await page.getByRole("button", {name: "Freeze"}).click();
    await page.waitForTimeout(400);
    const drawn = await page.evaluate(() => {
      const canvas = document.querySelector("[data-location=CONV_S00_BELT] canvas");
      const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      const found = new Set();
      for (let i = 0; i < data.length; i += 4) found.add("rgb(" + data[i] + ", " + data[i + 1] + ", " + data[i + 2] + ")");
      return {colors: [...found], kinds: symplant.store.tracks[0].parts.map((part) => part[1])};
    });
    for (const kind of new Set(drawn.kinds)) assert.ok(drawn.colors.includes(colors.get(kinds[kind])), kinds[kind]);
  }],
  ["a track shows whether its drives run, with direction and speed, and moves nothing for readers who want no motion", "material", async ({page, view, server}) => {
    const head = page.locator("[data-location=CONV_S00_BELT] .drive");
    const setDrives = (drives) => {
      server.plant.tracks.forEach((track, rank) => {
        Object.assign(track, {drives, t: server.plant.t, parts: []});
        server.plant.changed.tracks.add(rank);
      });
    };
    const strip = "[data-location=CONV_S00_BELT] canvas";
    /// All bytes of the strip as a text, and how many pixels have the color of what moves: that of the motors, and of nothing else.
    const look = () => page.locator(strip).evaluate(readStrip);
    const drives = page.getByRole("complementary", {name: "Details"});
    await view("view=line&location=CONV_S00_BELT");
    await page.locator("[data-location=CONV_S00_BELT]").scrollIntoViewIfNeeded();
    setDrives([0, 0]);
    await until("stopped", async () => /^■( stopped)?$/.test(await head.innerText()) || await head.innerText());
    assert.equal((await look()).turning, 0);
    setDrives([5e5, -2e5]);
    await until("running", async () => await head.innerText() === "→ 0.5 m/s | ← 0.2 m/s" || await head.innerText());
    assert.match(await drives.innerText(), /0 to 4 m: runs forward, 0.5 m\/s\n4 m to 8 m: runs backward, 0.2 m\/s/);
    const running = await look();
    assert.ok(running.turning > 60, "the strip does not show the motors: " + running.turning);
    await page.waitForTimeout(500);
    assert.ok((await look()).bytes === running.bytes, "motion though none is wanted");
    await page.emulateMedia({reducedMotion: "no-preference"});
    setDrives([5e5, -2e5]);
    await page.waitForTimeout(500);
    const {bytes} = await look();
    await until("motion", async () => (await look()).bytes !== bytes);
    // What cannot be seen costs nothing.
    const outside = await page.evaluate(async () => {
      const {prototype} = CanvasRenderingContext2D;
      const {clearRect} = prototype;
      const counts = {seen: 0, hidden: 0};
      prototype.clearRect = function(...of) {
        const {top, bottom} = this.canvas.getBoundingClientRect();
        if (this.canvas.isConnected) ++counts[bottom < -200 || top > innerHeight + 200 ? "hidden" : "seen"];
        clearRect.apply(this, of);
      };
      await new Promise((done) => setTimeout(done, 500));
      prototype.clearRect = clearRect;
      return counts;
    });
    assert.ok(outside.seen > 10 && outside.hidden === 0, JSON.stringify(outside));
  }],
];
