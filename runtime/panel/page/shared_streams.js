// What the shared worker of the tabs of a browser does: one stream of the plant for all tabs with the same token. A browser opens
// only six connections to a server, and a stream takes one for as long as it lasts.
import {keepStream} from "./connection.js";

const kBeat = 2000;  // ms between two reports to each tab, which has lost the worker if none comes
const kMostUnread = 100;  // messages; a tab that has not read them gets a picture instead of what follows
const kGone = 60000;  // ms; a tab that has read nothing for so long joins again when it wakes up
const kPatience = 10000;  // ms for a picture

/// A tab. It is `current`, or `late` until it gets a picture, for which it may be `asking`.
class Member {
  constructor(port) { Object.assign(this, {port, state: "late", unread: 0, kept: [], read: performance.now()}); }

  post(message) {
    this.unread += 1;
    this.port.postMessage(message);
  }

  /// An event of the stream.
  give(message) {
    if (this.state === "asking") this.kept.push(message);
    if (this.unread >= kMostUnread) this.state = "late";
    else if (message.event === "picture") this.state = "current";
    if (this.state === "current") this.post(message);
  }

  /// The picture that it asked for; what came meanwhile follows, unless the picture has it already.
  givePicture(data) {
    const {rev} = JSON.parse(data);
    this.state = "current";
    this.post({event: "picture", data});
    for (const message of this.kept) if (JSON.parse(message.data).rev > rev) this.give(message);
  }
}

/// The stream of one token, for its tabs.
class SharedStream {
  constructor(api) {
    Object.assign(this, {api, members: new Map(), report: ["open", ""], hasBegun: false, ended: new AbortController()});
    keepStream(api, (event, data) => this.receive({event, data}), (...report) => this.changed(report), this.ended.signal);
  }

  receive(message) {
    this.hasBegun = true;
    for (const member of this.members.values()) member.give(message);
  }

  changed(report) {
    if (report.join() === this.report.join()) return;
    this.report = report;
    for (const member of this.members.values()) member.post({report});
  }

  join(port) {
    const member = new Member(port);
    this.members.set(port, member);
    member.post({report: this.report});
    this.ask(member);
  }

  /// A tab has read a message.
  read(port) {
    const member = this.members.get(port);
    if (!member) return;
    member.unread -= 1;
    member.read = performance.now();
    this.ask(member);
  }

  /// Asks for a picture for a tab that is late and has read everything. The stream itself begins with one.
  async ask(member) {
    if (member.state !== "late" || member.unread > 1 || !this.hasBegun) return;
    Object.assign(member, {state: "asking", kept: []});
    const picture = await this.api.picture(AbortSignal.timeout(kPatience)).catch(() => null);
    if (member.state !== "asking") return;
    if (picture === null) member.state = "late";  // asked again after the next beat
    else member.givePicture(picture);
  }

  beat() {
    for (const [port, member] of this.members) {
      if (performance.now() - member.read > kGone) this.leave(port);
      else member.post({report: this.report});
    }
  }

  leave(port) {
    this.members.delete(port);
    if (this.members.size === 0) this.ended.abort();
  }
}

export class SharedStreams {
  /// `makeApi({token, run})` gives the requests of a token.
  constructor(makeApi) {
    Object.assign(this, {makeApi, streams: new Map()});
    setInterval(() => this.beat(), kBeat);
  }

  /// A tab, with the port on which it sends `join` with its token and run, `read` for each message that it got, and `leave`.
  connect(port) {
    let stream = null;
    const leave = () => stream?.leave(port);
    port.onmessage = ({data}) => {
      if (data.join) stream = this.join(port, data.join);
      if (data.read) stream?.read(port);
      if (data.leave) leave();
    };
    port.addEventListener("close", leave);  // of a tab that crashed, where the browser says so
  }

  join(port, of) {
    const known = this.streams.get(of.token);
    const stream = known && !known.ended.signal.aborted ? known : new SharedStream(this.makeApi(of));
    this.streams.set(of.token, stream);
    stream.join(port);
    return stream;
  }

  beat() {
    for (const [token, stream] of this.streams) {
      stream.beat();
      if (stream.ended.signal.aborted) this.streams.delete(token);
    }
  }
}
