// The controls of *Edit layout*: turn, group, undo, the picture behind the plan, save.
import {resultOutput, showResult} from "../acts.js";
import {ask} from "../dialog.js";
import {button, download, make, select} from "../dom.js";
import {savePlan} from "./save.js";

const kPicture = /\.(svg|png)$/;
const kInclude = 'Add "include": ["layout.json"] to plant.json to keep it.';
const kFields = [["x", "x", .5], ["y", "y", .5], ["width", "Width", .5], ["opacity", "Opacity", .05]];

export class EditBar {
  constructor(app, edit) {
    Object.assign(this, {app, edit});
    this.result = resultOutput();
    this.turn = button("Turn", () => edit.turn(), {title: "A quarter clockwise (R)"});
    this.name = make("input", {type: "text", "aria-label": "Name of the group", placeholder: "Group", size: 10, maxlength: 60});
    this.group = button("Group", () => this.toGroup());
    this.ungroup = button("Ungroup", () => edit.group(null));
    this.undo = button("Undo", () => edit.undo(), {title: "Ctrl+Z"});
    this.redo = button("Redo", () => edit.redo(), {title: "Ctrl+Y"});
    this.file = select("Picture behind the plan", [["", "No picture"]], {onchange: () => this.toPicture()});
    this.fields = new Map(kFields.map(([key, label, step]) => [key, make("input", {type: "number", step, "aria-label": label + " of the picture", title: label, onchange: () => this.toPicture()})]));
    this.save = button("Save", () => this.toSave(), {class: "primary"});
    this.picture = make("span", {class: "row"}, [...this.fields.values()]);
    this.element = make("div", {class: "row tools edit-bar", role: "group", "aria-label": "Edit layout", hidden: true},
      this.turn, make("span", {class: "row"}, this.name, this.group, this.ungroup), this.undo, this.redo, button("Automatic", () => edit.automatic(), {title: "The layout without given positions"}),
      make("span", {class: "row"}, this.file, this.picture), this.save, button("Cancel", () => this.toCancel()), this.result);
  }

  show(on) {
    this.element.hidden = !on;
    showResult(this.result, "");
    if (on) this.loadFiles();
  }

  async loadFiles() {
    const files = await this.app.api.files().catch(() => []);
    const names = new Set([...files.filter((file) => kPicture.test(file)), ...(this.edit.plan.background ? [this.edit.plan.background.file] : [])]);
    this.file.replaceChildren(...[["", names.size > 0 ? "No picture" : "No picture in the folder of --panel-files"], ...[...names].map((file) => [file, file])]
      .map(([value, text]) => make("option", {value}, text)));
    this.update();
  }

  /// After a change of the plan or the selection.
  update() {
    const {edit} = this;
    const things = edit.things();
    this.turn.disabled = !things.some(({kind, index}) => kind === "device" || kind === "location" && this.app.plant.locations[index].kind === "track");
    this.group.disabled = !things.some(({kind}) => kind === "device");
    this.ungroup.disabled = !things.some(({kind, index}) => kind === "device" ? this.isGrouped(index) : kind === "frame" && edit.placed.frames[index].station === null);
    this.undo.disabled = edit.done.length === 0;
    this.redo.disabled = edit.undone.length === 0;
    this.save.disabled = !edit.isChanged();
    const {background} = edit.plan;
    this.file.value = background?.file ?? "";
    this.picture.hidden = !background;
    for (const [key, field] of this.fields) field.value = background ? background[key] ?? 1 : "";
  }

  isGrouped(device) {
    const {frame} = this.edit.placed.devices[device];
    return frame !== null && this.edit.placed.frames[frame].station !== this.app.plant.devices[device].station;
  }

  toGroup() {
    const name = this.name.value.trim();
    if (name === "") {
      showResult(this.result, "the group needs a name", true);
      return this.name.focus();
    }
    this.edit.group(name);
    this.name.value = "";
  }

  /// The picture as the fields say; a new one is as wide as the plan.
  toPicture() {
    const {edit} = this;
    if (this.file.value === "") return edit.setBackground(null);
    const {bounds} = edit.placed;
    const before = edit.plan.background ?? {x: bounds.x, y: bounds.y, width: bounds.w, opacity: .6};
    const read = (key, least, most) => {
      const number = this.fields.get(key).valueAsNumber;
      return Number.isFinite(number) ? Math.max(least, Math.min(most, number)) : before[key];
    };
    edit.setBackground(edit.plan.background ? {file: this.file.value, x: read("x", -1e4, 1e4), y: read("y", -1e4, 1e4), width: read("width", .5, 1e4), opacity: read("opacity", .05, 1)}
      : {file: this.file.value, ...before});
  }

  /// Until the answer nothing can be changed.
  async toSave() {
    const {edit, app} = this;
    if (edit.isSaving) return;
    const {plan} = edit;
    this.hold(true);
    const {file, error, revision} = await savePlan(app, plan, edit.revision);
    this.hold(false);
    if (error) {
      edit.newer();
      edit.revision = revision;
      return showResult(this.result, error.status === 401 ? app.deniedText : error.message, true);
    }
    if (file === null) download(new Blob([JSON.stringify({symplant: 1, plan}, null, 2) + "\n"], {type: "application/json"}), "layout.json");
    edit.end();
    edit.view.note((file === null ? "All see the layout. There is no --panel-files: layout.json was downloaded; put it next to plant.json. " : "All see the layout. It was written to " + file + ". ") + kInclude);
  }

  hold(on) {
    this.edit.isSaving = on;
    this.element.inert = on;
    this.element.setAttribute("aria-busy", on);
  }

  async toCancel() {
    if (this.edit.isChanged() && !await ask("Discard the changes of the layout?", ["They were not saved."], "Discard")) return;
    this.edit.end();
  }
}
