// Devices that were divided by two spellings of their line or process.
#include "check/spelling/split_devices.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "check/spelling/device_classes.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

/// The only unit of several that has something; kSeveral where more have it.
constexpr std::uint32_t kSeveral = model::kNone - 1;

void put_unit(std::unordered_map<std::string, std::uint32_t>& units, const std::string& key, std::uint32_t unit) {
  const auto [found, added] = units.try_emplace(key, unit);
  if (!added && found->second != unit) found->second = kSeveral;
}

std::string side_key(bool operation, std::string_view task) { return (operation ? "O " : "I ") + text::to_upper(task); }

std::string joined_sides(std::vector<std::string> sides) {
  std::sort(sides.begin(), sides.end());
  std::string text;
  for (const std::string& side : sides) text += side + '\n';
  return text;
}

/// What a unit has and lacks.
struct Sides {
  std::vector<std::string> has;
  std::vector<std::string> lacks;  ///< the other side of each state that has one
  bool complete = false;           ///< a state has both
};

Sides sides_of(const model::Unit& unit) {
  Sides sides;
  for (const model::State& state : unit.states) {
    const bool operation = state.operation != model::kNone;
    const bool event = state.event != model::kNone;
    if (operation) sides.has.push_back(side_key(true, state.name));
    if (event) sides.has.push_back(side_key(false, state.name));
    if (operation != event) sides.lacks.push_back(side_key(!operation, state.name));
    sides.complete = sides.complete || (operation && event);
  }
  return sides;
}

/// Whether a state has only an operation or only an event.
bool is_one_sided(const model::Unit& unit) {
  return std::any_of(unit.states.begin(), unit.states.end(), [](const model::State& state) {
    return (state.operation != model::kNone) != (state.event != model::kNone);
  });
}

class SplitSearch {
 public:
  explicit SplitSearch(const model::PlantModel& plant) : plant_(plant), paired_(plant.units.size()) {}

  std::vector<SplitDevice> find() {
    for (const name::Level level : {name::Level::line, name::Level::process}) look_at(level);
    return std::move(found_);
  }

 private:
  const name::NameReading& reading_of(const model::Unit& unit) const {
    const auto& side = unit.operations.empty() ? unit.events : unit.operations;
    return plant_.symbols[side.front()].reading;
  }

  /// The name of a unit without a level.
  std::string rest_of_name(const model::Unit& unit, name::Level level) const {
    const name::NameReading& reading = reading_of(unit);
    return text::to_upper(level == name::Level::line ? reading.process() : reading.line()) + '\n' +
           text::to_upper(reading.device()) + '\n';
  }

  void look_at(name::Level level) {
    const std::unordered_map<std::string, std::uint32_t> wholes = wholes_of(level);
    if (wholes.empty()) return;
    std::unordered_map<std::string, std::uint32_t> parts;  // by the key of a whole
    for (std::uint32_t u = 0; u < plant_.units.size(); ++u) {
      const Sides sides = sides_of(plant_.units[u]);
      if (sides.complete) continue;
      const std::string key = rest_of_name(plant_.units[u], level) + joined_sides(sides.has);
      if (wholes.count(key) != 0) put_unit(parts, key, u);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    pairs.reserve(parts.size());
    for (const auto& [key, part] : parts) pairs.emplace_back(part, wholes.at(key));
    std::sort(pairs.begin(), pairs.end());  // the order of the map must not show
    for (const auto& [part, whole] : pairs) {
      if (part != kSeveral && whole != kSeveral) add(level, part, whole);
    }
  }

  /// By rest of the name and what they lack: units that lack several sides, and complete ones that lack any.
  std::unordered_map<std::string, std::uint32_t> wholes_of(name::Level level) const {
    std::unordered_map<std::string, std::uint32_t> wholes;
    for (std::uint32_t u = 0; u < plant_.units.size(); ++u) {
      const model::Unit& unit = plant_.units[u];
      if (!is_one_sided(unit)) continue;
      const Sides sides = sides_of(unit);
      if (sides.lacks.size() < 2 && !sides.complete) continue;
      const std::string rest = rest_of_name(unit, level);
      if (sides.lacks.size() > 1) put_unit(wholes, rest + joined_sides(sides.lacks), u);
      if (!sides.complete) continue;
      for (const std::string& side : sides.lacks) put_unit(wholes, rest + joined_sides({side}), u);
    }
    return wholes;
  }

  void add(name::Level level, std::uint32_t part, std::uint32_t whole) {
    if (part == whole || paired_[part] || paired_[whole]) return;
    if (level == name::Level::process &&
        class_name(reading_of(plant_.units[part]).process()) == class_name(reading_of(plant_.units[whole]).process())) {
      return;
    }
    paired_[part] = true;
    paired_[whole] = true;
    found_.push_back({level, part, whole});
  }

  const model::PlantModel& plant_;
  std::vector<bool> paired_;
  std::vector<SplitDevice> found_;
};

}  // namespace

std::vector<SplitDevice> split_devices(const model::PlantModel& plant) {
  std::vector<SplitDevice> found = SplitSearch(plant).find();
  for (SplitDevice& split : found) {
    // Two that complement each other are in both roles: the later one is the part.
    const bool both_one_sided = plant.units[split.whole].operations.empty() || plant.units[split.whole].events.empty();
    if (both_one_sided && split.part < split.whole) std::swap(split.part, split.whole);
  }
  std::sort(found.begin(), found.end(), [](const SplitDevice& a, const SplitDevice& b) { return a.part < b.part; });
  return found;
}

}  // namespace symplant::check
