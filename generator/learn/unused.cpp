// Compares the moves without a cause with those of a plant whose operations have the other polarity.
#include "learn/unused.hpp"

#include <algorithm>
#include <cstddef>
#include <set>

namespace symplant::learn {
namespace {

constexpr std::size_t kLeastUnused = 3;  ///< fewer may be moves by hand
constexpr std::size_t kManyShare = 4;    ///< a quarter of the moves

bool are_many(const UnusedMoves& of) { return of.unused() >= kLeastUnused && kManyShare * of.unused() >= of.all(); }

bool has_recorded_operation(const model::Unit& unit, const std::vector<Input>& inputs) {
  return std::any_of(unit.operations.begin(), unit.operations.end(), [&](std::uint32_t symbol) {
    return std::any_of(inputs.begin(), inputs.end(),
                       [&](const Input& input) { return input.matched.recorded[symbol]; });
  });
}

/// The moves of a plant in which the operations of these units mean the opposite.
Moves moves_if_inverted(const model::PlantModel& plant, const std::vector<Input>& inputs,
                        const std::vector<UnusedMoves>& devices) {
  std::set<std::uint32_t> operations;
  for (const UnusedMoves& of : devices) {
    const model::Unit& unit = plant.units[of.unit];
    if (are_many(of)) operations.insert(unit.operations.begin(), unit.operations.end());
  }
  model::PlantModel other = plant;
  for (const std::uint32_t symbol : operations) other.symbols[symbol].inverted = !other.symbols[symbol].inverted;
  return moves_of(other, inputs);
}

UnusedReason reason_of(const UnusedMoves& of, const UnusedMoves& inverted, bool recorded) {
  if (2 * inverted.unused() <= of.unused() && inverted.used > of.used) return UnusedReason::inverted;
  if (2 * of.uncaused < of.all()) return UnusedReason::few;
  return recorded ? UnusedReason::unknown : UnusedReason::not_recorded;
}

}  // namespace

std::vector<UnusedMoves> unused_moves(const model::PlantModel& plant, const std::vector<Input>& inputs,
                                      const Moves& moves) {
  std::vector<UnusedMoves> devices;
  for (const UnusedMoves& of : moves.unused_of) {
    if (of.unused() > 0) devices.push_back(of);
  }
  if (std::none_of(devices.begin(), devices.end(), are_many)) return devices;
  const Moves inverted = moves_if_inverted(plant, inputs, devices);
  for (UnusedMoves& of : devices) {
    const model::Unit& unit = plant.units[of.unit];
    if (!are_many(of) || unit.operations.empty()) continue;
    of.reason = reason_of(of, inverted.unused_of[of.unit], has_recorded_operation(unit, inputs));
  }
  return devices;
}

}  // namespace symplant::learn
