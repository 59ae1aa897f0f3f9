// What a person operates, and by which acts: symbols that nothing else writes, and devices that no operation moves. Without elements.
import {isOn, levels} from "./words.js";

/// By what an operation is written, so that a person can only force it; "" if a person may set it.
export const writerText = (plant, {direction, program, link}) => {
  if (direction === "event") return "";
  if (program !== undefined) return "written by the program " + (plant.programs[program]?.name ?? program);
  return link === null ? "" : "written by the PLC over " + (plant.links[link]?.name ?? "link " + link);
};

/// Whether an act can set the symbol.
export const isSettable = (plant, symbol) => symbol.direction === "event" ? symbol.driver === "none" : writerText(plant, symbol) === "";

/// Whether no operation moves the device, so that a person puts it into its states: a door, an emergency stop, a button.
export const isContact = (plant, {operations, events, states}) => operations.length === 0 && states.length > 1
  && events.length > 0 && events.every((symbol) => plant.symbols[symbol].driver === "none");

/// The act that sets a symbol to a meaning: `on` also of an inverted one.
export const setAct = (symbol, on) => ({set: {[symbol.name]: levels(symbol)[on ? 0 : 1][1]}});

const lastLevel = ({name}) => name.split(/[_.]/).pop();

const boolEvents = ({plant}, device) => device.events.filter((index) => plant.symbols[index].type === "BOOL");

/// Whether the page puts the contact into a state by its events, since a trainee may set these and not the device.
const isByEvents = (app, index) => !app.may("devices", index) && app.rights === "allowed";

/// Whether the page may put the contact into its states.
export const mayOperateContact = (app, index) => {
  const events = boolEvents(app, app.plant.devices[index]);
  return app.may("devices", index) || (events.length > 0 && events.every((symbol) => app.may("symbols", symbol)));
};

/// The act that puts a contact into a state. Its events are on in the state of their name.
export const stateAct = (app, index, state) => {
  const device = app.plant.devices[index];
  if (!isByEvents(app, index)) return {state: {[device.name]: state}};
  const events = boolEvents(app, device).map((symbol) => app.plant.symbols[symbol]);
  return {set: Object.assign({}, ...events.map((symbol) => setAct(symbol, lastLevel(symbol) === state).set))};
};

/// The state of a contact that its controls show, as an index. `set` changes its events only.
export const contactState = (app, index) => {
  const {plant, store} = app;
  const {events, states} = plant.devices[index];
  if (!isByEvents(app, index)) return store.state[index];
  const eventOf = (name) => events.find((symbol) => lastLevel(plant.symbols[symbol]) === name);
  const on = states.findIndex((name) => eventOf(name) !== undefined && isOn(plant.symbols[eventOf(name)], store.values[eventOf(name)]));
  const without = states.findIndex((name) => eventOf(name) === undefined);
  return on >= 0 ? on : without >= 0 ? without : store.state[index];
};

/// The state to which a contact of two states goes from `state`, as an index; -1 if it has more.
export const otherState = ({states}, state) => states.length === 2 ? 1 - state : -1;
