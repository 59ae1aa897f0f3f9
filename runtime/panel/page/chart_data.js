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

export class ChartRow {
  constructor() {
    this.times = [];
    this.values = [];  // of a device: { state, target }
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

  /// The nearest change after (`by` 1) or before (-1) a time, or null.
  neighbor(t, by) {
    const at = lastNotAfter(this.times, t);
    const index = by > 0 ? at + 1 : this.times[at] === t ? at - 1 : at;
    return index > 0 && index < this.times.length ? this.times[index] : null;
  }

  /// The line of a number between `from` and `to` on `width` pixels: [x, y] with y as a number. A number is known at each whole
  /// multiple of `every` at which it changed: it holds until one `every` before the next change. Of the changes in one pixel
  /// the first, the least, the greatest and the last remain, so that no peak is lost, however many there are.
  line(from, to, end, width, every) {
    const {times, values} = this;
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
      if (index > 0 && times[index] - times[index - 1] > every) add(times[index] - every, values[index - 1]);
      add(times[index], values[index]);
    }
    if (index < times.length && index > 0 && times[index - 1] <= last) {
      if (times[index] - every > times[index - 1]) add(Math.min(times[index] - every, last), values[index - 1]);
      if (times[index] - every < last) add(times[index], values[index]);
    } else if (index > 0) {
      add(last, values[index - 1]);
    }
    close();
    return points;
  }

  /// The least and the greatest number between `from` and `to`, with that at `from`; null if none is known.
  extent(from, to) {
    const {times, values} = this;
    let found = null;
    for (let index = Math.max(0, lastNotAfter(times, from)); index < times.length && times[index] <= to; ++index) {
      found = found ? [Math.min(found[0], values[index]), Math.max(found[1], values[index])] : [values[index], values[index]];
    }
    return found;
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
