// Server-sent events, in pieces that end anywhere.
import assert from "node:assert/strict";
import {test} from "node:test";
import {EventReader} from "../../../runtime/panel/page/events.js";

const kText = 'event: picture\ndata: {"a":1}\n\n: a comment\n\nevent: changes\r\ndata: one\r\ndata: two\r\n\r\ndata:plain\n\n';
const kEvents = [{event: "picture", data: '{"a":1}'}, {event: "changes", data: "one\ntwo"}, {event: "message", data: "plain"}];

test("Events are read whole", () => assert.deepEqual(new EventReader().read(kText), kEvents));

test("Events are read in pieces of any size", () => {
  for (let size = 1; size < 20; ++size) {
    const reader = new EventReader();
    const found = [];
    for (let at = 0; at < kText.length; at += size) found.push(...reader.read(kText.slice(at, at + size)));
    assert.deepEqual(found, kEvents);
  }
});
