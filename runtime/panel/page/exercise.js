// The exercise view: for the trainee the present step, for the trainer all steps, points and times.
import {actButton, resultOutput} from "./acts.js";
import {button, make, setAttribute, setText} from "./dom.js";
import {TraineeName} from "./trainee_name.js";
import {Trainer} from "./trainer.js";
import {count, duration, instant} from "./words.js";

const kLetters = {pending: "○", active: "▶", done: "✓", failed: "✗"};

export class ExerciseView {
  constructor(app) {
    Object.assign(this, {app, title: "Exercises", trainer: app.plant.role === "trainer", shown: ""});
    this.result = resultOutput();
    this.running = make("div", {});
    this.time = make("span", {class: "big"});
    this.name = app.rights === "allowed" ? new TraineeName(app, this.result) : null;
    this.training = this.trainer ? new Trainer(app, this.result) : null;
    const choose = (trainer, text) => button(text, () => this.choose(trainer), {class: "toggle"});
    this.roles = this.trainer ? [choose(false, "Trainee"), choose(true, "Trainer")] : [];
    this.element = make("div", {class: "view columns"},
      make("section", {"aria-label": "Exercise"}, this.trainer ? make("div", {class: "row", role: "group", "aria-label": "View of the"}, this.roles) : null,
        this.name?.element ?? null, this.running, this.result, this.training?.element ?? null),
      this.trainer ? make("section", {"aria-label": "Exercises of this plant"}, make("h2", {}, "Exercises of this plant"), this.offers()) : null);
  }

  offers() {
    const {app, result} = this;
    if (app.plant.exercises.length === 0) return make("p", {class: "soft"}, "none; an exercise is a scenario with the key exercise");
    return app.plant.exercises.map(({name, title, text, steps}) => make("article", {class: "offer"}, make("h3", {}, title),
      make("p", {class: "lines"}, text), make("div", {class: "row"}, make("span", {class: "soft grow"}, count(steps, "step")),
        app.canAct ? actButton(app, result, "Start", () => ({exercise: name}), {"aria-label": "Start " + title}) : null)));
  }

  choose(trainer) {
    this.trainer = trainer;
    this.show();
  }

  show() {
    this.roles.forEach((element, i) => setAttribute(element, "aria-pressed", String(Boolean(i) === this.trainer)));
    if (this.training) setAttribute(this.training.element, "hidden", this.trainer ? null : "");
    this.shown = "";
    this.update();
    this.training?.update();
  }

  update() {
    const {exercise} = this.app.store;
    const text = JSON.stringify(exercise);
    if (text === this.shown) return;
    this.shown = text;
    if (!exercise) return this.running.replaceChildren(make("p", {class: "soft"}, "No exercise is running."));
    const isOver = exercise.state === "over";
    this.running.replaceChildren(make("h2", {}, exercise.title), make("p", {class: "lines"}, exercise.text),
      make("p", {class: "row"}, this.time, exercise.score === undefined ? null : make("span", {class: "big"}, exercise.score + " of " + exercise.most + " points")),
      ...(isOver ? [make("p", {class: "note"}, "The exercise is over.")] : []),
      this.trainer ? this.allSteps(exercise) : this.presentStep(exercise),
      ...(this.trainer ? [this.points(exercise)] : []),
      ...(this.app.canAct ? [actButton(this.app, this.result, isOver ? "Close the exercise" : "End the exercise", () => ({end: "exercise"}))] : []));
    this.tick();
  }

  /// For the trainee: what is done, and what to do now. What comes is not shown.
  presentStep({steps, step, state}) {
    const done = steps.slice(0, state === "over" ? steps.length : step).filter(({text}) => text);
    const now = state === "over" ? null : steps[step];
    return make("div", {}, now ? make("p", {class: "present-step", role: "status"}, now.text || "...") : null,
      make("ol", {class: "steps"}, done.map((of) => this.stepItem(of))));
  }

  stepItem({text, does, state, t}) {
    return make("li", {class: "step-" + state}, make("span", {class: "letter", "aria-hidden": "true"}, kLetters[state] ?? "?"), " ", text || does || "(a step without text)", " ",
      make("span", {class: "soft"}, state + (t === null || t === undefined ? "" : " at " + instant(t))));
  }

  allSteps({steps}) { return make("ol", {class: "steps"}, steps.map((step) => this.stepItem(step))); }

  points({points}) {
    return make("div", {}, make("h3", {}, "Points"), points.length === 0 ? make("p", {class: "soft"}, "none yet") : make("ul", {class: "plain"},
      points.map(({t, points: number, text}) => make("li", {}, instant(t) + ": ", make("strong", {}, (number > 0 ? "+" : "") + number), " " + text))));
  }

  change(change) {
    if (change.all || change.keys.has("exercise")) this.update();
    if (this.trainer) this.training.change(change);
  }

  tick() {
    const {exercise} = this.app.store;
    if (!exercise) return;
    const took = exercise.took ?? Math.max(0, this.app.clock.now() - exercise.since);
    setText(this.time, duration(Math.floor(took / 1e8) * 1e8));
  }
}
