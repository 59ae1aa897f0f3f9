// The runs of a campaign.
#include "campaign/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "symplant/trace/value_text.hpp"

namespace symplant::campaign {
namespace {

using tables::Time;

/// The changes of each symbol or device, by time.
using ChangesOf = std::vector<std::vector<const Change*>>;

ChangesOf by_subject(const std::vector<Change>& changes, std::size_t count) {
  ChangesOf of(count);
  for (const Change& change : changes) of[change.of].push_back(&change);
  return of;
}

class Planner {
 public:
  Planner(const BaseCase& base, const trace::PlantNames& names)
      : names_(names),
        case_end_(base.case_end),
        malfunctions_(base.log.malfunctions),
        symbols_(by_subject(base.log.symbols, names.tables().symbols.size())),
        units_(by_subject(base.log.units, names.tables().units.size())) {}

  void add(const Fault& fault, std::size_t number, Phases phases, std::vector<Planned>& planned) const {
    if (fault.begins != tables::kNone) return add_begin(fault, number, planned);
    planned.push_back({number, 0, "from the start", is_needed(fault, 0)});
    if (phases == Phases::start) return;
    std::map<Time, std::string> times;
    for (const std::uint32_t symbol : fault.symbols) {
      for (const Change* const change : symbols_[symbol]) times.try_emplace(change->time, words_of_symbol(*change));
    }
    for (const std::uint32_t unit : fault.units) add_moves(unit, times);
    times.erase(0);
    times.erase(times.upper_bound(case_end_), times.end());
    for (const auto& [time, words] : times) planned.push_back({number, time, words, is_needed(fault, time)});
  }

 private:
  /// When its condition begins to hold in the base case; never: it needs no run.
  void add_begin(const Fault& fault, std::size_t number, std::vector<Planned>& planned) const {
    const auto begin = std::find_if(malfunctions_.begin(), malfunctions_.end(), [&](const Change& change) {
      return change.of == fault.begins && change.value != 0;
    });
    if (begin == malfunctions_.end()) {
      planned.push_back({number, 0, "its condition never holds in the base case", false});
    } else {
      planned.push_back({number, begin->time, "when its condition holds", true});
    }
  }

  std::string words_of_symbol(const Change& change) const {
    const tables::SymbolRow& row = names_.tables().symbols[change.of];
    const std::string value = trace::value_text(row, change.value);
    return fmt::format("just before {} {} {}", names_.symbol(change.of),
                       row.type() == tables::DataType::boolean ? "goes" : "becomes", value);
  }

  void add_moves(std::uint32_t unit, std::map<Time, std::string>& times) const {
    for (const Change* const change : units_[unit]) {
      const plant::UnitView view = trace::unpack_unit(change->value);
      const auto state = [&](std::uint8_t number) { return names_.state(unit, number); };
      times.try_emplace(change->time,
                        view.moving ? fmt::format("just before {} leaves {}", names_.unit(unit), state(view.state))
                                    : fmt::format("just before {} reaches {}", names_.unit(unit), state(view.state)));
    }
  }

  /// Whether a run with the fault can differ from the base case.
  bool is_needed(const Fault& fault, Time at) const {
    switch (fault.mode) {
      case Fault::Mode::stuck_on:
      case Fault::Mode::stuck_off:
        return !shows_only(fault.symbols.front(), at, fault.mode == Fault::Mode::stuck_on);
      case Fault::Mode::held:
        return !is_still(symbols_[fault.symbols.front()], at);
      case Fault::Mode::stuck:
      case Fault::Mode::slow:
        return fault.units.empty() || !is_still(units_[fault.units.front()], at);
      default:
        return true;
    }
  }

  static bool is_still(const std::vector<const Change*>& changes, Time at) {
    return changes.empty() || changes.back()->time < at;
  }

  /// Whether a bit has a value from just before `at` on; at time 0 from its first instant on.
  bool shows_only(std::uint32_t symbol, Time at, bool on) const {
    const std::vector<const Change*>& changes = symbols_[symbol];
    bool value = false;
    std::size_t at_start = 0;
    for (const Change* const change : changes) {
      if (change->time > at || (change->time == at && at > 0)) return false;
      at_start += change->time == 0 ? 1U : 0U;
      value = change->value != 0;
    }
    return value == on && at_start < 2;  // a pulse at the start is a change, too
  }

  const trace::PlantNames& names_;
  const Time case_end_;
  const std::vector<Change>& malfunctions_;
  const ChangesOf symbols_;
  const ChangesOf units_;
};

}  // namespace

std::vector<Planned> plan(const std::vector<Fault>& faults, Phases phases, const BaseCase& base,
                          const trace::PlantNames& names) {
  const Planner planner(base, names);
  std::vector<Planned> planned;
  for (std::size_t i = 0; i < faults.size(); ++i) planner.add(faults[i], i, phases, planned);
  return planned;
}

}  // namespace symplant::campaign
