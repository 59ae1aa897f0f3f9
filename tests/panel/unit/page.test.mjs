// The files of the page keep its rules: no script or style in HTML, no HTML from strings, small modules, all of them used.
import assert from "node:assert/strict";
import {readdirSync, readFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {test} from "node:test";
import {fileURLToPath} from "node:url";

const kFolder = join(dirname(fileURLToPath(import.meta.url)), "../../../runtime/panel/page");
const files = readdirSync(kFolder, {recursive: true}).filter((name) => name.includes("."));
const text = (name) => readFileSync(join(kFolder, name), "utf8");
const modules = files.filter((name) => name.endsWith(".js"));

test("The page has no inline script, style or handler, and nothing from elsewhere", () => {
  const html = text("index.html");
  assert.doesNotMatch(html, /<style|style=|\son[a-z]+=|javascript:|https?:/i);
  for (const [, inside] of html.matchAll(/<script[^>]*>([^]*?)<\/script>/g)) assert.equal(inside, "");
  assert.doesNotMatch(text("panel.css"), /@import|https?:|expression\(/);
});

test("Each block of the style ends", () => {
  const style = text("panel.css");
  assert.equal(style.split("{").length, style.split("}").length);
});

test("No module makes elements from strings, evaluates text, or fetches from elsewhere", () => {
  const banned = /innerHTML|outerHTML|insertAdjacentHTML|document\.write|eval\(|new Function|DOMParser|https?:\/\/(?!www\.w3\.org)|setAttribute\("style"|style: "/;
  for (const name of modules) assert.doesNotMatch(text(name), banned, name);
});

const kWorker = "stream_worker.js";

/// The module of the page that `name` calls `specifier`; null: three.js, which is of another folder.
const moduleOf = (name, specifier) => {
  const module = join(dirname(name), specifier);
  return /^(build|three)\//.test(module) ? null : module;
};

/// The modules that a module imports, and it. `later`: also those that are loaded when they are needed.
const reachedFrom = (name, later = false, reached = new Set()) => {
  if (reached.has(name)) return reached;
  reached.add(name);
  for (const [, next] of text(name).matchAll(later ? /(?:from |import\()"(\.[^"]+)"/g : /from "(\.[^"]+)"/g)) {
    const module = moduleOf(name, next);
    if (module) reachedFrom(module, later, reached);
  }
  return reached;
};

test("Every module states its purpose, is short, and is reached from main.js or the shared worker", () => {
  assert.ok(text("follow_plant.js").includes('new URL("./' + kWorker + '", import.meta.url)'));
  assert.deepEqual([...new Set([...reachedFrom("main.js", true), ...reachedFrom(kWorker)])].sort(), [...modules].sort());
  for (const name of modules) {
    assert.match(text(name), /^\/\/ .{15,}/, name);
    assert.ok(text(name).split("\n").length <= 300, name + " is long");
  }
});

test("Every imported name is exported by its module and used", () => {
  for (const name of modules) {
    for (const [, names, from] of text(name).matchAll(/import \{([^}]*)\} from "(\.[^"]+)"/g)) {
      const module = moduleOf(name, from);
      if (!module) continue;
      for (const [imported, local = imported] of names.split(",").map((part) => part.trim().split(" as "))) {
        assert.match(text(module), new RegExp("export ((const|class) |\\{[^}]*\\b)" + imported + "\\b"), name + " imports " + imported);
        const uses = text(name).match(new RegExp("(?<![-.])\\b" + local + "\\b", "g")).length;
        assert.ok(uses > 1, name + " does not use " + local);
      }
    }
  }
});

test("The page asks for all its modules at once, and for those of the 3D view when it is opened", () => {
  const html = text("index.html");
  const first = reachedFrom("main.js");
  const asked = [...html.matchAll(/<link rel="modulepreload" href="([^"]+)">/g)].map(([, name]) => name);
  for (const name of first) if (name !== "main.js") assert.ok(asked.includes(name), name);
  for (const name of asked) assert.ok(first.has(name) || reachedFrom(kWorker).has(name), name + " is not needed at first");
  assert.ok(!first.has("view3d/scene.js") && reachedFrom("main.js", true).has("view3d/scene.js"));
});

test("The program carries every file of the page", () => {
  const list = readFileSync(join(kFolder, "../CMakeLists.txt"), "utf8");
  for (const name of files) assert.match(list, new RegExp("\\b" + name.replaceAll(".", "\\.") + "\\b"), name);
});
