// Commands to devices, in closed loop or wild.
#include "property/recordings/random_commands.hpp"

#include <algorithm>

#include "property/random_plant.hpp"
#include "property/recordings/timed_plant.hpp"

namespace symplant::property {
namespace {

using tables::kMillisecond;
using tables::kNone;
using tables::kSecond;

/// Events that are on in a state to which an operation leads.
std::vector<std::uint32_t> shown_by(const model::Unit& unit, std::uint32_t operation) {
  std::vector<std::uint32_t> events;
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    const model::State& state = unit.states[s];
    const bool leads = state.operation == operation ||
                       std::any_of(unit.transitions.begin(), unit.transitions.end(),
                                   [&](const model::Transition& t) { return t.on == operation && t.to == s; });
    if (leads && state.event != kNone) events.push_back(unit.events[state.event]);
  }
  return events;
}

}  // namespace

RandomCommands::RandomCommands(std::uint64_t seed, const model::PlantModel& plant, const tables::PlantTables& tables,
                               Commands kind)
    : dice_(seed * 2 + 0xC033'A2D5), plant_(plant), tables_(tables), kind_(kind) {
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    if (plant.units[u].operations.empty()) continue;
    Commanded of;
    of.unit = u;
    of.timeout = longest_move(plant.units[u]) * 5 / 4 + kSecond;
    of.until = of.timeout + within(kSecond);  // what moves at the start has arrived
    units_.push_back(of);
  }
  for (std::uint32_t s = 0; s < plant.symbols.size(); ++s) {
    if (plant.symbols[s].direction != tables::Direction::operation) continue;
    (plant.symbols[s].type == tables::DataType::boolean ? bits_ : numbers_).push_back(s);
  }
}

void RandomCommands::scan(plant::Plant& plant, tables::Time now) {
  if (!numbers_.empty() && now >= next_number_) {
    const std::uint32_t symbol = dice_.pick(numbers_);
    plant.set_operation_value(tables_.symbols[symbol].index, random_content(dice_, plant_.symbols[symbol].type));
    next_number_ = now + 20 * kSecond + within(20 * kSecond);
  }
  if (kind_ == Commands::wild) return scan_wild(plant);
  for (Commanded& of : units_) {
    if (of.clear_at >= 0 && now >= of.clear_at) {
      clear(plant, of);
      of.clear_at = -1;
    }
    if (of.waits) {
      const bool arrived =
          now >= of.until - of.timeout + 50 * kMillisecond &&
          std::any_of(of.shows.begin(), of.shows.end(), [&](std::uint32_t event) { return is_on(plant, event); });
      if (!arrived && now < of.until) continue;
      of.waits = false;
      if (dice_.percent(50)) of.clear_at = now + within(300 * kMillisecond);
      of.until = now + 400 * kMillisecond + within(2 * kSecond);
    } else if (now >= of.until) {
      command(plant, of, now);
    }
  }
}

void RandomCommands::command(plant::Plant& plant, Commanded& of, tables::Time now) {
  const model::Unit& unit = plant_.units[of.unit];
  of.clear_at = -1;
  of.waits = true;
  of.until = now + of.timeout;
  clear(plant, of);
  const bool rests = unit.actuation == tables::Actuation::spring && of.operation != kNone && dice_.percent(60);
  if (rests) {
    of.operation = kNone;
    of.shows.clear();
    if (unit.rest != kNone && unit.states[unit.rest].event != kNone) {
      of.shows.push_back(unit.events[unit.states[unit.rest].event]);
    }
    return;
  }
  of.operation = static_cast<std::uint32_t>(dice_.below(unit.operations.size()));
  of.shows = shown_by(unit, of.operation);
  write(plant, unit.operations[of.operation], true);
}

void RandomCommands::clear(plant::Plant& plant, const Commanded& of) {
  for (const std::uint32_t symbol : plant_.units[of.unit].operations) write(plant, symbol, false);
}

void RandomCommands::scan_wild(plant::Plant& plant) {
  if (bits_.empty() || !dice_.percent(6)) return;
  for (std::size_t i = 1 + dice_.below(2); i > 0; --i) {
    const std::uint32_t symbol = dice_.pick(bits_);
    write(plant, symbol, dice_.percent(50));
  }
}

void RandomCommands::write(plant::Plant& plant, std::uint32_t symbol, bool on) {
  plant.set_operation(tables_.symbols[symbol].index, on != plant_.symbols[symbol].inverted);
}

bool RandomCommands::is_on(const plant::Plant& plant, std::uint32_t symbol) const {
  return plant.event(tables_.symbols[symbol].index) != plant_.symbols[symbol].inverted;
}

}  // namespace symplant::property
