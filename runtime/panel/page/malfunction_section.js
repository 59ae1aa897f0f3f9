// The malfunctions of a thing, in its details.
import {malfunctionButton} from "./acts.js";
import {make} from "./dom.js";
import {seesMalfunctions} from "./rights.js";

/// Buttons for malfunctions, [[name, label], ...]; without acts the active ones as text.
export const fillMalfunctions = (pane, names, result) => {
  const {app} = pane;
  if (names.length === 0 || !seesMalfunctions(app)) return;
  if (!app.canAct) {
    const active = () => app.store.malfunctions.map(([name]) => name).filter((name) => names.some(([of]) => of === name)).join(", ");
    return pane.section("Malfunctions", pane.live(() => active() || "none"));
  }
  const buttons = names.map(([name, label]) => malfunctionButton(app, result, name, label));
  for (const {update} of buttons) pane.follow(update);
  pane.section("Malfunctions", make("div", {class: "row controls"}, buttons.map(({element}) => element)));
};
