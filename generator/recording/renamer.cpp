// Gives names of a recording those of its symbols.
#include "recording/renamer.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "symplant/tables/nearest.hpp"

namespace symplant::recording {

std::vector<std::string> not_found(const Renames& renames, const std::string& file,
                                   const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 10;
  const std::unordered_set<std::string_view> known(names.begin(), names.end());
  std::unordered_set<std::string_view> found;  // symbols
  std::size_t swapped = 0;
  for (const auto& [from, to] : renames) {
    if (known.contains(from)) found.insert(to);
    if (known.contains(to)) ++swapped;
  }
  if (found.empty() && swapped != 0 && swapped >= renames.size() - swapped) {
    return {
        fmt::format("{}: the columns of the file of renames are swapped; write the name in the recording first, "
                    "then the symbol",
                    file)};
  }
  std::vector<std::string> warnings;
  std::size_t count = 0;
  for (const auto& [from, to] : renames) {
    if (known.contains(from) || found.contains(to) || ++count > kMost) continue;
    tables::NearestName nearest(from);
    for (const std::string& name : names) nearest.offer(name);
    warnings.push_back(fmt::format("{}: `{}` is not in the recordings{}", file, from,
                                   nearest.name().empty() ? "" : fmt::format("; did you mean `{}`?", nearest.name())));
  }
  if (count > kMost)
    warnings.push_back(fmt::format("{}: {} more names are not in the recordings", file, count - kMost));
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
    if (series.kind != Series::Kind::parts) {
      const std::string name = series.name;
      series.name = renamer.symbol_of(name);
      // A program of the header may write it, whatever its names are.
      const bool is_written = series.is_operation && !is_operation_name(name);
      series.is_operation = is_written || is_operation_name(series.name);
    }
    if (!recording.index.emplace(series.key(), s).second) {
      return fmt::format("{}: two names are the symbol `{}`; correct the file of renames", recording.name, series.name);
    }
  }
  order_operations(recording);
  return "";
}

}  // namespace symplant::recording
