// Wraps custom behaviors to attribute violations to them, and formats the guard's report.
#include "symplant/exec/rt_check.hpp"

#include <algorithm>
#include <tuple>

#include "symplant/tables/names.hpp"

namespace symplant::exec {
namespace {

using engine::Behaviour;
using engine::BehaviourView;

/// The wrapped behavior: the second half of behaviours() has the originals, in the order of the wrappers.
const Behaviour& own(const BehaviourView& view) noexcept {
  const std::span<const Behaviour> all = view.behaviours();
  return all[all.size() / 2 + view.behaviour()];
}

constexpr Behaviour kReporting{
    .takes =
        [](BehaviourView& view, std::uint16_t transition) noexcept {
          const DoingNow doing({"takes", view.unit()});
          return own(view).takes(view, transition);
        },
    .after =
        [](BehaviourView& view, std::uint16_t transition) noexcept {
          const DoingNow doing({"after", view.unit()});
          return own(view).after(view, transition);
        },
    .wanted =
        [](BehaviourView& view) noexcept {
          const DoingNow doing({"wanted", view.unit()});
          return own(view).wanted(view);
        },
    .entered =
        [](BehaviourView& view, std::uint8_t state) noexcept {
          const DoingNow doing({"entered", view.unit()});
          own(view).entered(view, state);
        },
    .left =
        [](BehaviourView& view, std::uint8_t state) noexcept {
          const DoingNow doing({"left", view.unit()});
          own(view).left(view, state);
        },
    .woken =
        [](BehaviourView& view) noexcept {
          const DoingNow doing({"woken", view.unit()});
          own(view).woken(view);
        },
};

Behaviour reporting(const Behaviour& behaviour) {
  Behaviour reporter = kReporting;
  reporter.memory_size = behaviour.memory_size;
  if (behaviour.takes == nullptr) reporter.takes = nullptr;
  if (behaviour.after == nullptr) reporter.after = nullptr;
  if (behaviour.wanted == nullptr) reporter.wanted = nullptr;
  if (behaviour.entered == nullptr) reporter.entered = nullptr;
  if (behaviour.left == nullptr) reporter.left = nullptr;
  if (behaviour.woken == nullptr) reporter.woken = nullptr;
  return reporter;
}

std::string whose(const Doing& doing, const tables::PlantTables& tables) {
  if (doing.function == nullptr) return "in the plant's cycle";
  const auto units = tables::split_names(tables.unit_names);
  const auto behaviours = tables::split_names(tables.behaviour_names);
  std::string text = "in `" + std::string(doing.function) + "`";
  for (const tables::BehaviourUnit& row : tables.behaviour_units) {
    if (row.unit == doing.unit) text += " of behavior `" + std::string(behaviours[row.name]) + "`";
  }
  return text + ", device " + std::string(units[doing.unit]);
}

}  // namespace

WatchedBehaviours::WatchedBehaviours(const tables::PlantTables& tables, std::span<const engine::Behaviour> behaviours) {
  if (behaviours.empty()) return;
  // One per name, so that no index of a name refers to the second half.
  std::vector<Behaviour> owns(behaviours.begin(), behaviours.end());
  owns.resize(tables::split_names(tables.behaviour_names).size());
  for (const Behaviour& behaviour : owns) all_.push_back(reporting(behaviour));
  all_.insert(all_.end(), owns.begin(), owns.end());
}

std::vector<std::string> rt_check_lines(const GuardReport& report, const tables::PlantTables& tables) {
  struct Act {
    std::string what;
    std::string whose;
    std::string caller;
    std::size_t count;
  };
  std::vector<Act> acts;
  for (const Violation& violation : report.violations) {
    Act act{act_of(violation), whose(violation.doing, tables), caller_of(violation), 1};
    const auto same = std::find_if(acts.begin(), acts.end(), [&](const Act& known) {
      return std::tie(known.what, known.whose) == std::tie(act.what, act.whose);
    });
    same == acts.end() ? acts.push_back(std::move(act)) : void(++same->count);
  }
  std::vector<std::string> lines;
  for (const Act& act : acts) {
    std::string line =
        act.what + ", " + act.whose + (act.count == 1 ? ", once" : ", " + std::to_string(act.count) + " times");
    if (!act.caller.empty()) line += " (called from " + act.caller + ")";
    lines.push_back(std::move(line));
  }
  if (report.count > report.violations.size()) {
    lines.push_back("and " + std::to_string(report.count - report.violations.size()) + " more violations");
  }
  if (!report.no_hooks.empty()) lines.push_back("heap and locks were not checked: " + report.no_hooks);
  if (!report.no_trap.empty()) lines.push_back("system calls were not checked: " + report.no_trap);
  return lines;
}

}  // namespace symplant::exec
