// Looks up malfunctions by name.
#include <array>

#include "symplant/scenario/table_names.hpp"
#include "symplant/tables/ascii.hpp"
#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::scenario {
namespace {

constexpr std::string_view kStuck = " STUCK";
constexpr std::string_view kSlow = " SLOW";
constexpr std::string_view kStuckOn = " STUCK ON";
constexpr std::string_view kStuckOff = " STUCK OFF";

/// The text before the ending; empty if it does not end so.
std::string_view before(std::string_view name, std::string_view ending) {
  return name.ends_with(ending) ? name.substr(0, name.size() - ending.size()) : std::string_view();
}

}  // namespace

std::optional<std::uint32_t> TableNames::malfunction(std::string_view name) const {
  const std::string wanted = tables::to_upper(name);
  if (const auto found = malfunctions_.find(wanted); found != malfunctions_.end()) return found->second;
  const tables::MalfunctionNumbers numbers(names_.tables());
  for (const std::string_view ending : {kStuckOn, kStuckOff}) {
    const auto found = symbol(before(wanted, ending));
    if (found && numbers.is_bool_event(found->index)) return numbers.stuck(found->index, ending == kStuckOn);
  }
  for (const std::string_view ending : {kStuck, kSlow}) {
    const auto found = unit(before(wanted, ending), {});
    if (found) return ending == kStuck ? numbers.stuck(*found) : numbers.slow(*found);
  }
  return std::nullopt;
}

/// Among the written ones; if the name ends as that of an ordinary one, also among the devices or symbols.
std::string TableNames::nearest_malfunction(std::string_view name) const {
  tables::NearestName nearest(name);
  for (const std::string_view written : tables::split_names(names_.tables().malfunctions.names)) nearest.offer(written);
  std::string found(nearest.name());
  if (!found.empty()) return found;
  const std::string wanted = tables::to_upper(name);
  for (const std::string_view ending : {kStuckOn, kStuckOff, kStuck, kSlow}) {
    const std::string_view of = before(wanted, ending);
    if (of.empty()) continue;
    const bool is_symbol = ending == kStuckOn || ending == kStuckOff;
    found = is_symbol ? nearest_symbol(of) : nearest_device(of, {});
    if (!found.empty() && malfunction(found + std::string(ending)))
      return names_.malfunction(*malfunction(found + std::string(ending)));
  }
  return {};
}

}  // namespace symplant::scenario
