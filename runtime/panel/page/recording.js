// The bar at the top of a recording: a slider over its time, and playing at 0.1 to 100 times real time.
import {button, make, select, setAttribute, setText} from "./dom.js";
import {clockText} from "./words.js";

const kSpeeds = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];
const kPause = 60;  // ms between two pictures while it plays
const kSteps = 10000;

/// Asks for the pictures of a recording and gives them to the store, with a clock of the page.
export class Player {
  constructor(app) {
    Object.assign(this, {app, begin: app.plant.begin, end: app.plant.end, playing: false, rate: 1, from: app.plant.begin, since: 0, busy: false, wanted: null, last: 0, wrong: ""});
  }

  /// The time that is shown.
  now(wall = performance.now()) {
    return this.playing ? Math.min(this.end, this.from + (wall - this.since) * 1e6 * this.rate) : this.from;
  }

  seek(t) {
    this.from = Math.max(this.begin, Math.min(this.end, t));
    this.since = performance.now();
    this.load(this.from);
  }

  setRate(rate) {
    this.from = this.now();
    this.since = performance.now();
    this.rate = rate;
    this.load(this.from);
  }

  play(on) {
    this.from = on && this.now() >= this.end ? this.begin : this.now();
    this.since = performance.now();
    this.playing = on;
    this.load(this.from);
    this.app.frames.request();
  }

  /// One question at a time; the last one asked wins.
  async load(t) {
    this.wanted = t;
    if (this.busy) return;
    this.busy = true;
    while (this.wanted !== null) {
      const asked = Math.round(this.wanted);
      this.wanted = null;
      try {
        const picture = await this.app.api.at(asked);
        const isRunning = this.playing;
        this.app.receive("picture", {...picture, t: asked, clock: {state: isRunning ? "running" : "frozen", speed: this.rate,
          real_speed: this.rate, until: this.end}});
        this.wrong = "";
      } catch (error) {
        this.wrong = error.message;
      }
    }
    this.busy = false;
  }

  /// Returns whether it plays on.
  frame(wall = performance.now()) {
    if (!this.playing) return false;
    const now = this.now(wall);
    if (now >= this.end) {
      this.play(false);
    } else if (!this.busy && wall - this.last > kPause) {
      this.last = wall;
      this.load(now);
    }
    return this.playing;
  }
}

export class RecordingBar {
  constructor(app, player) {
    Object.assign(this, {app, player});
    this.time = make("span", {class: "plant-time", role: "timer", "aria-label": "Time in the recording"});
    this.end = make("span", {class: "soft"}, "of " + clockText(player.end));
    this.playButton = button("Play", () => player.play(!player.playing), {class: "run"});
    this.speed = select("Speed", kSpeeds.map((speed) => [String(speed), speed + " x"]), {onchange: () => player.setRate(Number(this.speed.value))});
    this.speed.value = "1";
    this.slider = make("input", {type: "range", min: 0, max: kSteps, value: 0, step: 1, class: "grow", "aria-label": "Time",
      oninput: () => player.seek(player.begin + this.slider.value / kSteps * (player.end - player.begin))});
    this.wrong = make("output", {class: "result wrong"});
    this.marks = null;
    this.element = make("div", {class: "row bar"}, this.playButton, this.speed, this.time, this.end, this.slider,
      make("span", {class: "note"}, "A recording: acts are off."), this.wrong);
  }

  toggle() { this.player.play(!this.player.playing); }
  update() {
    setText(this.playButton, this.player.playing ? "Pause" : "Play");
    setText(this.wrong, this.player.wrong);
  }

  tick() {
    const now = this.player.now();
    const {begin, end} = this.player;
    setText(this.time, clockText(now));
    setAttribute(this.slider, "aria-valuetext", clockText(now));
    if (document.activeElement !== this.slider || this.player.playing) {
      this.slider.value = String(Math.round((now - begin) / Math.max(1, end - begin) * kSteps));
    }
    this.update();
  }
}
