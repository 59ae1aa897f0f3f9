// Classes a run with a fault.
#include "campaign/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <set>

#include "campaign/chart.hpp"
#include "compare/words.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::campaign {
namespace {

using compare::Difference;
using tables::Time;
using trace::seconds;

/// An alarm that comes on.
struct Raised {
  Time time;
  Shown of;
};

class Judge {
 public:
  Judge(const BaseCase& base, const PlantFacts& plant, const RunLog& log, const Fault& fault, Result& result,
        std::optional<Time> goes_on)
      : base_(base), plant_(plant), names_(plant.names), log_(log), fault_(fault), result_(result), goes_on_(goes_on) {}

  void run() {
    find_seen();
    compare_operations();
    find_alarms();
    find_end();
    result_.is = classify();
    find_on();
    result_.reaction = reaction();
    if (result_.is != Class::no_effect) result_.chart = chart();
  }

 private:
  bool loses_reader() const {
    return std::any_of(base_.readers.begin(), base_.readers.end(), [&](const Reader& reader) {
      return std::find_first_of(reader.controllers.begin(), reader.controllers.end(), fault_.controllers.begin(),
                                fault_.controllers.end()) != reader.controllers.end();
    });
  }

  void find_seen() {
    seen_ = first_seen(base_, log_, names_);
    if (loses_reader() && (!seen_ || seen_->time > result_.at)) seen_ = Seen{result_.at};
    if (!seen_) return;
    result_.seen_at = seen_->time;
    if (seen_->symbol == tables::kNone) {
      result_.seen = "it reads nothing";
      return;
    }
    result_.seen = fmt::format("{} {}", names_.symbol(seen_->symbol),
                               trace::value_text(names_.tables().symbols[seen_->symbol], seen_->value));
  }

  void compare_operations() {
    actual_ = recorded(log_, names_, base_.operations, "with the fault");
    compare::Options how;
    how.window = base_.window;
    how.align = compare::Align::follow;
    comparison_ = compare::compare(base_.recorded, actual_, how);
    compare::drop_unsure(comparison_);
    std::erase_if(comparison_.differences, [](const Difference& difference) { return difference.of == nullptr; });
  }

  /// Alarms that come on and are off in the base case, by time.
  void find_alarms() {
    for (const model::Alarm& alarm : plant_.alarms) {
      if (alarm.symbol == tables::kNone) {
        raise_outputs(alarm.value);
      } else {
        raise_symbol(alarm.symbol);
      }
    }
    std::stable_sort(raised_.begin(), raised_.end(), [](const Raised& a, const Raised& b) { return a.time < b.time; });
    for (const Raised& one : raised_) {
      std::string name = name_of(one.of);
      if (std::find(result_.alarms.begin(), result_.alarms.end(), name) == result_.alarms.end())
        result_.alarms.push_back(std::move(name));
    }
    if (raised_.empty()) return;
    result_.detection = std::max<Time>(0, raised_.front().time - (seen_ ? seen_->time : result_.at));
  }

  std::string name_of(const Shown& of) const {
    return of.is_output ? names_.output(of.of) : std::string(names_.symbol(of.of));
  }

  void raise_symbol(std::uint32_t symbol) {
    const tables::SymbolRow& row = names_.tables().symbols[symbol];
    const bool is_bit = row.type() == tables::DataType::boolean;
    raise(base_.log.symbols, log_.symbols, {false, symbol},
          [&](std::uint64_t value) { return is_bit ? (value != 0) != row.inverted() : number_of(row, value) != 0; });
  }

  void raise_outputs(std::uint32_t value) {
    const tables::ValueRow& row = names_.tables().values.rows[value];
    for (std::uint32_t output = row.output; output < row.output + row.outputs; ++output) {
      raise(base_.log.outputs, log_.outputs, {true, output},
            [](std::uint64_t bits) { return std::bit_cast<double>(bits) != 0; });
    }
  }

  /// The times at which something comes on.
  template <class IsOn>
  static std::vector<Time> rises(const std::vector<Change>& changes, std::uint32_t of, IsOn is_on) {
    std::vector<Time> times;
    bool before = false;
    for (const Change& change : changes) {
      if (change.of != of) continue;
      const bool now = is_on(change.value);
      if (now && !before) times.push_back(change.time);
      before = now;
    }
    return times;
  }

  /// What comes on once more than in the base case, or earlier. One that is only late, as all is late, is not the
  /// fault's.
  template <class IsOn>
  void raise(const std::vector<Change>& expected, const std::vector<Change>& actual, const Shown& of, IsOn is_on) {
    const std::vector<Time> without = rises(expected, of.of, is_on);
    const std::vector<Time> with = rises(actual, of.of, is_on);
    for (std::size_t i = 0; i < with.size(); ++i) {
      if (i < without.size() && with[i] >= without[i] - base_.window) continue;
      return raised_.push_back({with[i], of});
    }
  }

  /// When the last operation changes, if that is too long ago.
  void find_end() {
    Time last = 0;
    for (const Change& change : log_.symbols) {
      if (base_.paced[change.of]) last = change.time;
    }
    if (log_.end - last <= base_.pause) return;
    (goes_on_ ? pauses_at_ : stopped_at_) = last;
  }

