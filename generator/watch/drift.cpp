// Whether the times of moves slowly leave what was learned.
#include "watch/drift.hpp"

#include <cmath>

namespace symplant::watch {

Drift::Drift(const model::PlantModel& plant, const std::vector<Statistic>& learned, tables::Time resolution)
    // Both ends of a time are off by up to one interval: their difference is distributed as a triangle.
    : plant_(plant), rounding_(static_cast<double>(resolution) / std::sqrt(6.0)) {
  for (const Statistic& statistic : learned) {
    if (statistic.n < kLeastLearned || statistic.mean <= 0) continue;
    of_unit_[statistic.unit].push_back(series_.size());
    series_.push_back({&statistic});
  }
}

Drift::Series* Drift::series_of(const observe::Move& move, Span span) {
  const auto found = of_unit_.find(move.unit);
  if (found == of_unit_.end()) return nullptr;
  const model::Unit& unit = plant_.units[move.unit];
  const std::uint32_t on = move.transition == model::kNone ? model::kNone : unit.transitions[move.transition].on;
  Series* any = nullptr;
  for (const std::size_t index : found->second) {
    const Statistic& learned = *series_[index].learned;
    if (learned.from != move.from || learned.to != move.to || learned.span != span) continue;
    if (learned.on == on && on != model::kNone) return &series_[index];
    if (learned.on == model::kNone) any = &series_[index];
  }
  return any;
}

std::optional<Drift::Found> Drift::add(const observe::Move& move, Span span, tables::Time took) {
  Series* series = series_of(move, span);
  if (series == nullptr) return std::nullopt;
  const Statistic& learned = *series->learned;
  double& slot = series->last[series->count % kLast];
  series->sum += static_cast<double>(took) - (series->count < kLast ? 0 : slot);
  slot = static_cast<double>(took);
  if (++series->count < kLast || series->found) return std::nullopt;
  const double mean = series->sum / static_cast<double>(kLast);
  const double deviation = std::max(learned.deviation, rounding_);
  const double error = deviation * std::sqrt(1.0 / static_cast<double>(kLast) + 1.0 / static_cast<double>(learned.n));
  const double apart = std::abs(mean - learned.mean);
  if (apart <= kErrors * error || apart <= kShare * learned.mean) return std::nullopt;
  series->found = true;
  return Found{mean, &learned};
}

}  // namespace symplant::watch
