// Acts that are not answered: they are given up, and name the time until which the server may do them.
import assert from "node:assert/strict";
import {test} from "node:test";
import {ActClock} from "../../../runtime/panel/page/act_clock.js";
import {Api} from "../../../runtime/panel/page/api.js";

const answering = (t, answer) => t.mock.method(globalThis, "fetch", (path, {body, signal}) => answer(JSON.parse(body), signal));
/// Holds the process, which a timeout of an AbortSignal does not.
const never = (signal) => new Promise((_, fail) => {
  const hold = setTimeout(() => {}, 60000);
  signal.addEventListener("abort", () => {
    clearTimeout(hold);
    fail(signal.reason);
  });
});

test("An act has 2 s by the server's clock, which is never assumed to be later than an event shows", () => {
  const clock = new ActClock();
  assert.deepEqual(clock.limit(0), {});
  clock.hear({now: 50000}, true, 1000);
  assert.deepEqual(clock.limit(1500), {until: 52500});
  clock.hear({now: 50100}, false, 2000);  // it came 900 ms late
  assert.deepEqual(clock.limit(2500), {until: 53500});
  clock.hear({}, false, 3000);
  assert.deepEqual(clock.limit(2500), {until: 53500});
  clock.hear({now: 10000}, true, 3000);  // another server
  assert.deepEqual(clock.limit(3000), {until: 12000});
});

test("An act that is not answered is given up after 3 s, and said to be not done", async (t) => {
  let given;
  answering(t, (body, signal) => {
    given = signal;
    return never(signal);
  });
  const api = new Api("token");
  const begin = performance.now();
  await assert.rejects(api.acts({run: true}), /no answer within 3 s: not done/);
  assert.ok(given.aborted);
  assert.ok(performance.now() - begin >= 2900);
});

test("An act names the time until which it may be done", async (t) => {
  const bodies = [];
  answering(t, async (body) => {
    bodies.push(body);
    return Response.json({t: 1});
  });
  const api = new Api("token");
  await api.acts({run: true});
  api.clock.hear({now: 1e9}, true);
  await api.acts({run: true});
  assert.equal("until" in bodies[0], false);
  assert.ok(bodies[1].until >= 1e9 + 1900 && bodies[1].until < 1e9 + 60000);
});

test("Where the connection breaks, the page does not claim to know that nothing was done", async (t) => {
  answering(t, async () => { throw new TypeError("Failed to fetch"); });
  await assert.rejects(new Api("token").acts({run: true}), /not done, or the answer is lost/);
});

test("What the server says against an act is shown as it is", async (t) => {
  answering(t, async () => Response.json({error: "a part has no room there"}, {status: 422}));
  await assert.rejects(new Api("token").acts({run: true}), {status: 422, message: "a part has no room there"});
});
