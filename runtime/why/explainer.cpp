// Finds things by name, and explains them.
#include "symplant/why/explainer.hpp"

#include <deque>

#include "symplant/condition/truth_table.hpp"
#include "symplant/tables/ascii.hpp"
#include "symplant/tables/nearest.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/why/malfunction_words.hpp"
#include "symplant/why/walk.hpp"

namespace symplant::why {
namespace {

/// Calls `use(reference, name)` for everything that has a name. The name may be gone after the call.
template <class Use>
void for_each_thing(const trace::PlantNames& names, Use use) {
  const tables::PlantTables& tables = names.tables();
  const auto all = [&](Reference::Kind kind, std::size_t count, auto name_of) {
    for (std::uint32_t i = 0; i < count; ++i) use(Reference{kind, i}, name_of(i));
  };
  using Kind = Reference::Kind;
  all(Kind::unit, tables.units.size(), [&](std::uint32_t i) { return names.unit(i); });
  all(Kind::symbol, tables.symbols.size(), [&](std::uint32_t i) { return names.symbol(i); });
  all(Kind::requirement, tables.requirements.size(), [&](std::uint32_t i) { return names.requirement(i); });
  all(Kind::location, tables.material.locations(), [&](std::uint32_t i) { return names.location(i); });
  all(Kind::transfer, tables.material.transfers.size(), [&](std::uint32_t i) { return names.transfer(i); });
  all(Kind::work, tables.material.work.size(), [&](std::uint32_t i) { return names.work(i); });
  all(Kind::source, tables.material.sources.size(), [&](std::uint32_t i) { return names.source(i); });
  all(Kind::value, tables.values.outputs, [&](std::uint32_t i) { return names.output(i); });
}

}  // namespace

std::vector<Reference> things_named(std::string_view name, const trace::PlantNames& names) {
  std::vector<Reference> found;
  const std::string facets = std::string(name) + ".";
  for_each_thing(names, [&](const Reference& thing, std::string_view other) {
    const bool is_facet = thing.kind == Reference::Kind::unit && other.size() > facets.size() &&
                          tables::equal_ignoring_case(other.substr(0, facets.size()), facets);
    if (is_facet || tables::equal_ignoring_case(other, name)) found.push_back(thing);
  });
  return found;
}

std::string nearest_thing(std::string_view name, const trace::PlantNames& names) {
  tables::NearestName nearest(name);
  std::deque<std::string> kept;  // `nearest` refers to them
  for_each_thing(names, [&](const Reference&, std::string_view other) { nearest.offer(kept.emplace_back(other)); });
  return std::string(nearest.name());
}

Explainer::Explainer(const trace::PlantNames& names, std::span<const engine::Behaviour> behaviours)
    : names_(names), behaviours_(behaviours) {}

Explainer::~Explainer() = default;

const PlantIndex& Explainer::index() const {
  std::call_once(made_, [this] { index_ = std::make_unique<const PlantIndex>(names_.tables()); });
  return *index_;
}

Explanation Explainer::why(const Reference& thing, const StateView& view) const {
  Explanation explanation = Walk(index(), names_, behaviours_, view).thing(thing);
  const std::string standstill = view.standstill();
  if (!standstill.empty()) explanation.because.insert(explanation.because.begin(), {standstill, {}, {}});
  return explanation;
}

std::vector<Explanation> Explainer::why_not(const condition::Tree& condition, const StateView& view) const {
  const Network network = condition::truth_tables(condition);
  if (holds(network, view)) return {};
  const condition::Tree changes = changes_of(network, view);
  if (changes.kind == condition::Tree::Kind::constant) return {{"it can never hold"}};
  return Walk(index(), names_, behaviours_, view).causes_of(changes);
}

Explanation Explainer::violation(std::uint32_t requirement, const StateView& view) const {
  Explanation explanation = Walk(index(), names_, behaviours_, view).violation(requirement);
  add_malfunctions(explanation, names_, view.malfunctions());
  return explanation;
}

}  // namespace symplant::why
