// A headless Chromium for tests of the panel's page, by npm's playwright-core, and axe-core.
import {existsSync, mkdtempSync, readFileSync, rmSync} from "node:fs";
import {createRequire} from "node:module";
import {tmpdir} from "node:os";
import {join} from "node:path";

const kChromium = ["/usr/bin/chromium", "/usr/bin/chromium-browser"].find((path) => existsSync(path));
const kArguments = ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update",
  "--disable-sync"];
export const kSkipped = 77;

/// 3D by the processor, or none.
export const kSoftware3d = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const kNo3d = ["--disable-gpu"];
const kOfGraphics = /GL Driver Message .* GPU stall due to ReadPixels/;  // without a graphics card, pictures of the page say so

/// `playwright` and `axe` are folders with node_modules, as npm_package.sh makes them; `graphics`: of chromium.
export class Browser {
  static async open({playwright, axe, graphics = kNo3d}) {
    if (!kChromium) {
      console.log("chromium is not installed");
      process.exit(kSkipped);
    }
    const {chromium} = createRequire(join(playwright, "x.js"))("playwright-core");
    const browser = new Browser();
    browser.axe = readFileSync(createRequire(join(axe, "x.js")).resolve("axe-core/axe.min.js"), "utf8");
    browser.folder = mkdtempSync(join(tmpdir(), "panel-browser-"));
    browser.context = await chromium.launchPersistentContext(browser.folder, {executablePath: kChromium, headless: true, args: [...kArguments, ...graphics],
      viewport: {width: 1280, height: 800}, acceptDownloads: true});
    browser.problems = [];
    return browser;
  }

  /// A page whose errors are kept in `problems`. `expected` matches messages that are no problem.
  async page(expected = null) {
    const page = await this.context.newPage();
    const add = (text) => { if (!expected?.test(text) && !kOfGraphics.test(text)) this.problems.push(text); };
    page.on("console", (message) => { if (["error", "warning"].includes(message.type())) add(message.text() + " " + message.location().url); });
    page.on("pageerror", (error) => add(error.stack));
    page.on("dialog", (dialog) => { add("a dialog of the browser: " + dialog.message()); dialog.dismiss(); });
    return page;
  }

  async close() {
    await this.context.close();
    rmSync(this.folder, {recursive: true, force: true});
  }

  /// What axe-core finds against WCAG 2.1 AA, and texts that overlap.
  async faults(page) {
    // The page's policy forbids scripts from elsewhere; evaluate() is of the debugger and is not subject to it.
    if (!await page.evaluate(() => "axe" in window)) await page.evaluate(this.axe);
    const {violations} = await page.evaluate(() => axe.run(document, {runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "best-practice"]}));
    return [...violations.map(({id, help, nodes}) => id + ": " + help + "\n    " + nodes.slice(0, 3).map(({html, failureSummary}) =>
      html.slice(0, 200) + " " + failureSummary.replace(/\s+/g, " ")).join("\n    ")), ...await page.evaluate(overlaps)];
  }
}

/// In the page: pairs of texts that are drawn over each other, and texts that are drawn outside of the page.
const overlaps = () => {
  const found = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const cut = (box, element) => {
    // A text is seen only within those of its ancestors that clip.
    for (let of = element; of; of = of.parentElement) {
      if (getComputedStyle(of).overflow === "visible") continue;
      const {left, right, top, bottom} = of.getBoundingClientRect();
      box = {left: Math.max(box.left, left), right: Math.min(box.right, right), top: Math.max(box.top, top), bottom: Math.min(box.bottom, bottom)};
    }
    return box;
  };
  const boxes = [];
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const element = node.parentElement;
    if (node.data.trim() === "" || element.closest(".hidden-text, .skip, [hidden], option, .found") || !element.checkVisibility({visibilityProperty: true})) continue;
    const range = document.createRange();
    range.selectNodeContents(node);
    for (const rect of range.getClientRects()) {
      const box = cut(rect, element);
      if (box.right - box.left > 2 && box.bottom - box.top > 2) boxes.push({...{left: box.left, right: box.right, top: box.top, bottom: box.bottom}, text: node.data.trim().slice(0, 40), element});
    }
  }
  const stays = (element) => element.closest(".io-head, dialog, .pane-head") ?? element.closest("aside");  // drawn above what scrolls under it
  boxes.forEach((a, i) => {
    if (a.right > innerWidth + 1) found.push("outside of the page: " + a.text);
    for (const b of boxes.slice(i + 1)) {
      if (a.element === b.element || stays(a.element) !== stays(b.element)) continue;
      const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      const high = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
      if (wide > 2 && high > 4) found.push("overlap: " + a.text + " / " + b.text);
    }
  });
  return found.slice(0, 10);
};

/// Waits until `probe()` is true; fails with `what` and the last value after 10 s.
export const until = async (what, probe, limit = 10000) => {
  const begin = Date.now();
  let last;
  while (Date.now() - begin < limit) {
    last = await probe();
    if (last === true) return;
    await new Promise((done) => setTimeout(done, 40));
  }
  throw new Error(what + " did not come; the last value: " + JSON.stringify(last));
};

/// Runs tests, [what, run], and says how each ended; the number that failed. `only`: a part of the names. `inOrder`: each goes on where the one before
/// ended, so the first failure is the last test; SYMPLANT_SHOT names a file for a picture of `page` then.
export const runTests = async (tests, {only = "", inOrder = false, page = null} = {}) => {
  let failed = 0;
  for (const [what, run] of tests) {
    if (!what.includes(only)) continue;
    try {
      await run();
      console.log("ok " + what);
    } catch (error) {
      ++failed;
      console.log("not ok " + what + "\n" + error.stack);
      if (page && process.env.SYMPLANT_SHOT) await page.screenshot({path: process.env.SYMPLANT_SHOT});
      if (inOrder) break;
    }
  }
  return failed;
};

/// Ends the process: what the browser reported counts as failed, too. `cleanUp()` runs before.
export const finish = async (browser, failed, cleanUp = () => {}) => {
  for (const problem of browser.problems) console.log("the browser reports: " + problem);
  const all = failed + browser.problems.length;
  await browser.close();
  await cleanUp();
  console.log(all === 0 ? "passed" : all + " failed");
  process.exit(all === 0 ? 0 : 1);
};
