// The details of a requirement.
import {make} from "./dom.js";
import {lastFindings} from "./finding_list.js";
import {count, instant} from "./words.js";

const kKinds = {never: "its condition must never hold", always: "its condition must always hold"};

export const requirementState = (store, index) => store.requirements[index] ?? ["ok", 0, 0];

const violations = ([, last, number]) => number === 0 ? "no violation" : count(number, "violation") + ", the last at " + instant(last);

export const fillRequirement = (pane, index) => {
  const {store, plant} = pane.app;
  const {name, kind} = plant.requirements[index];
  pane.section("State",
    make("p", {class: "big"}, pane.live(() => requirementState(store, index)[0])),
    make("p", {}, pane.live(() => violations(requirementState(store, index)))),
    make("p", {class: "soft"}, kKinds[kind] ?? kind));
  pane.section("Last findings", lastFindings(pane, (of) => of === name));
};
