// The session view: snapshots and backtracks, files of the session, and what was done.
import {actText} from "./act_words.js";
import {actButton, actingButton, resultOutput, showResult} from "./acts.js";
import {presentName, restore} from "./control.js";
import {button, download, make, table, timeOf} from "./dom.js";

const kMostActs = 200;
const kStart = "session.start.snapshot";  // with which the scenario of a session after a restore begins
const kFiles = [["scenario", "Scenario", ".scenario.json"], ["session", "Session as JSON", ".session.json"], ["junit", "JUnit", ".junit.xml"]];
const kWithPlc = "The acts, findings and score of the session as JSON, and JUnit. There is no scenario that replays it: what the PLC wrote is not recorded.";

export class SessionView {
  constructor(app) {
    Object.assign(this, {app, title: "Session"});
    this.result = resultOutput();  // of snapshots
    this.fileResult = resultOutput();
    this.snapshots = make("div", {});
    this.acts = make("div", {});
    this.element = make("div", {class: "view columns"},
      make("section", {"aria-label": "Snapshots"}, make("h2", {}, "Snapshots and backtracks"), this.takeForm(), this.result,
        app.plant.with_plc ? make("p", {class: "note"}, "A PLC that is connected does not jump with a restore.") : null, this.snapshots),
      make("section", {"aria-label": "Files"}, make("h2", {}, "Files of this session"), this.files(), this.fileResult),
      make("section", {"aria-label": "Acts"}, make("h2", {}, "What was done"), this.acts));
  }

  takeForm() {
    const {app, result} = this;
    if (!app.canAct) return null;
    const name = make("input", {type: "text", "aria-label": "Name of the snapshot", placeholder: "Name", maxlength: 64, size: 20});
    return make("div", {class: "row controls"}, name, actButton(app, result, "Take snapshot",
      () => ({snapshot: name.value.trim() || presentName(app)})));
  }

  files() {
    const {app, fileResult: result} = this;
    const fetchFile = async (kind, ending) => {
      try {
        const file = await app.api.session(kind);
        download(file, app.plant.plant.replace(/[^\p{L}\p{N}_-]+/gu, "-") + ending);
        if (kind === "scenario" && (await file.text()).includes('"restore": "' + kStart + '"')) download(await app.api.session("start"), kStart);
        showResult(result, "");
      } catch (error) {
        showResult(result, error.message, true);
      }
    };
    const name = make("input", {type: "text", "aria-label": "Name of the session", placeholder: "Name", maxlength: 64, size: 20});
    const withPlc = app.plant.with_plc;
    return [make("p", {class: "soft"}, withPlc ? kWithPlc : "A scenario that replays the session, its acts, findings and score as JSON, and JUnit."),
      make("div", {class: "row controls"}, kFiles.filter(([kind]) => kind !== "scenario" || !withPlc).map(([kind, text, ending]) => button("Download " + text, () => fetchFile(kind, ending)))),
      app.canAct && app.plant.files ? make("div", {class: "row controls"}, name,
        actButton(app, result, "Save on the plant's computer", () => ({session: name.value.trim()}))) : null,
      app.plant.files ? null : make("p", {class: "soft"}, "Start symplant with --panel-files FOLDER to save snapshots and sessions there.")];
  }

  show() {
    this.showSnapshots();
    this.showActs();
  }

  showSnapshots() {
    const {app, result} = this;
    const buttons = (snapshot) => make("span", {class: "row"},
      actingButton(app, "Restore", () => restore(app, result, snapshot), {class: "small", "aria-label": "Restore " + snapshot.name}),
      app.plant.files && !snapshot.file ? actButton(app, result, "Save", () => ({save: snapshot.name}), {class: "small", "aria-label": "Save " + snapshot.name}) : null,
      actButton(app, result, "Forget", () => ({forget: snapshot.name}), {class: "small", "aria-label": "Forget " + snapshot.name}));
    const heads = ["Name", "Plant time", "Kind", ...(app.canAct ? ["Acts"] : [])];
    const rows = [...app.store.snapshots].reverse().map((snapshot) => [make("span", {class: "name"}, snapshot.name), snapshot.t === null ? "-" : timeOf(snapshot.t),
      snapshot.kind + (snapshot.file ? ", in a file" : ""), ...(app.canAct ? [buttons(snapshot)] : [])]);
    this.snapshots.replaceChildren(rows.length > 0 ? table("Snapshots and backtracks", heads, rows) : make("p", {class: "soft"}, "none yet"));
  }

  showActs() {
    const {acts} = this.app.store;
    const rows = acts.slice(-kMostActs).reverse().map(({t, by, name, act}) =>
      [timeOf(t), name ?? by, make("span", {class: "name", title: JSON.stringify(act)}, actText(act, (name) => this.app.names.symbol(name)))]);
    this.acts.replaceChildren(rows.length > 0 ? table("Acts, the newest first", ["Plant time", "By", "What"], rows)
      : make("p", {class: "soft"}, "nothing yet"));
  }

  change(change) {
    if (change.all || change.keys.has("snapshots")) this.showSnapshots();
    if (change.all || change.keys.has("acts")) this.showActs();
  }
}

