// Prints the table at the end of a run.
#include "property/tally.hpp"

#include <algorithm>
#include <iomanip>
#include <string_view>
#include <utility>

namespace symplant::property {
namespace {

std::vector<std::pair<std::string_view, long>> rows_of(const RunCounts& run) {
  return {{"restores", run.restores},
          {"restores into another plant", run.restores_elsewhere},
          {"saves", run.saves},
          {"resets", run.resets},
          {"inputs set", run.inputs},
          {"inputs refused", run.inputs_refused},
          {"forces", run.forces},
          {"qualities of the link", run.qualities},
          {"further instants", run.furthers},
          {"values set", run.values},
          {"values refused", run.values_refused},
          {"malfunctions started and stopped from outside", run.malfunctions}};
}

}  // namespace

void Tally::add_plant(const DrawnPlant& drawn) {
  ++plants_;
  refused_ += drawn.refused;
  if (drawn.refused > 0 && refusals_.size() < 8) refusals_.push_back(drawn.first_refusal);
  sizes_.push_back(drawn.model.units.size());
  for (const model::Unit& unit : drawn.model.units) {
    behaviours_ += unit.described != nullptr && !unit.described->behaviour.empty() ? 1 : 0;
  }
  for (const model::Symbol& symbol : drawn.model.symbols) {
    shared_ += symbol.leader != model::kNone ? 1 : 0;
    inverted_ += symbol.inverted ? 1 : 0;
  }
  following_ += std::ssize(drawn.model.follows);
  with_material_ += drawn.model.material.empty() ? 0 : 1;
  with_malfunctions_ += drawn.model.malfunctions.empty() ? 0 : 1;
  with_values_ += drawn.model.values.empty() ? 0 : 1;
}

void Tally::print(std::ostream& out, double seconds) const {
  std::vector<std::size_t> sizes = sizes_;
  std::sort(sizes.begin(), sizes.end());
  const std::size_t median = sizes.empty() ? 0 : sizes[sizes.size() / 2];
  const std::size_t largest = sizes.empty() ? 0 : sizes.back();
  out << plants_ << " plants in " << std::fixed << std::setprecision(1) << seconds << " s, " << refused_
      << " plans refused; units: median " << median << ", largest " << largest << "; " << behaviours_
      << " with a behaviour; " << shared_ << " symbols that follow others; " << inverted_ << " inverted; " << following_
      << " that follow a condition; " << with_material_ << " plants with parts; " << with_malfunctions_
      << " with malfunctions; " << with_values_ << " with values\n";
  for (const std::string& refusal : refusals_) out << "  refused: " << refusal << "\n";
  out << run.advances << " advances over " << run.instants << " instants with an effect, " << run.cut_short
      << " cut short; " << run.too_many_rises << " runs ended early\n";
  const auto row = [&](std::string_view name, long count) {
    out << "  " << std::setw(9) << count << "  " << name << "\n";
  };
  for (std::size_t i = 0; i < reference::kCounted; ++i) row(reference::kCountedNames[i], counters.counts[i]);
  for (const auto& [name, count] : rows_of(run)) row(name, count);
}

bool Tally::missed(std::ostream& out, long minimum) const {
  bool any = false;
  const auto check = [&](std::string_view name, long count) {
    if (count >= minimum) return;
    out << "only " << count << " times: " << name << "\n";
    any = true;
  };
  for (std::size_t i = 0; i < reference::kCounted; ++i) check(reference::kCountedNames[i], counters.counts[i]);
  for (const auto& [name, count] : rows_of(run)) check(name, count);
  return any;
}

}  // namespace symplant::property
