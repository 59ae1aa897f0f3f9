// Gives names of a recording those of its symbols.
#include "recording/renamer.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "symplant/tables/nearest.hpp"

namespace symplant::recording {

std::vector<std::string> Renamer::not_found(const std::string& file, const std::vector<std::string>& names) const {
  constexpr std::size_t kMost = 10;
  const std::unordered_set<std::string_view> known(names.begin(), names.end());
  std::unordered_set<std::string_view> found;  // symbols
  std::size_t swapped = 0;
  for (const auto& [from, to] : renames_) {
    if (known.contains(from)) found.insert(to);
    if (known.contains(to)) ++swapped;
  }
  if (found.empty() && swapped != 0 && swapped >= renames_.size() - swapped) {
    return {
        fmt::format("{}: the columns of the file of renames are swapped; write the name in the recording first, "
                    "then the symbol",
                    file)};
  }
  std::vector<std::string> warnings;
  std::size_t count = 0;
  for (const auto& [from, to] : renames_) {
    if (known.contains(from) || found.contains(to) || ++count > kMost) continue;
    tables::NearestName nearest(from);
    for (const std::string& name : names) nearest.offer(name);
    warnings.push_back(fmt::format("{}: there is no `{}` to be renamed `{}`{}", file, from, to,
                                   nearest.name().empty() ? "" : fmt::format("; did you mean `{}`?", nearest.name())));
  }
  if (count > kMost)
    warnings.push_back(fmt::format("{}: {} more names to be renamed are not found", file, count - kMost));
  return warnings;
}

std::string Renamer::same_symbol(const std::vector<std::string>& names) const {
  std::unordered_map<std::string_view, std::string_view> name_of;  // by symbol
  for (const std::string& name : names) {
    const auto renamed = symbols_.find(name);
    if (renamed == symbols_.end()) continue;
    const auto [other, is_new] = name_of.emplace(renamed->second, name);
    if (is_new || other->second == name) continue;
    return fmt::format("`{}` and `{}` are both the symbol `{}`; correct the file of renames", other->second, name,
                       renamed->second);
  }
  return "";
}

std::string rename_series(const Renames& renames, Recording& recording) {
  if (renames.empty()) return "";
  const Renamer renamer(renames);
  std::vector<std::string> names;
  for (const Series& series : recording.series) {
    if (series.kind != Series::Kind::parts) names.push_back(series.name);
  }
  if (const std::string wrong = renamer.same_symbol(names); !wrong.empty()) {
    return fmt::format("{}: {}", recording.name, wrong);
  }
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
