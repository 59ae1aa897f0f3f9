// Acts in words: "forced X off", for results and for the list of what was done. Steps of scenarios have the same words in the present
// tense, from the server (step_words.cpp).
import {factor, length, value} from "./words.js";

const kPlain = {inverted: false};

const kMostNames = 3;

const listed = (of, text = String) => {
  const texts = [of].flat().map(text);
  return texts.slice(0, kMostNames).join(", ") + (texts.length > kMostNames ? " and " + (texts.length - kMostNames) + " more" : "");
};
const pairs = (of, text) => listed(Object.entries(of), text);

const values = (of, symbolNamed) => pairs(of, ([name, to]) => name + " " + value(to, symbolNamed(name) ?? kPlain));

const quoted = (name) => "`" + name + "`";
const malfunctions = (of) => ([of].flat().length === 1 ? "malfunction " : "malfunctions ") + listed(of, quoted);

/// A location as scenarios have it, "BELT@300.000 mm": "BELT at 300 mm".
const location = (of) => of.replace(/@(\d+(?:\.\d+)?) mm$/, (_, mm) => " at " + length(mm * 1e3)).replace("@", " at ");

const kWords = {
  restart: (of) => "restarted the program" + (of === true ? "" : " of " + of),
  set: (of, symbolNamed) => "set " + values(of, symbolNamed),
  state: (of) => "put " + pairs(of, ([name, to]) => name + " into " + to),
  put: (of) => "put " + listed(of, ({at, kind}) => quoted(kind) + (at.includes("@") ? " on " : " at ") + location(at)),
  take: (of) => "took a part from " + listed(of, location),
  force: (of, symbolNamed) => "forced " + values(of, symbolNamed),
  release: (of) => "released " + (of === "all" ? "all" : listed(of)),
  stop: (of) => "stopped " + malfunctions(of),
  start: (of) => "started " + malfunctions(of),
  run: () => "ran",
  freeze: () => "froze",
  step: (of) => of === "change" ? "ran to the next change" : "ran one cycle",
  speed: (of) => "set the speed to " + (of === "max" ? of : factor(of)),
  reset: () => "reset the plant",
  snapshot: (of) => "took the snapshot " + of,
  save: (of) => "saved " + of,
  restore: (of) => "restored " + of,
  forget: (of) => "forgot " + of,
  exercise: (of) => "started the exercise " + of,
  end: () => "ended the exercise",
  count: () => "began to count utilization again",
  session: (of) => "saved the session " + of,
  acknowledge: (of) => "acknowledged " + (of === "all" ? "all alarms" : listed(of)),
  shelve: (of) => "shelved " + listed(of),
  for: (of) => "for " + of,
  unshelve: (of) => "unshelved " + listed(of),
  silence: () => "silenced the horn",
  join: () => "joined",
  camera: (of) => "showed everyone " + (of === "" ? "everything" : "the view " + quoted(of)),
  message: (of) => "sent: " + of,
  camera: (of) => "switched the 3D view to " + (of || "the overview"),
  layout: () => "saved the layout of the plan",
};

/// What an act, or a list of acts in one instant, did. Keys without words stay JSON. `symbolNamed(name)` gives the symbol of
/// that name, or nothing.
export const actText = (acts, symbolNamed = () => null) => [acts].flat().flatMap((act) => Object.entries(act)).map(([key, of]) =>
  Object.hasOwn(kWords, key) ? kWords[key](of, symbolNamed) : key + " " + JSON.stringify(of)).join(", ");
