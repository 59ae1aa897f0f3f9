// An edit of the layout, with elements that show nothing: nothing is lost while it is saved, or if another layout was saved meanwhile.
import assert from "node:assert/strict";
import {test} from "node:test";
import {smallPlant} from "./plant.mjs";

class Element {
  constructor() { Object.assign(this, {texts: [], classList: {toggle() {}}}); }
  append() {}
  replaceChildren(...children) { this.texts = children; }
  setAttribute() {}
  addEventListener() {}
  focus() {}
}
globalThis.document = {createElement: () => new Element()};
globalThis.addEventListener = () => {};
const {LayoutState} = await import("../../../runtime/panel/page/plan/layout_state.js");
const {PlanEdit} = await import("../../../runtime/panel/page/plan/edit.js");

const pause = () => new Promise((done) => setTimeout(done));
const kDrag = {shiftKey: false};

/// A server with the revision 1, and a page that edits its layout. `wait`: the answer to a save is given by answer().
const begin = async () => {
  const server = {revision: 1, plan: {}, posts: [], answers: []};
  const api = {
    layout: async () => ({revision: server.revision, plan: server.plan}),
    files: async () => [],
    saveLayout: (plan, revision) => new Promise((done, fail) => {
      server.posts.push(revision);
      server.answers.push(async (message) => {
        if (message) fail(Object.assign(new Error(message), {status: 422}));
        else {
          Object.assign(server, {plan, revision: server.revision + 1});
          done({file: "layout.json"});
        }
        await pause();
      });
    }),
  };
  const app = {plant: smallPlant(), store: {layout: 1}, api};
  app.layout = new LayoutState(app);
  const notes = [];
  const view = {board: new Element(), place() {}, mark() {}, note: (text) => notes.push(text)};
  const edit = new PlanEdit(app, view);
  app.layout.listen(() => { if (edit.isOn) edit.newer(); });
  await app.layout.follow();
  edit.begin();
  edit.select([{kind: "device", index: 0}]);
  edit.move(1, 0);
  const other = async () => {
    server.revision += 1;
    app.store.layout = server.revision;
    await app.layout.follow();
  };
  return {server, app, edit, notes, other, bar: edit.panel, shown: () => edit.placed.devices[0].x};
};

test("While a save waits nothing is changed, and a second click does not save twice", async () => {
  const {server, edit, bar, notes, shown} = await begin();
  const drag = edit.grab([edit.placed.devices[0].x, edit.placed.devices[0].y], kDrag);
  const before = shown();
  const saved = bar.toSave();
  bar.toSave();
  edit.move(5, 0);
  edit.undo();
  edit.setBackground({file: "hall.svg", x: 0, y: 0, width: 3});
  drag.move([50, 50]);
  drag.end();
  assert.deepEqual([server.posts, shown(), bar.element.inert], [[1], before, true]);
  await server.answers[0]();
  await saved;
  assert.deepEqual([edit.isOn, edit.isSaving, bar.element.inert], [false, false, false]);
  assert.match(notes.at(-1), /^All see the layout/);
  assert.ok(!notes.some((text) => text.includes("meanwhile")));
  edit.begin();
  assert.deepEqual([edit.revision, shown()], [2, before]);
});

test("A layout that another saved is not replaced unseen: the edit stays open, a second Save replaces it", async () => {
  const {server, edit, bar, notes, other, shown} = await begin();
  const before = shown();
  await other();
  assert.match(notes.at(-1), /meanwhile.*second Save/);
  bar.toSave();
  await server.answers[0]("another layout was saved meanwhile (revision 2)");
  assert.deepEqual([edit.isOn, edit.isSaving, shown(), edit.isChanged()], [true, false, before, true]);
  assert.equal(bar.result.texts.length, 1);
  bar.toSave();
  await server.answers[1]();
  assert.deepEqual([server.posts, edit.isOn], [[1, 2], false]);
});

test("A save without an answer leaves the edit open, based on the same revision", async () => {
  const {server, edit, bar, notes, other} = await begin();
  bar.toSave();
  await other();
  await server.answers[0]("the plant does not answer");
  assert.deepEqual([edit.isOn, edit.revision], [true, 1]);
  assert.match(notes.at(-1), /meanwhile/);
});

test("After Cancel no note of the edit stays", async () => {
  const {edit, notes, other} = await begin();
  await other();
  edit.end();
  assert.equal(notes.at(-1), "");
});
