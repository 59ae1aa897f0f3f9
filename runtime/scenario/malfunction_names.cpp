// Looks up malfunctions by name.
#include "symplant/tables/malfunction_names.hpp"

#include "symplant/scenario/table_names.hpp"
#include "symplant/tables/ascii.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::scenario {
std::optional<std::uint32_t> TableNames::malfunction(std::string_view name) const {
  const std::string wanted = tables::to_upper(name);
  if (const auto found = malfunctions_.find(wanted); found != malfunctions_.end()) return found->second;
  const auto symbol_of = [this](std::string_view of) -> std::optional<std::uint32_t> {
    const auto found = symbol(of);
    return found ? std::optional(found->index) : std::nullopt;
  };
  return tables::ordinary_malfunction(tables::MalfunctionNumbers(names_.tables()), wanted, symbol_of,
                                      [this](std::string_view of) { return unit(of, {}); });
}

/// Among the written ones; if the name ends as that of an ordinary one, also among the devices or symbols.
std::string TableNames::nearest_malfunction(std::string_view name) const {
  tables::NearestName nearest(name);
  for (const std::string_view written : tables::split_names(names_.tables().malfunctions.names)) nearest.offer(written);
  std::string found(nearest.name());
  if (!found.empty()) return found;
  const std::string wanted = tables::to_upper(name);
  for (const tables::OrdinaryMalfunction& ordinary : tables::kOrdinaryMalfunctions) {
    const std::string_view of = tables::before_ending(wanted, ordinary);
    if (of.empty()) continue;
    found = ordinary.of_symbol ? nearest_symbol(of) : nearest_device(of, {});
    if (found.empty()) continue;
    if (const auto number = malfunction(found + std::string(ordinary.ending))) return names_.malfunction(*number);
  }
  return {};
}

}  // namespace symplant::scenario
