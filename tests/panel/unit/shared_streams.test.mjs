// One stream for all tabs of a browser: what the shared worker does, with tabs that are message ports, and a plant without a network.
import assert from "node:assert/strict";
import {afterEach, test} from "node:test";
import {SharedStreams} from "../../../runtime/panel/page/shared_streams.js";

const pause = (ms) => new Promise((done) => setTimeout(done, ms));
const event = (name, of) => "event: " + name + "\ndata: " + JSON.stringify(of) + "\n\n";

/// A plant whose streams get what send() is given, after a picture.
class Plant {
  constructor() { Object.assign(this, {rev: 0, streams: new Set(), opened: 0, pictures: 0, hold: null}); }

  api({token, run}) {
    return {token, run, plant: async () => ({run}), stream: async (signal) => this.open(signal), picture: async () => {
      this.pictures += 1;
      const picture = JSON.stringify({rev: this.rev});
      await this.hold;
      return picture;
    }};
  }

  open(signal) {
    this.opened += 1;
    return new ReadableStream({start: (controller) => {
      this.streams.add(controller);
      signal.addEventListener("abort", () => { if (this.streams.delete(controller)) controller.error(new DOMException("", "AbortError")); });
      controller.enqueue(new TextEncoder().encode(event("picture", {rev: this.rev})));
    }});
  }

  change() {
    this.rev += 1;
    for (const stream of this.streams) stream.enqueue(new TextEncoder().encode(event("changes", {rev: this.rev})));
  }
}

const ends = [];
afterEach(() => { for (const end of ends.splice(0)) end(); });

const makeStreams = (t, plant) => {
  t.mock.timers.enable({apis: ["setInterval"]});
  return new SharedStreams((of) => plant.api(of));
};

/// A tab, with what it got. While `reads` is false it is busy or frozen.
const join = (streams, token = "a") => {
  const {port1, port2} = new MessageChannel();
  const tab = {got: [], reads: true, leave: () => port1.postMessage({leave: true}), close: () => port1.close()};
  const answer = () => port1.postMessage({read: true});
  tab.wake = () => {
    tab.reads = true;
    for (let i = tab.unread; i > 0; --i) answer();
  };
  tab.unread = 0;
  port1.onmessage = ({data}) => {
    tab.got.push(data.report ? data.report[0] : data.event + " " + JSON.parse(data.data).rev);
    tab.reads ? answer() : ++tab.unread;
  };
  streams.connect(port2);
  ends.push(() => { port1.close(); port2.close(); });
  port1.postMessage({join: {token, run: "r"}});
  return tab;
};
const until = async (what, probe) => {
  for (let i = 0; i < 1000 && !probe(); ++i) await pause(5);
  assert.ok(probe(), what);
};
const last = (tab) => tab.got[tab.got.length - 1];

test("All tabs of a token share one stream, and a later one gets a picture first", async (t) => {
  const plant = new Plant();
  const streams = makeStreams(t, plant);
  const first = join(streams);
  await until("the first picture", () => last(first) === "picture 0");
  plant.change();
  await until("the change", () => last(first) === "changes 1");
  const second = join(streams);
  await until("its picture", () => last(second) === "picture 1");
  plant.change();
  await until("a change for both", () => last(first) === "changes 2" && last(second) === "changes 2");
  assert.deepEqual(first.got, ["open", "picture 0", "changes 1", "changes 2"]);
  assert.deepEqual(second.got, ["open", "picture 1", "changes 2"]);
  assert.equal(plant.opened, 1);
});

test("What comes while a picture is fetched follows it, unless it has it already", async (t) => {
  const plant = new Plant();
  const streams = makeStreams(t, plant);
  const first = join(streams);
  await until("the first picture", () => last(first) === "picture 0");
  let release;
  plant.hold = new Promise((done) => { release = done; });
  const second = join(streams);
  await until("the question", () => plant.pictures === 1);
  plant.change();
  plant.change();
  await until("the changes", () => last(first) === "changes 2");
  release();
  await until("the changes after the picture", () => last(second) === "changes 2");
  assert.deepEqual(second.got, ["open", "picture 0", "changes 1", "changes 2"]);
});

test("Tabs with other tokens have their own stream, which ends with its last tab", async (t) => {
  const plant = new Plant();
  const streams = makeStreams(t, plant);
  const [a, b, other] = [join(streams), join(streams), join(streams, "b")];
  await until("the pictures", () => [a, b, other].every((tab) => tab.got.includes("picture 0")));
  assert.equal(plant.opened, 2);
  a.leave();
  await until("one tab less", () => streams.streams.get("a").members.size === 1);
  plant.change();
  await until("a change for those that are left", () => last(b) === "changes 1" && last(other) === "changes 1");
  assert.ok(!a.got.includes("changes 1"));
  b.leave();
  await until("the end of the stream", () => plant.streams.size === 1);
  const late = join(streams);
  await until("a new stream", () => last(late) === "picture 1");
  assert.equal(plant.opened, 3);
});

test("A tab that is closed without a word leaves too", async (t) => {
  const plant = new Plant();
  const streams = makeStreams(t, plant);
  const tab = join(streams);
  await until("the picture", () => last(tab) === "picture 0");
  tab.close();
  await until("the end of the stream", () => plant.streams.size === 0);
});

test("A tab that does not read misses changes, and gets a picture when it reads again", async (t) => {
  const plant = new Plant();
  const streams = makeStreams(t, plant);
  const [busy, other] = [join(streams), join(streams)];
  await until("the pictures", () => [busy, other].every((tab) => tab.got.includes("picture 0")));
  busy.reads = false;
  for (let i = 1; i <= 300; ++i) {
    plant.change();
    await until("the change", () => last(other) === "changes " + i);
  }
  assert.ok(busy.got.length < 150, busy.got.length + " messages wait for a tab");
  busy.wake();
  await until("a picture", () => last(busy) === "picture 300");
  plant.change();
  await until("the next change", () => last(busy) === "changes 301");
});

test("A tab that reads nothing for a minute is dropped", async (t) => {
  const plant = new Plant();
  const streams = makeStreams(t, plant);
  const tab = join(streams);
  await until("the picture", () => last(tab) === "picture 0");
  const later = performance.now() + 61000;
  t.mock.method(performance, "now", () => later);
  t.mock.timers.tick(2000);
  await until("the end of the stream", () => plant.streams.size === 0);
});

test("All tabs see that the connection is lost, and a tab that comes then sees it too", async (t) => {
  const plant = new Plant();
  const streams = makeStreams(t, plant);
  const first = join(streams);
  await until("the picture", () => last(first) === "picture 0");
  const open = plant.open;
  plant.open = () => { throw new Error("the plant does not answer"); };
  for (const stream of plant.streams) stream.close();
  plant.streams.clear();
  await until("the loss", () => last(first) === "lost");
  const second = join(streams);
  await until("the loss for a new tab", () => second.got[0] === "lost");
  plant.open = open;
  await until("the new pictures", () => last(first) === "picture 0" && last(second) === "picture 0");
});
