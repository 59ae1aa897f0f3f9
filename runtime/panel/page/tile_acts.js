// The buttons in the tile of a contact: one press puts a door, a selector or a button into a state, or holds it there.
import {actButton, resultOutput} from "./acts.js";
import {contactHold} from "./contact.js";
import {make, setAttribute, setText} from "./dom.js";
import {contactState, mayOperateContact, otherState, stateAct} from "./person.js";

export class TileActs {
  /// `tile` is the link that the buttons are next to: a link has no buttons in it.
  constructor(app, index, tile) {
    Object.assign(this, {app, index, device: app.plant.devices[index]});
    this.result = resultOutput();
    const isTwo = this.device.states.length === 2;
    this.text = make("span", {});
    this.change = actButton(app, this.result, this.text, () => stateAct(app, index, this.device.states[this.next()]), {class: "tiny cut"},
      () => mayOperateContact(app, index));
    this.hold = isTwo ? contactHold(app, index, this.result, {class: "tiny", "aria-label": "Hold, " + this.device.name}, () => "Hold") : null;
    this.element = make("div", {class: "tile-box"}, tile, make("span", {class: "tile-acts"}, this.hold, this.change), this.result);
    this.update();
  }

  /// The state to which the button switches: the other one, or the next one in a circle.
  next() {
    const now = contactState(this.app, this.index);
    const other = otherState(this.device, now);
    return other >= 0 ? other : (now + 1) % this.device.states.length;
  }

  /// Whether Tab stops at the buttons: those of one tile of a grid.
  setTab(tabIndex) { for (const element of [this.hold, this.change]) if (element) element.tabIndex = tabIndex; }

  update() {
    const {name, states} = this.device;
    setText(this.text, "→ " + states[this.next()]);
    setAttribute(this.change, "aria-label", "→ " + states[this.next()] + ", " + name);
    setAttribute(this.change, "title", "Puts " + name + " into " + states[this.next()]);
    this.hold?.refresh();
  }
}