  /// The stations that differ from the base case, and that of the faulty item.
  std::set<std::uint32_t> stations_of_fault() const {
    std::set<std::uint32_t> stations;
    for (const Difference& difference : comparison_.differences) {
      stations.insert(base_.stations[base_.symbol_of.at(difference.of->name)]);
    }
    for (const std::uint32_t symbol : fault_.symbols) stations.insert(base_.stations[symbol]);
    for (const std::uint32_t unit : fault_.units) {
      for (const std::uint32_t symbol : names_.symbols_of(unit)) stations.insert(base_.stations[symbol]);
    }
    return stations;
  }

  /// The stations of the fault of which no operation changes to the end for longer than in the base case; all if the
  /// plant has stopped.
  std::set<std::uint32_t> stopped_stations() const {
    std::set<std::uint32_t> stopped;
    const std::set<std::uint32_t> of_fault = stations_of_fault();
    for (const auto& [station, last] : last_changes(log_, base_)) {
      const bool too_long = log_.end - last > base_.pauses.at(station);
      if (stopped_at_ || (too_long && of_fault.count(station) != 0)) stopped.insert(station);
    }
    return stopped;
  }

  /// The BOOL operations that command at the end, of what has stopped.
  void find_on() {
    if (comparison_.differences.empty()) {
      result_.end = "as without the fault";
      return;
    }
    const std::set<std::uint32_t> stopped = stopped_stations();
    if (stopped.empty()) {
      result_.end = "works on";
      return;
    }
    std::map<std::uint32_t, std::uint64_t> values;
    for (const Change& change : log_.symbols) {
      if (base_.operations[change.of] && stopped.count(base_.stations[change.of]) != 0) {
        values[change.of] = change.value;
      }
    }
    for (const auto& [symbol, value] : values) {
      const tables::SymbolRow& row = names_.tables().symbols[symbol];
      const bool is_on = row.type() == tables::DataType::boolean && (value != 0) != row.inverted();
      if (is_on) result_.on.emplace_back(names_.symbol(symbol));
    }
    if (result_.on.empty()) result_.end = "all off";
  }

  Class classify() {
    if (log_.violation) {
      result_.requirement = names_.requirement(log_.violation->requirement);
      result_.violated_at = log_.violation->time;
      return Class::violated;
    }
    if (!seen_) return Class::no_effect;
    if (!raised_.empty()) return Class::detected;
    if (comparison_.differences.empty()) return Class::undetected;
    return stopped_at_ ? Class::stopped : Class::other;
  }

  std::string reaction() const {
    std::string text;
    const auto add = [&](const std::string& words) { text += (text.empty() ? "" : "; ") + words; };
    if (log_.violation) {
      add(fmt::format("violates `{}` at {}", names_.requirement(log_.violation->requirement),
                      seconds(log_.violation->time)));
    }
    if (!raised_.empty())
      add(fmt::format("{} comes on at {}", name_of(raised_.front().of), seconds(raised_.front().time)));
    if (!seen_) return text.empty() ? "the program reads the same" : text;
    if (comparison_.differences.empty()) {
      add("the operations are those without the fault");
    } else if (stopped_at_) {
      add(fmt::format("no operation changes after {}", seconds(*stopped_at_)));
    } else if (pauses_at_) {
      add(fmt::format("no operation changes from {} to {}", seconds(*pauses_at_), seconds(*goes_on_)));
    }
    if (!comparison_.differences.empty()) {
      const auto by_name = compare::by_series(comparison_);
      add(fmt::format("{} in {}, first {}", compare::counted(comparison_.differences.size(), "difference"),
                      compare::counted(by_name.size(), "operation"),
                      compare::sentence(comparison_.differences.front())));
    }
    return text;
  }

  std::string chart() const {
    ChartChoice choice;
    for (const std::uint32_t symbol : fault_.symbols) choice.add({false, symbol});
    if (seen_ && seen_->symbol != tables::kNone) choice.add({false, seen_->symbol});
    for (const Raised& alarm : raised_) choice.add(alarm.of);
    for (const std::uint32_t unit : fault_.units) {
      for (const std::uint32_t symbol : names_.symbols_of(unit)) choice.add({false, symbol});
    }
    for (const Difference& difference : comparison_.differences) {
      choice.add({false, base_.symbol_of.at(difference.of->name)});
    }
    return chart_of(base_, log_, comparison_, names_, choice);
  }

  const BaseCase& base_;
  const PlantFacts& plant_;
  const trace::PlantNames& names_;
  const RunLog& log_;
  const Fault& fault_;
  Result& result_;
  std::optional<Seen> seen_;
  recording::Recording actual_;
  compare::Comparison comparison_;
  std::vector<Raised> raised_;
  const std::optional<Time> goes_on_;
  std::optional<Time> pauses_at_;   ///< when the last operation changes before a pause after which it goes on
  std::optional<Time> stopped_at_;  ///< when the last operation changes, if nothing follows for too long
};

}  // namespace

void judge(const BaseCase& base, const PlantFacts& plant, const RunLog& log, const Fault& fault, Result& result,
           std::optional<tables::Time> goes_on) {
  Judge(base, plant, log, fault, result, goes_on).run();
}

}  // namespace symplant::campaign
