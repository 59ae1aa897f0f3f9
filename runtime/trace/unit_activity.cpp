// What a device is doing.
#include "symplant/trace/unit_activity.hpp"

namespace symplant::trace {
namespace {

/// What the operations of a unit that are on command.
struct Commands {
  bool here = false;       ///< the state in which it is
  bool elsewhere = false;  ///< another state
  bool possible = false;   ///< it has operations
};

Commands commands_of(const PlantNames& names, const History& history, std::uint32_t unit, std::uint8_t state) {
  const tables::TypeRow& type = names.tables().types[names.tables().units[unit].type];
  Commands commands;
  std::size_t operation = 0;
  for (const std::uint32_t symbol : names.symbols_of(unit)) {
    if (!names.is_operation(symbol)) continue;
    const std::uint8_t target = type.operation_targets[operation++];
    commands.possible = true;
    if (history.commands(symbol)) (target == state ? commands.here : commands.elsewhere) = true;
  }
  return commands;
}

}  // namespace

bool is_blocked(const PlantNames& names, const History& history, std::uint32_t unit) {
  const plant::UnitView view = history.unit(unit);
  return !runs(view) && commands_of(names, history, unit, view.state).elsewhere;
}

Activity activity_of(const PlantNames& names, const History& history, std::uint32_t unit) {
  const plant::UnitView view = history.unit(unit);
  if (view.frozen) return Activity::frozen;
  if (runs(view)) return Activity::moving;
  const Commands commands = commands_of(names, history, unit, view.state);
  if (commands.elsewhere) return Activity::blocked;
  if (view.disabled) return Activity::disabled;
  if (view.moving) return Activity::stopped;
  if (!commands.possible) return Activity::rest;
  return commands.here ? Activity::commanded : Activity::waiting;
}

}  // namespace symplant::trace
