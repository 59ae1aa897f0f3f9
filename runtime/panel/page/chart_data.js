// The changes of one row of the chart, and what is drawn of them. Without elements.

/// The last index of `times` that is not later than `t`, or -1.
export const lastNotAfter = (times, t) => {
  let from = 0;
  let until = times.length;
  while (from < until) {
    const middle = (from + until) >> 1;
    if (times[middle] <= t) from = middle + 1;
    else until = middle;
  }
  return from - 1;
};

/// The number of a value of a symbol: integers beyond 2^53 and numbers that are not finite come as texts.
export const numberOf = (value) => typeof value === "number" ? value
  : {inf: Infinity, "-inf": -Infinity}[value] ?? Number(value);

export class ChartRow {
  constructor() {
    this.times = [];
    this.values = [];  // of a device: { state, target }; of a symbol also texts, see numberOf()
  }

  clear() {
    this.times.length = 0;
    this.values.length = 0;
  }

  /// Entries as the interface has them: [t, value] of a symbol, [t, state, target] of a device. Later entries of one time
  /// replace earlier ones.
  append(entries) {
    for (const [t, value, target] of entries) {
      const last = this.times.length - 1;
      const kept = target === undefined ? value : {state: value, target};
      if (last >= 0 && this.times[last] === t) {
        this.values[last] = kept;
      } else if (last < 0 || t > this.times[last]) {
        this.times.push(t);
        this.values.push(kept);
      }
    }
  }

  /// Forgets what was before `t`, except the value at `t`.
  prune(t) {
    const first = lastNotAfter(this.times, t);
    if (first < 1000) return;
    this.times.splice(0, first);
    this.values.splice(0, first);
  }

  /// undefined before the first entry.
  at(t) { return this.values[lastNotAfter(this.times, t)]; }

  /// The number at a time as line() draws it: between two samples it is on the line from one to the other. undefined before
  /// the first entry.
  numberAt(t, every) {
    const index = lastNotAfter(this.times, t);
    if (index < 0) return undefined;
    const before = numberOf(this.values[index]);
    const next = this.times[index + 1];
    if (next === undefined) return before;
    const begin = Math.max(this.times[index], next - every);
    return t <= begin ? before : before + (numberOf(this.values[index + 1]) - before) * (t - begin) / (next - begin);
  }

  /// How many changes there are after `from` and not after `to`.
  changesBetween(from, to) { return lastNotAfter(this.times, to) - lastNotAfter(this.times, from); }

  /// The nearest change after (`by` 1) or before (-1) a time, or null.
  neighbor(t, by) {
    const at = lastNotAfter(this.times, t);
    const index = by > 0 ? at + 1 : this.times[at] === t ? at - 1 : at;
    return index > 0 && index < this.times.length ? this.times[index] : null;
  }

  /// The line of a number between `from` and `to` on `width` pixels: [x, y] with y as a number. A number is known at each whole
  /// multiple of `every` at which it changed: it holds until one `every` before the next change. Of the changes in one pixel
  /// the first, the least, the greatest and the last remain, so that no peak is lost, however many there are. With `every` 0 it
  /// is a line of steps. A number that is not finite is a gap: [x, NaN].
  line(from, to, end, width, every) {
    const {times} = this;
    const number = (at) => numberOf(this.values[at]);
    const scale = width / (to - from);
    const last = Math.min(to, end);
    const points = [];
    let column = null;
    const close = () => {
      if (column === null) return;
      const {x, first, least, greatest, final} = column;
      points.push([x, first]);
      if (least < Math.min(first, final)) points.push([x, least]);
      if (greatest > Math.max(first, final)) points.push([x, greatest]);
      if (final !== first) points.push([x, final]);
      column = null;
    };
    const add = (t, number) => {
      const x = Math.max(-width, Math.floor((t - from) * scale));
      if (!Number.isFinite(number)) {
        close();
        points.push([x, NaN]);
        return;
      }
      if (column?.x !== x) {
        close();
        column = {x, first: number, least: number, greatest: number, final: number};
      }
      column.least = Math.min(column.least, number);
      column.greatest = Math.max(column.greatest, number);
      column.final = number;
    };
    let index = Math.max(0, lastNotAfter(times, from));
    for (; index < times.length && times[index] <= last; ++index) {
      if (index > 0 && times[index] - times[index - 1] > every) add(times[index] - every, number(index - 1));
      add(times[index], number(index));
    }
    if (index < times.length && index > 0 && times[index - 1] <= last) {
      if (times[index] - every > times[index - 1]) add(Math.min(times[index] - every, last), number(index - 1));
      if (times[index] - every < last) add(times[index], number(index));
    } else if (index > 0) {
      add(last, number(index - 1));
    }
    close();
    return points;
  }

  /// The least and the greatest finite number between `from` and `to`, with that at `from`; null if none is known.
  extent(from, to) {
    const {times, values} = this;
    let [least, greatest] = [Infinity, -Infinity];
    for (let index = Math.max(0, lastNotAfter(times, from)); index < times.length && times[index] <= to; ++index) {
      const number = numberOf(values[index]);
      if (!Number.isFinite(number)) continue;
      if (number < least) least = number;
      if (number > greatest) greatest = number;
    }
    return least <= greatest ? [least, greatest] : null;
  }

  /// What is drawn between `from` and `to` on `width` pixels: [x begin, x end, value, dense]. Changes that are closer
  /// together than a pixel become one dense piece, so that the number of pieces does not depend on that of the changes.
  pieces(from, to, end, width) {
    const {times, values} = this;
    const scale = width / (to - from);
    const last = Math.min(to, end);
    const x = (t) => (Math.max(from, Math.min(t ?? last, last)) - from) * scale;
    const found = [];
    let index = Math.max(0, lastNotAfter(times, from));
    while (index < times.length && times[index] < last) {
      const begin = x(times[index]);
      const until = x(times[index + 1]);
      if (until - begin >= 1 || index + 1 === times.length) {
        found.push([begin, until, values[index], false]);
        index += 1;
        continue;
      }
      const next = Math.max(index + 1, lastNotAfter(times, from + (begin + 1) / scale));
      const stop = Math.max(begin + 1, x(times[next]));
      const before = found[found.length - 1];
      if (before?.[3] && begin - before[1] < 1) before[1] = stop;
      else found.push([begin, stop, values[index], true]);
      index = next;
    }
    return found;
  }
}
