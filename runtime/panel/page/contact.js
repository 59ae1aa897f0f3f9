// The controls of a contact, a device that no operation moves: a button for each state, which acts at once, and one that holds the other
// of two states.
import {actButton} from "./acts.js";
import {make, setAttribute} from "./dom.js";
import {holdButton} from "./hold_button.js";
import {contactState, mayOperateContact, otherState, stateAct} from "./person.js";
import {operates} from "./rights.js";

const kSettling = 1000;  // ms after a release in which the stream must show it

/// The state to which a hold goes: the other one; while it is held, and until the stream shows its release, the same one.
const holdTarget = (app, index) => {
  const {holds, plant} = app;
  const device = plant.devices[index];
  const now = contactState(app, index);
  const {entry, at} = holds.last(device.name) ?? {};
  const isSame = entry?.target !== undefined && (at === null || (now === entry.target && performance.now() - at < kSettling));
  return isSame ? entry.target : otherState(device, now);
};

/// A button that holds the other state of a contact of two states while it is down.
export const contactHold = (app, index, result, attributes = {}, label = (state) => "Hold " + state) => {
  const {plant} = app;
  const device = plant.devices[index];
  const target = () => holdTarget(app, index);
  return holdButton(app, {name: () => device.name, label: () => label(device.states[target()]), result,
    acts: () => ({target: target(), on: stateAct(app, index, device.states[target()]), off: stateAct(app, index, device.states[1 - target()])}),
    isPossible: () => mayOperateContact(app, index)},
  {title: "In this state while the mouse button or the key is down", ...attributes});
};

/// `update()` after each change.
export const contactControls = (app, index, result) => {
  if (!operates(app)) return null;
  const device = app.plant.devices[index];
  const buttons = device.states.map((state) => actButton(app, result, state, () => stateAct(app, index, state), {class: "state-button"},
    () => mayOperateContact(app, index)));
  const hold = device.states.length === 2 ? contactHold(app, index, result) : null;
  const update = () => {
    buttons.forEach((element, state) => setAttribute(element, "aria-pressed", String(contactState(app, index) === state)));
    hold?.refresh();
  };
  return {element: make("div", {class: "row controls operate"}, make("span", {class: "row", role: "group", "aria-label": "State of " + device.name}, buttons), hold), update};
};
