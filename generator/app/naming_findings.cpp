// Findings about the parts of a naming rule.
#include "app/naming_findings.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "naming/rules/naming_contradiction.hpp"
#include "naming/rules/naming_matches_nothing.hpp"
#include "symplant/tables/nearest.hpp"
#include "text/ascii.hpp"

namespace symplant::app {
namespace {

using pairing::Remark;

/// Each location takes a pass over the text of the links. The others are shown when these are fixed.
constexpr std::size_t kMostShown = 200;

/// The name in the link that the remark is about.
const std::string& name_of(const name::NamedLink& link, const Remark& remark, const model::PlantModel& plant) {
  const auto is = [&](const std::string& name) {
    return text::equal_ignoring_case(plant.symbols[remark.input].name(), name);
  };
  if (remark.kind == Remark::Kind::link_unknown) return remark.other == 0 ? link.event : link.operation;
  return is(link.event) ? link.event : link.operation;
}

std::string unknown(const std::string& name, const model::PlantModel& plant) {
  for (const model::Symbol& symbol : plant.symbols) {
    if (text::equal_ignoring_case(symbol.name(), name)) {
      return fmt::format("`{}` is a number; only BOOL symbols lead to states and report them", name);
    }
  }
  tables::NearestName nearest(name);
  for (const model::Symbol& symbol : plant.symbols) nearest.offer(symbol.name());
  return fmt::format(
      "`{}` is not an I/O symbol of the plant{}", name,
      nearest.name().empty() ? std::string("; correct the name") : fmt::format("; did you mean `{}`?", nearest.name()));
}

std::string message(const Remark& remark, const model::PlantModel& plant) {
  const std::vector<name::NamedLink>& links = plant.naming().links;
  const name::NamedLink& link = links[remark.link];
  const std::string& name = name_of(link, remark, plant);
  if (remark.kind == Remark::Kind::link_unknown) return unknown(name, plant);
  if (remark.kind == Remark::Kind::link_repeated) {
    return fmt::format("an earlier link gives `{}` another state or device (`{}`); remove one of them", name,
                       links[remark.other].state);
  }
  const bool operation = plant.symbols[remark.input].direction == tables::Direction::operation;
  return fmt::format("`{}` is an {}, but the link names it as the {}; exchange the two, or correct the name", name,
                     operation ? "operation" : "event", operation ? "event" : "operation");
}

void add_link_findings(const model::PlantModel& plant, const naming::LoadedNaming& parts,
                       diag::Diagnostics& diagnostics) {
  std::size_t shown = 0;
  if (plant.pairing == nullptr) return;
  for (const Remark& remark : plant.pairing->remarks) {
    if (remark.kind == Remark::Kind::role_taken || remark.kind == Remark::Kind::path_ambiguous) continue;
    if (++shown > kMostShown) return;
    std::vector<diag::Related> related;
    if (remark.kind == Remark::Kind::link_repeated) {
      related.push_back({parts.link_location(remark.other), "the earlier link"});
    }
    diagnostics.add(naming::kNamingContradiction, message(remark, plant), parts.link_location(remark.link),
                    std::move(related));
  }
}

/// Rules that read no symbol, and archetypes without a device.
void add_unmatched(const model::PlantModel& plant, const naming::LoadedNaming& parts, diag::Diagnostics& diagnostics) {
  if (parts.shown.starts_with('@')) return;
  const std::vector<std::size_t>& matched = plant.reader->matched();
  for (std::size_t i = 0; i < matched.size(); ++i) {
    if (matched[i] != 0) continue;
    diagnostics.add(
        naming::kNamingMatchesNothing,
        "this rule reads no symbol; correct its pattern, move it before the rule that takes its symbols, or "
        "remove it",
        parts.location(fmt::format("/rules/{}", i)));
  }
  if (plant.pairing == nullptr) return;
  const std::vector<name::Archetype>& archetypes = plant.naming().archetypes;
  std::vector<bool> found(archetypes.size());
  for (const pairing::Facet& facet : plant.pairing->facets) {
    if (facet.by == pairing::FacetBy::archetype) found[facet.archetype] = true;
  }
  for (std::size_t i = 0; i < archetypes.size(); ++i) {
    if (found[i] || archetypes[i].model == name::ArchetypeModel::constant) continue;
    diagnostics.add(naming::kNamingMatchesNothing,
                    fmt::format("no device has texts for the roles of `{}`; correct them, or remove the archetype",
                                archetypes[i].name),
                    parts.location(fmt::format("/archetypes/{}", i)));
  }
}

}  // namespace

void add_naming_findings(const model::PlantModel& plant, const naming::LoadedNaming& parts,
                         diag::Diagnostics& diagnostics) {
  add_link_findings(plant, parts, diagnostics);
  add_unmatched(plant, parts, diagnostics);
}

}  // namespace symplant::app
