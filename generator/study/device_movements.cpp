// Movements of devices: from the cause to the arrival.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "study/movement.hpp"

namespace symplant::study {
namespace {

using observe::Move;

bool is_whole(const Move& move) {
  return move.is_caused() && move.arrived != observe::kUnknown && move.from != observe::kNone &&
         move.to != observe::kNone && move.to != move.from && !move.turned && move.arrived > move.cause;
}

std::map<std::uint32_t, std::vector<const Move*>> by_unit(const std::vector<Move>& moves) {
  std::map<std::uint32_t, std::vector<const Move*>> all;
  for (const Move& move : moves) {
    if (is_whole(move)) all[move.unit].push_back(&move);
  }
  for (auto& [unit, own] : all) {
    std::stable_sort(own.begin(), own.end(), [](const Move* a, const Move* b) { return a->cause < b->cause; });
  }
  return all;
}

/// The move of the run that repeats a recorded one: to the same state, with the nearest cause, and before the next
/// cause of the recording. Null: the run does not have it.
const Move* repeated(const Move& move, Time next, const std::vector<const Move*>& actual, Time resolution) {
  const Move* nearest = nullptr;
  for (auto at = std::lower_bound(actual.begin(), actual.end(), move.cause - resolution,
                                  [](const Move*one, Time time) { return one->cause < time; });
       at != actual.end() && (*at)->cause < next; ++at) {
    if ((*at)->from != move.from || (*at)->to != move.to) continue;
    if (nearest == nullptr || std::abs((*at)->cause - move.cause) < std::abs(nearest->cause - move.cause))
      nearest = *at;
  }
  return nearest;
}

/// Both ends of a recorded duration are exact to the resolution, so that a difference up to it does not count.
double accuracy_of_time(Time recorded, Time actual, Time resolution) {
  const Time difference = std::abs(recorded - actual);
  if (difference <= resolution) return 1;
  return accuracy_of(static_cast<double>(difference), static_cast<double>(recorded));
}

}  // namespace

std::vector<Movement> movements_of(const model::PlantModel& plant, const std::vector<Move>& recorded,
                                   const std::vector<Move>& actual, Time begin, const Recorded& of) {
  const auto moves_of_run = by_unit(actual);
  std::vector<Movement> movements;
  for (const auto& [u, moves] : by_unit(recorded)) {
    const auto found = moves_of_run.find(u);
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const Move& move = *moves[i];
      if (move.cause <= begin) continue;
      const Time next = i + 1 < moves.size() ? moves[i + 1]->cause : of.end + 1;
      const Move* const run =
          found == moves_of_run.end() ? nullptr : repeated(move, next, found->second, of.resolution);
      const model::Unit& unit = plant.units[u];
      const Time duration = move.arrived - move.cause;
      if (run == nullptr && of.end - move.arrived <= duration + of.resolution) continue;  // the run may arrive later
      movements.push_back(
          {fmt::format("{} {} -> {}", unit.path, unit.states[move.from].name, unit.states[move.to].name), move.cause,
           move.arrived, run == nullptr ? 0 : accuracy_of_time(duration, run->arrived - run->cause, of.resolution)});
    }
  }
  return movements;
}

}  // namespace symplant::study
