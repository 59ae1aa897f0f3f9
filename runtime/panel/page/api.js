// The requests of the panel's interface, docs/panel-interface.md.
import {ActClock, kActTime} from "./act_clock.js";

const kLate = "no answer within " + kActTime / 1000 + " s: not done, and not sent later. The session view lists what was done";
const kBroken = "the plant does not answer: not done, or the answer is lost. The session view lists what was done";

/// An answer that is not 200, or none: `status` is then 0.
export class ApiError extends Error {
  constructor(status, message) {
    super(message);
    this.status = status;
  }
}

export class Api {
  constructor(token) {
    this.token = token;
    this.run = null;  // the `run` of the description, once it is known
    this.name = "";  // of a trainee
    this.clock = new ActClock();
    this.stale = () => {};  // called when the answer is that the program was restarted
  }

  headers(more = {}) {
    return this.token ? {Authorization: "Bearer " + this.token, ...more} : more;
  }

  async request(path, options = {}) {
    let response;
    try {
      response = await fetch(path, {cache: "no-store", ...options, headers: this.headers(options.headers)});
    } catch (error) {
      if (options.signal?.aborted) throw error;
      throw new ApiError(0, "the plant does not answer");
    }
    if (response.ok) return response;
    const answer = await response.json().catch(() => ({}));
    if (response.status === 409) this.stale();
    throw new ApiError(response.status, answer.error ?? "the answer is " + response.status);
  }

  async get(path, signal) {
    const response = await this.request("/api/v1/" + path, {signal});
    return response.json();
  }

  async post(path, body) {
    const response = await this.request("/api/v1/" + path, {method: "POST", body: JSON.stringify(body), signal: AbortSignal.timeout(kActTime),
      headers: this.actHeaders()});
    return response.json();
  }

  actHeaders() {
    return {"Content-Type": "application/json", "X-Symplant-Run": this.run ?? "",
      ...(this.name === "" ? {} : {"X-Symplant-Name": encodeURIComponent(this.name)})};
  }

  /// Acts that take effect in one instant; the answer is { t }. Without an answer in kActTime they are given up: the browser
  /// does not send them later, and the server does not do them later.
  async acts(...acts) {
    try {
      return await this.post("acts", {acts, ...this.clock.limit()});
    } catch (error) {
      if (error.name === "TimeoutError") throw new ApiError(0, kLate);
      throw error.status === 0 ? new ApiError(0, kBroken) : error;
    }
  }

  /// Acts that are sent although the page is closed: the browser sends them afterward, and no answer is read.
  leave(...acts) {
    fetch("/api/v1/acts", {method: "POST", keepalive: true, body: JSON.stringify({acts}),
      headers: this.headers(this.actHeaders())}).catch(() => {});
  }

  /// Whether the token may act: rejected with the status 401 if not.
  check(...acts) { return this.post("check", {acts}); }

  plant() { return this.get("plant"); }

  /// The text of a picture.
  async picture(signal) { return (await this.request("/api/v1/picture", {signal})).text(); }
  why(name, signal) { return this.get("why?name=" + encodeURIComponent(name), signal); }
  at(t) { return this.get("at?t=" + Math.round(t)); }

  /// The positions that were given: { revision, plan }.
  layout() { return this.get("layout"); }
  /// All see the plan, unless `revision`, on which it is based, is not the newest: then the status is 422. The answer is { file }, null without a folder.
  saveLayout(plan, revision) { return this.post("layout", {plan, revision}); }
  /// The names of the pictures and models of the folder of --panel-files.
  async files() { return (await this.get("files")).files; }

  async file(path) { return (await this.request("/api/v1/" + path)).blob(); }
  session(kind) { return this.file("session/" + kind); }

  /// What all devices, tracks and places did, or one device.
  utilization(device = null) { return this.get("utilization" + (device === null ? "" : "?device=" + device)); }
  utilizationTable() { return this.file("utilization.csv"); }

  /// The body of the stream.
  async stream(signal) {
    const response = await this.request("/api/v1/stream", {signal, headers: {Accept: "text/event-stream"}});
    return response.body;
  }
}
