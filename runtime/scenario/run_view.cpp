// The state of a run for explanations.
#include "symplant/scenario/run_view.hpp"

#include <fmt/format.h>

#include <utility>

#include "symplant/tables/lists.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/influences.hpp"

namespace symplant::scenario {
namespace {

std::set<std::uint32_t> symbols_set(const Scenario& scenario) {
  std::set<std::uint32_t> symbols;
  for (const Step& step : scenario.steps) {
    for (const SymbolValue& value : step.set) symbols.insert(value.symbol);
    for (const SymbolValue& value : step.force) symbols.insert(value.symbol);
  }
  return symbols;
}

}  // namespace

RunView::RunView(const trace::PlantNames& names, const trace::History& history, tables::Time now,
                 const plant::Plant* plant, RunFacts facts)
    : RecordedView(history, now, plant), names_(names), history_(history), facts_(std::move(facts)) {
  if (facts_.scenario != nullptr) set_ = symbols_set(*facts_.scenario);
}

plant::UnitView RunView::unit(std::uint32_t unit) const {
  plant::UnitView view = RecordedView::unit(unit);
  if (!shows_malfunctions() && !trace::is_disabled_by_device(unit, names_, history_)) view.disabled = false;
  return view;
}

bool RunView::is_live(std::size_t link) const {
  return link >= facts_.links.size() || facts_.links[link] == exec::LinkState::live;
}

/// "link URL is lost", "link URL still waits for its PLC", and the malfunction that cuts it.
std::string RunView::silence_of(std::uint32_t link) const {
  const std::string by = trace::cutting_malfunctions(names_.link(link).controller, names_, malfunctions());
  return fmt::format("link {} {}{}", names_.link(link).name,
                     facts_.links[link] == exec::LinkState::lost ? "is lost" : "still waits for its PLC",
                     by.empty() ? "" : ", cut by " + by);
}

std::string RunView::unwritten(std::uint32_t operation) const {
  if (set_.contains(operation)) return {};
  if (!facts_.carried[operation]) {
    if (names_.links() != 0) return "no link carries it";
    return facts_.scenario != nullptr ? "no step of the scenario sets it" : "no link and no scenario writes it";
  }
  const std::uint32_t controller = tables::controller_of(names_.tables(), operation);
  for (std::uint32_t link = 0; link < names_.links(); ++link) {
    if (names_.link(link).controller == controller && !is_live(link)) return "its " + silence_of(link);
  }
  return {};
}

std::string RunView::violated(std::uint32_t requirement) const {
  const Violations violations = facts_.violations(requirement);
  if (violations.count == 0) return {};
  return fmt::format("was violated {} {}",
                     violations.count == 1 ? "at" : fmt::format("{} times, first at", violations.count),
                     trace::seconds(violations.first));
}

std::string RunView::standstill() const {
  if (facts_.frozen_at_panel) return "the plant is frozen at the panel";
  for (std::uint32_t link = 0; link < names_.links(); ++link) {
    if (names_.link(link).freezes && !is_live(link)) return "the plant is frozen, since " + silence_of(link);
  }
  return {};
}

}  // namespace symplant::scenario
