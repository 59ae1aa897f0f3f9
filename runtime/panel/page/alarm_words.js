// Alarms in words and marks: states and priorities are never shown by color alone.
import {make, setText} from "./dom.js";
import {PRIORITIES} from "./alarm_state.js";
import {clockText, withRoundTimes} from "./words.js";

const kStates = {
  active: {letter: "!", text: "active"}, acknowledged: {letter: "✓", text: "acknowledged"},
  gone: {letter: "○", text: "gone"}, shelved: {letter: "S", text: "shelved"},
};
const kMarks = Object.fromEntries(PRIORITIES.map(({key, mark}) => [key, mark]));

/// States for a filter, as [value, text].
export const stateChoices = [["", "All states"], ["unacknowledged", "Not acknowledged"], ["active", "Active"], ["acknowledged", "Acknowledged"], ["gone", "Gone"]];
export const priorityChoices = [["", "All priorities"], ...PRIORITIES.map(({key}) => [key, key[0].toUpperCase() + key.slice(1)])];

/// A letter and a word for a state; `update(state)`.
export const stateMark = () => {
  const letter = make("span", {class: "letter", "aria-hidden": "true"});
  const text = make("span", {});
  const element = make("span", {class: "alarm-state"}, letter, text);
  return {element, update: (state) => {
    element.dataset.state = state;
    setText(letter, kStates[state].letter);
    setText(text, kStates[state].text);
  }};
};

export const priorityText = (priority) => kMarks[priority] + " " + priority;

/// What an alarm says; its comment or its name, or the words of its finding.
export const alarmText = ({text}) => withRoundTimes(text);

/// "0:01:05.3", or with the end: "0:01:05.3 to 0:02:00.0".
export const timesText = ({came, went}) => clockText(came) + (went === null || went === came ? "" : " to " + clockText(went));

export const stationText = (plant, {station}) => station === null ? "" : plant.stations[station]?.name ?? "";
