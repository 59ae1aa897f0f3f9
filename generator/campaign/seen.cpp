// What a program reads first that differs from the base case.
#include <algorithm>
#include <limits>

#include "campaign/judge.hpp"
#include "compare/difference.hpp"

namespace symplant::campaign {
namespace {

using tables::Time;

/// The changes of a log that a program reads, as its scans see them.
class ScanCursor {
 public:
  ScanCursor(const RunLog& log, const Reader& reader) : changes_(log.symbols), reader_(reader) { skip(); }

  /// The scan that reads the next change.
  Time next() const {
    if (at_ == changes_.size()) return std::numeric_limits<Time>::max();
    return (changes_[at_].time + reader_.period - 1) / reader_.period * reader_.period;
  }
  /// Takes the changes that the scan at `time` reads.
  template <class Take>
  void take(Time time, Take take_change) {
    while (next() <= time) {
      take_change(changes_[at_]);
      ++at_;
      skip();
    }
  }

 private:
  void skip() {
    while (at_ < changes_.size() && !reader_.events[changes_[at_].of]) ++at_;
  }

  const std::vector<Change>& changes_;
  const Reader& reader_;
  std::size_t at_ = 0;
};

/// The first scan of a program that reads another value than in the base case.
std::optional<Seen> first_scan(const RunLog& base, const RunLog& log, const Reader& reader) {
  ScanCursor expected(base, reader);
  ScanCursor actual(log, reader);
  std::vector<std::uint64_t> expects(reader.events.size());
  std::vector<std::uint64_t> reads(reader.events.size());
  std::vector<std::uint32_t> touched;
  for (;;) {
    const Time scan = std::min(expected.next(), actual.next());
    if (scan > std::min(base.end, log.end)) return std::nullopt;
    touched.clear();
    const auto into = [&](std::vector<std::uint64_t>& values) {
      return [&](const Change& change) {
        values[change.of] = change.value;
        touched.push_back(change.of);
      };
    };
    expected.take(scan, into(expects));
    actual.take(scan, into(reads));
    Seen seen{scan};
    for (const std::uint32_t symbol : touched) {
      if (expects[symbol] != reads[symbol]) seen.symbol = std::min(seen.symbol, symbol);
    }
    if (seen.symbol == tables::kNone) continue;
    seen.value = reads[seen.symbol];
    return seen;
  }
}

/// The first difference of what a PLC may read at any time.
std::optional<Seen> first_difference(const BaseCase& base, const RunLog& log, const Reader& reader,
                                     const trace::PlantNames& names) {
  const recording::Recording expected = recorded(base.log, names, reader.events, "expected");
  const recording::Recording actual = recorded(log, names, reader.events, "actual");
  compare::Options how;
  how.window = base.window;
  how.align = compare::Align::follow;
  const compare::Comparison comparison = compare::compare(expected, actual, how);
  for (const compare::Difference& difference : comparison.differences) {
    if (difference.of == nullptr) continue;
    for (std::uint32_t symbol = 0; symbol < reader.events.size(); ++symbol) {
      if (!reader.events[symbol] || names.symbol(symbol) != difference.of->name) continue;
      const Time time = difference.time + (difference.kind == compare::Difference::Kind::late ? difference.by : 0);
      const auto last = std::find_if(log.symbols.rbegin(), log.symbols.rend(),
                                     [&](const Change& change) { return change.of == symbol && change.time <= time; });
      return Seen{time, symbol, last == log.symbols.rend() ? 0 : last->value};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Seen> first_seen(const BaseCase& base, const RunLog& log, const trace::PlantNames& names) {
  std::optional<Seen> first;
  for (const Reader& reader : base.readers) {
    const auto seen =
        reader.period > 0 ? first_scan(base.log, log, reader) : first_difference(base, log, reader, names);
    if (seen && (!first || seen->time < first->time)) first = seen;
  }
  return first;
}

}  // namespace symplant::campaign
