// Finds the malfunction that a run starts.
#include "symplant/host/fault_start.hpp"

#include <fmt/format.h>

#include "symplant/host/words.hpp"
#include "symplant/scenario/table_names.hpp"

namespace symplant::host {

std::optional<std::uint32_t> fault_of(const std::string& name, const trace::PlantNames& names, std::ostream& err) {
  const scenario::TableNames by_name(names);
  const auto number = by_name.malfunction(name);
  if (number) return number;
  const std::string nearest = by_name.nearest_malfunction(name);
  err << fmt::format("error: `--fault`: malfunction `{}` not found{}\n", shown(name),
                     nearest.empty() ? "" : fmt::format("; did you mean `{}`?", shown(nearest)));
  return std::nullopt;
}

}  // namespace symplant::host
