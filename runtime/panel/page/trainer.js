// What the trainer sees of the trainees: who is there, how fast they react, messages to them, and malfunctions to start.
import {actingButton, malfunctionButton, perform, showResult} from "./acts.js";
import {button, download, make, table, timeOf} from "./dom.js";
import {duration} from "./words.js";

const kMostMessage = 500;
const kMostRuns = 20;
const kFiles = [["training.csv", "Trainees as CSV"], ["reactions.csv", "Reaction times as CSV"]];

const time = (ns) => ns === null ? "-" : timeOf(ns);
const span = (ns) => ns === null ? "-" : duration(ns);

/// The rows of the table of trainees.
export const traineeRows = ({trainees}) => trainees.map(({name, since, last, acts, refused, least, mean, greatest}) =>
  [make("span", {class: "name"}, name), time(since), time(last), String(acts), String(refused), span(least), span(mean), span(greatest)]);

/// The rows of the table of reaction times, the newest malfunction first: a column for each trainee.
export const reactionRows = ({trainees, malfunctions}) => malfunctions.slice(-kMostRuns).reverse().map(({name, start, effect, end, reactions}) => {
  const of = new Map(reactions);
  return [make("span", {class: "name"}, name), time(start), time(effect), end === null ? "active" : timeOf(end),
    ...trainees.map((_, i) => span(of.get(i) ?? null))];
});

export class Trainer {
  /// `result` shows what became of an act.
  constructor(app, result) {
    Object.assign(this, {app, result});
    this.toggles = app.canAct ? app.plant.malfunctions.map(({name}) => [name, malfunctionButton(app, result, name)]) : [];
    const scrolls = (label) => make("div", {class: "scrolls", tabindex: 0, role: "group", "aria-label": label});
    this.trainees = scrolls("Table of trainees");
    this.reactions = scrolls("Table of reaction times");
    this.sent = make("div", {});
    this.element = make("div", {class: "trainer"},
      make("div", {}, make("section", {"aria-label": "Trainees"}, make("h2", {}, "Trainees"), this.trainees),
        make("section", {"aria-label": "Reaction times"}, make("h2", {}, "Reaction times"),
          make("p", {class: "soft"}, "From the first effect of a malfunction to the first act of each trainee, in plant time."), this.reactions,
          make("div", {class: "row controls"}, kFiles.map(([file, text]) => button(text, () => this.fetch(file)))))),
      app.canAct ? make("div", {}, make("section", {"aria-label": "Messages"}, make("h2", {}, "Message to all"), this.form(), this.sent),
        make("section", {"aria-label": "Start a malfunction"}, make("h2", {}, "Malfunctions"), this.malfunctions())) : null);
  }

  form() {
    const text = make("textarea", {"aria-label": "Message", rows: 2, maxlength: kMostMessage, placeholder: "Message"});
    const send = actingButton(this.app, "Send", async () => {
      const message = text.value.trim();
      if (message === "") return showResult(this.result, "write a message", true);
      if (await perform(this.app, this.result, () => ({message}))) text.value = "";
    });
    return make("div", {class: "row controls"}, text, send);
  }

  malfunctions() {
    const others = make("p", {}, make("a", {href: "#view=malfunctions"}, "All malfunctions"));
    if (this.toggles.length === 0) return [make("p", {class: "soft"}, "plant.json has no malfunctions"), others];
    return [make("ul", {class: "plain toggles"}, this.toggles.map(([name, {element}]) =>
      make("li", {class: "row"}, element, make("span", {class: "name"}, name)))), others];
  }

  async fetch(file) {
    try {
      download(await this.app.api.file(file), this.app.plant.plant.replace(/[^\p{L}\p{N}_-]+/gu, "-") + "." + file);
    } catch (error) {
      showResult(this.result, error.message, true);
    }
  }

  update() {
    const {messages, training} = this.app.store;
    const soft = (text) => make("p", {class: "soft"}, text);
    const {trainees, malfunctions} = training ?? {trainees: [], malfunctions: []};
    this.trainees.replaceChildren(trainees.length === 0 ? soft("No trainee has joined: each enters a name in this view.")
      : table("Trainees", ["Name", "First seen", "Last act", "Acts", "Refused", "Least reaction", "Mean reaction", "Greatest reaction"], traineeRows(training)));
    this.reactions.replaceChildren(malfunctions.length === 0 ? soft("No malfunction has started.")
      : table("Reaction times", ["Malfunction", "Start", "First effect", "End", ...trainees.map(({name}) => name)], reactionRows(training)));
    this.sent.replaceChildren(messages.length === 0 ? soft("No message was sent.") : make("ul", {class: "plain sent"},
      [...messages].reverse().map(({t, text}) => make("li", {class: "lines"}, timeOf(t), ": " + text))));
    for (const [, {update}] of this.toggles) update();
  }

  change(change) {
    if (change.all || ["messages", "training", "malfunctions"].some((key) => change.keys.has(key))) this.update();
  }
}
