// The strip of the exercise below the bar, in every view: what is to be done now, the time and, if it is shown, the score.
import {make, setText} from "./dom.js";
import {duration} from "./words.js";

export class ExerciseStrip {
  constructor(app) {
    this.app = app;
    this.title = make("a", {href: "#view=exercises"});
    this.step = make("span", {class: "grow"});
    this.time = make("span", {});
    this.score = make("span", {});
    this.element = make("div", {class: "row exercise-strip", hidden: true, role: "group", "aria-label": "Exercise"},
      this.title, this.step, this.time, this.score);
  }

  change(change) {
    if (!change.all && !change.keys.has("exercise")) return;
    const {exercise} = this.app.store;
    this.element.hidden = exercise === null;
    if (exercise === null) return;
    setText(this.title, exercise.title);
    const {text} = exercise.steps[exercise.step] ?? {};
    const step = "Step " + (exercise.step + 1) + " of " + exercise.steps.length + (text ? ": " + text : "");
    setText(this.step, exercise.state === "over" ? "The exercise is over." : step);
    setText(this.score, exercise.score === undefined ? "" : exercise.score + " of " + exercise.most + " points");
    this.tick();
  }

  tick() {
    const {exercise} = this.app.store;
    if (exercise === null) return;
    const took = exercise.took ?? Math.max(0, this.app.clock.now() - exercise.since);
    setText(this.time, took < 1e9 ? "0 s" : duration(Math.floor(took / 1e9) * 1e9));
  }
}
