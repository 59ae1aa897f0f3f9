// The list of alarms as the page knows it: what changes lead to, what is urgent, and which alarms a filter shows.

export const PRIORITIES = [{key: "high", mark: "▲"}, {key: "medium", mark: "◆"}, {key: "low", mark: "▼"}];  // the most urgent first
const rank = Object.fromEntries(PRIORITIES.map(({key}, index) => [key, index]));

export const isUnacknowledged = ({state}) => state === "active" || state === "gone";

/// The most urgent first: what is not acknowledged, by priority, the newest first.
export const byUrgency = (a, b) => isUnacknowledged(b) - isUnacknowledged(a) || rank[a.priority] - rank[b.priority] || b.came - a.came
  || (a.name < b.name ? -1 : 1);

/// { priority, station, state } as a function of an alarm. An empty one passes all that is not shelved; `station` is an index as text, or
/// "none"; `state` is a state, or "unacknowledged".
export const alarmFilter = ({priority = "", station = "", state = ""}) => (alarm) => {
  if (alarm.state === "shelved") return false;
  if (priority && alarm.priority !== priority) return false;
  if (station && String(alarm.station ?? "none") !== station) return false;
  return state === "unacknowledged" ? isUnacknowledged(alarm) : !state || alarm.state === state;
};

export class AlarmState {
  constructor() { this.apply({all: true}); }

  /// The key `alarms` of an event.
  apply({all, horn = false, dropped = 0, list = [], left = []}) {
    if (all) this.byName = new Map();
    for (const name of left) this.byName.delete(name);
    for (const alarm of list) this.byName.set(alarm.name, alarm);
    Object.assign(this, {horn, dropped, first: null, counts: {high: 0, medium: 0, low: 0}});
    for (const alarm of this.byName.values()) {
      if (!isUnacknowledged(alarm)) continue;
      this.counts[alarm.priority] += 1;
      if (this.first === null || byUrgency(alarm, this.first) < 0) this.first = alarm;
    }
  }

  get size() { return this.byName.size; }
  shelved() { return [...this.byName.values()].filter(({state}) => state === "shelved").sort((a, b) => a.until - b.until); }
  filtered(filter) { return [...this.byName.values()].filter(alarmFilter(filter)).sort(byUrgency); }
}
