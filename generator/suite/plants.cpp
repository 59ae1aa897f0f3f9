// Makes faster and slower plants.
#include "suite/plants.hpp"

#include <algorithm>
#include <map>

namespace symplant::suite {
namespace {

using tables::Time;

class Scaling {
 public:
  Scaling(lower::EngineTables& tables, Speed speed) : tables_(tables), fast_(speed == Speed::fast) {}

  void scale(std::vector<tables::TransitionTimes>& times) {
    for (tables::TransitionTimes& one : times) one.takes = one.takes < 0 ? drawn(one.takes) : scaled(one.takes);
  }

 private:
  Time scaled(Time time) const {
    constexpr Time kMost = tables::kNever / 4;
    if (fast_) return time == 0 ? 0 : std::max<Time>(1, time / 5);
    return time > kMost ? time : 3 * time;
  }

  /// The reference to a random time that is scaled; the one that is there may be that of a delay, too.
  Time drawn(Time reference) {
    const auto [at, is_new] = drawn_.try_emplace(reference, 0);
    if (!is_new) return at->second;
    tables::RandomTime time = tables_.random_times[static_cast<std::size_t>(-1 - reference)];
    const bool computed = time.kind == tables::RandomTime::Kind::seconds;
    time.a = computed ? scaled_formula(static_cast<std::uint32_t>(time.a)) : scaled(time.a);
    time.b = scaled(time.b);
    tables_.random_times.push_back(time);
    return at->second = -static_cast<Time>(tables_.random_times.size());
  }

  /// A formula that reads the same inputs, and whose result is scaled.
  std::uint32_t scaled_formula(std::uint32_t formula) {
    lower::Values& values = tables_.values;
    tables::FormulaRow row = values.formulas[formula];
    const std::vector<tables::FormulaStep> steps(values.steps.begin() + row.steps.first,
                                                 values.steps.begin() + row.steps.first + row.steps.count);
    row.steps = {static_cast<std::uint32_t>(values.steps.size()), row.steps.count + 2};
    values.steps.insert(values.steps.end(), steps.begin(), steps.end());
    values.steps.push_back({tables::FormulaOp::number, 0, fast_ ? 0.2 : 3});
    values.steps.push_back({tables::FormulaOp::multiply, 0, 0});
    values.formulas.push_back(row);
    values.formula_texts.push_back('\0');
    return static_cast<std::uint32_t>(values.formulas.size() - 1);
  }

  lower::EngineTables& tables_;
  const bool fast_;
  std::map<Time, Time> drawn_;
};

}  // namespace

lower::EngineTables at_speed(const lower::EngineTables& tables, Speed speed) {
  lower::EngineTables copy = tables.copy();
  if (speed == Speed::normal) return copy;
  Scaling scaling(copy, speed);
  for (lower::Type& type : copy.types) scaling.scale(type.times);
  scaling.scale(copy.times);
  return copy;
}

}  // namespace symplant::suite
