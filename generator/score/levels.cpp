// Sums verdicts by list, line, station or device.
#include "score/levels.hpp"

#include "base/index_table.hpp"
#include "text/ascii.hpp"

namespace symplant::score {
namespace {

/// What a level of a symbol's name says; empty views where the level has none.
Part part_of(const model::Symbol& symbol, Level level) {
  const model::SymbolReading& reading = symbol.reading;
  Part part;
  if (level == Level::list) {
    part.list = symbol.list;
    return part;
  }
  part.line = reading.line();
  if (level != Level::line) part.process = reading.process();
  if (level == Level::device) part.device = reading.device();
  return part;
}

std::uint64_t hash_of(const Part& part) {
  constexpr std::uint64_t kFactor = 31;
  const std::uint64_t station = text::hash_ignoring_case(part.line) * kFactor + text::hash_ignoring_case(part.process);
  return station * kFactor + text::hash_ignoring_case(part.device);
}

bool same(const Part& a, const Part& b) {
  return text::equal_ignoring_case(a.line, b.line) && text::equal_ignoring_case(a.process, b.process) &&
         text::equal_ignoring_case(a.device, b.device);
}

}  // namespace

std::string Part::path() const {
  std::string path;
  for (const std::string_view level : {line, process, device}) {
    if (!path.empty() && !level.empty()) path += '_';
    path += level;
  }
  return path;
}

std::vector<Part> parts_of(const model::PlantModel& plant, const PlantScore& score, Level level) {
  std::vector<Part> parts;
  if (level == Level::list) {
    for (std::uint32_t list = 0; list < plant.lists.size(); ++list) parts.push_back({list});
  }
  base::IndexTable table;
  for (std::size_t i = 0; i < plant.symbols.size(); ++i) {
    if (!name::is_counted(score.accounts[i])) continue;
    Part part = part_of(plant.symbols[i], level);
    std::uint32_t index = part.list;
    if (level != Level::list) {
      const auto next = static_cast<std::uint32_t>(parts.size());
      index = table.find_or_add(hash_of(part), next, [&](std::uint32_t other) { return same(parts[other], part); });
      if (index == next) parts.push_back(part);
    }
    parts[index].counts.add(score.accounts[i]);
  }
  return parts;
}

}  // namespace symplant::score
