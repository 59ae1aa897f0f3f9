// The state of a run for explanations: its records, and what only the run knows: links, scenario, panel.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "symplant/exec/exchange.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/why/recorded_view.hpp"

namespace symplant::scenario {

/// How often a requirement was violated, and when first.
struct Violations {
  std::uint64_t count = 0;
  tables::Time first = 0;
};

/// What a run knows in addition to its records.
struct RunFacts {
  std::vector<exec::LinkState> links = {};  ///< as PlantNames::link() counts them; a missing one counts as live
  const std::vector<bool>& carried;         ///< by symbol: whether a link carries it
  const Scenario* scenario = nullptr;       ///< the scenario that is played; null: none
  bool frozen_at_panel = false;
  bool shows_malfunctions = true;  ///< as StateView::shows_malfunctions()
  std::function<Violations(std::uint32_t requirement)> violations;
};

/// Explanations are the same wherever they are asked for, at the end of a run or on its panel, if both pass the same
/// facts. All that the arguments refer to must outlive it.
class RunView final : public why::RecordedView {
 public:
  /// `names` has the links of the run; for the others see RecordedView.
  RunView(const trace::PlantNames& names, const trace::History& history, tables::Time now, const plant::Plant* plant,
          RunFacts facts);

  bool shows_malfunctions() const override { return facts_.shows_malfunctions; }
  plant::UnitView unit(std::uint32_t unit) const override;
  std::string unwritten(std::uint32_t operation) const override;
  std::string violated(std::uint32_t requirement) const override;
  std::string standstill() const override;

 private:
  bool is_live(std::size_t link) const;
  std::string silence_of(std::uint32_t link) const;

  const trace::PlantNames& names_;
  const trace::History& history_;
  const RunFacts facts_;
  std::set<std::uint32_t> set_;  ///< the symbols that the scenario sets or forces
};

}  // namespace symplant::scenario
