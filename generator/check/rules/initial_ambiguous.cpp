// SP408 initial-ambiguous: several events of a device are on at the start.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "check/rules.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kInitialAmbiguousPage =
    R"(Several events of one device have Initial TRUE, but a device starts in one state.

**What the model loses.** None of them counts: the device starts in its rest state, or otherwise in the first of its states.

**How to fix it.** Keep Initial TRUE for the one event that is on when the plant starts, or give `initial` in plant.json.
)";

/// Else it only reports, as the description says, and starts as its Initial has it.
bool is_state(const model::Unit& unit, const model::Symbol& symbol) {
  return std::any_of(unit.states.begin(), unit.states.end(), [&](const model::State& state) {
    return text::equal_ignoring_case(state.name, symbol.reading.task);
  });
}

void check_initial_ambiguous(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (evidence_of(subject, unit).initial_candidates < 2) continue;
    std::vector<diag::Related> others;
    const model::Symbol* first = nullptr;
    for (const std::uint32_t index : unit.events) {
      const model::Symbol& symbol = plant.symbols[index];
      if (symbol.initial == 0 || !is_state(unit, symbol)) continue;
      if (first == nullptr) {
        first = &symbol;
      } else {
        others.push_back({location_of(plant, *symbol.row, symbol.row->initial), "TRUE here as well"});
      }
    }
    if (first == nullptr) continue;  // never: the candidates are among the events
    diagnostics.add(
        rule.info, about(*first),
        fmt::format(
            "{} events of `{}` are TRUE at the start, so they are ignored: it starts in `{}`; keep TRUE for one",
            evidence_of(subject, unit).initial_candidates, unit.path, unit.states[unit.initial].name),
        location_of(plant, *first->row, first->row->initial), std::move(others));
  }
}

}  // namespace

const Rule kInitialAmbiguous{{"SP408", "initial-ambiguous", diag::Severity::warning,
                              "several events of a device are on at the start", kInitialAmbiguousPage},
                             check_initial_ambiguous};

}  // namespace symplant::check
