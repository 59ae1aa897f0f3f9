// What the rules about names share.
#include "check/rules.hpp"

#include <map>

#include "base/ascii.hpp"

namespace symplant::check {

void narrow(diag::Place& place, const model::Symbol& symbol) {
  const base::Span part = symbol.reading.where;
  if (place.span.end - place.span.begin != symbol.name().size()) return;  // the whole row, or an unescaped cell
  place.span = {place.span.begin + part.begin, place.span.begin + part.end};
}

std::string_view faulty_part(const model::Symbol& symbol) {
  const base::Span part = symbol.reading.where;
  return symbol.name().substr(part.begin, part.end - part.begin);
}

std::string_view consequence(const model::Symbol& symbol) {
  return symbol.direction == core::Direction::event ? "nothing moves it" : "it moves nothing";
}

namespace {

bool overruled(const model::Symbol& symbol) {
  if (!symbol.address || symbol.reading.fault != name::NameFault::none) return false;
  return (symbol.reading.direction == name::Direction::operation) != (symbol.direction == core::Direction::operation);
}

std::string task_key(std::string_view path, std::string_view task, bool operation) {
  return base::to_upper(path) + (operation ? " O " : " I ") + base::to_upper(task);
}

}  // namespace

std::vector<TaskClaim> task_claims(const model::PlantModel& plant) {
  std::map<std::string, std::uint32_t> dropped;
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const model::Symbol& symbol = plant.symbols[i];
    if (symbol.unmodelled != model::Unmodelled::task_taken) continue;
    dropped.emplace(
        task_key(symbol.reading.device_path, symbol.reading.task, symbol.direction == core::Direction::operation), i);
  }
  std::vector<TaskClaim> claims;
  if (dropped.empty()) return claims;
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const model::Symbol& symbol = plant.symbols[i];
    if (symbol.reading.fault != name::NameFault::none || symbol.unmodelled == model::Unmodelled::task_taken) continue;
    if (symbol.type != core::DataType::boolean) continue;
    const auto found = dropped.find(
        task_key(symbol.reading.device_path, symbol.reading.task, symbol.direction == core::Direction::operation));
    if (found == dropped.end()) continue;
    if (overruled(symbol)) {
      claims.push_back({i, found->second, true});
    } else {
      claims.push_back({found->second, i, false});
    }
  }
  return claims;
}

OverruledNames::OverruledNames(const model::PlantModel& plant) {
  for (const model::Symbol& symbol : plant.symbols) {
    if (!overruled(symbol)) continue;
    names_.insert(task_key(symbol.reading.device_path, symbol.reading.task,
                           symbol.reading.direction == name::Direction::operation));
  }
}

bool OverruledNames::has(const model::Unit& unit, const model::State& state, name::Direction direction) const {
  return !names_.empty() && names_.count(task_key(unit.path, state.name, direction == name::Direction::operation)) != 0;
}

}  // namespace symplant::check
