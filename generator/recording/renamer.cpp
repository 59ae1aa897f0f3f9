// Gives names of a recording those of its symbols.
#include "recording/renamer.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "symplant/tables/nearest.hpp"

namespace symplant::recording {

std::vector<std::string> Renamer::not_found(const std::string& file, const std::vector<std::string>& names) const {
  constexpr std::size_t kMost = 10;
  const std::unordered_set<std::string_view> known(names.begin(), names.end());
  std::vector<std::string> warnings;
  std::size_t count = 0;
  for (const auto& [from, to] : renames_) {
    if (known.contains(from) || ++count > kMost) continue;
    tables::NearestName nearest(from);
    for (const std::string& name : names) nearest.offer(name);
    warnings.push_back(fmt::format("{}: there is no `{}` to be renamed `{}`{}", file, from, to,
                                   nearest.name().empty() ? "" : fmt::format("; did you mean `{}`?", nearest.name())));
  }
  if (count > kMost)
    warnings.push_back(fmt::format("{}: {} more names to be renamed are not found", file, count - kMost));
  return warnings;
}

std::string rename_series(const Renames& renames, Recording& recording) {
  if (renames.empty()) return "";
  const Renamer renamer(renames);
  recording.index.clear();
  for (std::size_t s = 0; s < recording.series.size(); ++s) {
    Series& series = recording.series[s];
    if (series.kind != Series::Kind::parts) series.name = renamer.symbol_of(std::string(series.name));
    if (!recording.index.emplace(series.key(), s).second) {
      return fmt::format("{}: two names are the symbol `{}`; correct the file of renames", recording.name, series.name);
    }
  }
  return "";
}

}  // namespace symplant::recording
