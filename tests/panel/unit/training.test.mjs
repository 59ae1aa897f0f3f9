// Trainees and their trainer: the name that is sent, messages that are closed, and the rows of the trainer's tables.
import assert from "node:assert/strict";
import {test} from "node:test";
import {actText} from "../../../runtime/panel/page/act_words.js";
import {Api} from "../../../runtime/panel/page/api.js";
import {ClosedMessages, openMessages} from "../../../runtime/panel/page/message_band.js";
import {Store} from "../../../runtime/panel/page/store.js";
import {nameError} from "../../../runtime/panel/page/trainee_name.js";
import {smallPicture, smallPlant} from "./plant.mjs";

const storage = () => {
  const kept = new Map();
  return {getItem: (key) => kept.get(key) ?? null, setItem: (key, value) => kept.set(key, value)};
};

const headersOf = async (t, name) => {
  let headers = null;
  t.mock.method(globalThis, "fetch", async (path, options) => {
    headers = options.headers;
    return Response.json({t: 1});
  });
  const api = Object.assign(new Api("token"), {name});
  await api.acts({join: true});
  return headers;
};

test("An act has the name of the trainee in a header of ASCII", async (t) => {
  const name = "J\u00fcrgen \ubbfc\uc900";
  const headers = await headersOf(t, name);
  assert.match(headers["X-Symplant-Name"], /^[\x21-\x7e]+$/);
  assert.equal(decodeURIComponent(headers["X-Symplant-Name"]), name);
});

test("A client without a name sends none", async (t) => {
  assert.equal("X-Symplant-Name" in await headersOf(t, ""), false);
});

test("A name is refused for the reasons of the server", () => {
  assert.equal(nameError("Anna B."), "");
  assert.equal(nameError("\ubbfc\uc900"), "");
  assert.equal(nameError("a".repeat(64)), "");
  assert.match(nameError(""), /enter a name/);
  assert.match(nameError("a".repeat(65)), /too long/);
  assert.match(nameError("\ubbfc".repeat(22)), /too long/);
  for (const bad of ["a\nb", "a\u0000", "\u202eb", "\u2028", "a\u0085"]) assert.match(nameError(bad), /control character/);
});

test("Messages come one after the other, and those of a picture replace them", () => {
  const store = new Store(smallPlant());
  store.picture({...smallPicture(), messages: [{n: 0, t: 0, text: "a"}]});
  let keys = null;
  store.listen((change) => { keys = change.keys; });
  store.changes({rev: 2, t: 1, messages: [{n: 1, t: 1, text: "b"}], training: {trainees: [], malfunctions: []}});
  assert.deepEqual(store.messages.map(({text}) => text), ["a", "b"]);
  assert.deepEqual([...keys].sort(), ["messages", "training"]);
  for (let n = 2; n < 60; ++n) store.changes({rev: n + 1, t: n, messages: [{n, t: n, text: "c"}]});
  assert.equal(store.messages.length, 50);
  store.picture(smallPicture());
  assert.deepEqual([store.messages, store.training], [[], null]);
});

test("A message that was closed stays closed in this run, also after the page is loaded again", () => {
  const kept = storage();
  const messages = [0, 1, 2, 3, 4].map((n) => ({n, t: n, text: String(n)}));
  const closed = new ClosedMessages("run", kept);
  closed.add([3], 0);
  const {shown, more} = openMessages(messages, closed);
  assert.deepEqual([shown.map(({n}) => n), more.map(({n}) => n)], [[4, 2, 1], [0]]);
  assert.ok(new ClosedMessages("run", kept).has(3));
  assert.ok(!new ClosedMessages("another run", kept).has(3));
  closed.add([60], 50);
  assert.deepEqual([...closed.numbers], [60]);
});

test("Joining and messages are in words", () => {
  assert.equal(actText([{join: true}, {message: "Look at the pump"}]), "joined, sent: Look at the pump");
});
