// Patterns of the paths of devices.
#include "learn/patterns.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <string_view>

#include "text/ascii.hpp"
#include "text/pattern.hpp"

namespace symplant::learn {
namespace {

using model::kNone;

std::vector<std::string_view> segments_of(std::string_view path) {
  std::vector<std::string_view> segments;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('_', begin), path.size());
    segments.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return segments;
}

/// How many characters two texts have in common at the beginning, without a part of a character.
std::size_t common_prefix(std::string_view a, std::string_view b) {
  std::size_t length = 0;
  while (length < std::min(a.size(), b.size()) && text::upper(a[length]) == text::upper(b[length])) ++length;
  while (length > 0 && length < a.size() && (static_cast<unsigned char>(a[length]) & 0xC0U) == 0x80U) --length;
  return length;
}

/// A pattern that matches all of some segments, which differ.
std::string generalized(const std::vector<std::string_view>& segments) {
  std::size_t prefix = segments.front().size();
  for (const std::string_view segment : segments) prefix = std::min(prefix, common_prefix(segments.front(), segment));
  const bool one_each = std::all_of(segments.begin(), segments.end(), [&](std::string_view segment) {
    return segment.size() == prefix + 1 && (static_cast<unsigned char>(segment.back()) & 0x80U) == 0;
  });
  return std::string(segments.front().substr(0, prefix)) + (one_each ? '?' : '*');
}

/// All units by path, to find those that a pattern matches.
class Paths {
 public:
  explicit Paths(const model::PlantModel& plant) : plant_(plant) {
    paths_.reserve(plant.units.size());
    for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
      paths_.emplace_back(text::to_upper(plant.units[u].path), u);
    }
    std::sort(paths_.begin(), paths_.end());
  }

  std::vector<std::uint32_t> matched(const std::string& pattern) const {
    const std::string prefix = text::to_upper(pattern.substr(0, pattern.find_first_of("*?")));
    auto at = std::lower_bound(paths_.begin(), paths_.end(), std::pair(prefix, std::uint32_t{0}));
    std::vector<std::uint32_t> units;
    for (; at != paths_.end() && at->first.starts_with(prefix); ++at) {
      const model::Unit& unit = plant_.units[at->second];
      if (text::matches_pattern(unit.path, pattern) || text::matches_pattern(unit.device_path(), pattern)) {
        units.push_back(at->second);
      }
    }
    return units;
  }

 private:
  const model::PlantModel& plant_;
  std::vector<std::pair<std::string, std::uint32_t>> paths_;
};

class Namer {
 public:
  Namer(const model::PlantModel& plant, std::vector<NamedGroup>& groups)
      : plant_(plant),
        groups_(groups),
        paths_(plant),
        group_of_(plant.units.size(), kNone),
        is_named_(plant.units.size(), false),
        is_matched_(plant.units.size(), false) {
    for (std::uint32_t g = 0; g < groups.size(); ++g) {
      for (const std::uint32_t unit : groups[g].units) group_of_[unit] = g;
    }
  }

  void run() {
    std::vector<std::uint32_t> order(groups_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return groups_[a].units.size() > groups_[b].units.size();
    });
    for (const std::uint32_t g : order) {
      name(g, groups_[g].units);
      std::sort(groups_[g].names.begin(), groups_[g].names.end(),
                [](const DevicesName& a, const DevicesName& b) { return a.name < b.name; });
    }
  }

 private:
  /// Some devices of a group: by one pattern, else divided where their paths first differ.
  void name(std::uint32_t g, const std::vector<std::uint32_t>& units) {
    if (units.size() == 1) {
      groups_[g].names.push_back({std::string(plant_.units[units.front()].path), units});
      is_named_[units.front()] = true;
      return;
    }
    std::size_t differs = 0;
    const std::string pattern = pattern_of(units, differs);
    if (!pattern.empty() && may_take(g, units.size(), pattern)) {
      for (const std::uint32_t unit : paths_.matched(pattern)) is_matched_[unit] = true;
      for (const std::uint32_t unit : units) is_named_[unit] = true;
      groups_[g].names.push_back({pattern, units});
      return;
    }
    std::map<std::string, std::vector<std::uint32_t>> parts;
    for (const std::uint32_t unit : units) {
      const auto segments = segments_of(plant_.units[unit].path);
      const std::string part = pattern.empty() ? std::to_string(segments.size()) : text::to_upper(segments[differs]);
      parts[part].push_back(unit);
    }
    for (const auto& [part, some] : parts) name(g, some);
  }

  /// Empty if the paths have different numbers of segments. `differs`: the first segment that differs.
  std::string pattern_of(const std::vector<std::uint32_t>& units, std::size_t& differs) const {
    std::vector<std::vector<std::string_view>> paths;
    paths.reserve(units.size());
    for (const std::uint32_t unit : units) paths.push_back(segments_of(plant_.units[unit].path));
    const std::size_t count = paths.front().size();
    if (std::any_of(paths.begin(), paths.end(), [&](const auto& path) { return path.size() != count; })) return {};
    differs = count;
    std::string pattern;
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<std::string_view> segments;
      segments.reserve(paths.size());
      for (const auto& path : paths) segments.push_back(path[i]);
      const bool equal = std::all_of(segments.begin(), segments.end(), [&](std::string_view segment) {
        return text::equal_ignoring_case(segment, segments.front());
      });
      if (!equal) differs = std::min(differs, i);
      pattern += (i == 0 ? "" : "_") + (equal ? std::string(segments.front()) : generalized(segments));
    }
    return pattern;
  }

  /// Whether a pattern for `count` devices of a group may be used: each other device that it matches gets an exact name
  /// with the same keys later, and they are fewer.
  bool may_take(std::uint32_t g, std::size_t count, const std::string& pattern) const {
    std::size_t others = 0;
    for (const std::uint32_t unit : paths_.matched(pattern)) {
      if (is_matched_[unit]) return false;
      if (group_of_[unit] == g) continue;
      if (group_of_[unit] == kNone || is_named_[unit] || groups_[group_of_[unit]].keys != groups_[g].keys) return false;
      ++others;
    }
    return others < count;
  }

  const model::PlantModel& plant_;
  std::vector<NamedGroup>& groups_;
  const Paths paths_;
  std::vector<std::uint32_t> group_of_;  ///< by unit
  std::vector<bool> is_named_;           ///< by unit: it has a name or a pattern
  std::vector<bool> is_matched_;         ///< by unit: a pattern matches it
};

}  // namespace

void name_groups(const model::PlantModel& plant, std::vector<NamedGroup>& groups) { Namer(plant, groups).run(); }

}  // namespace symplant::learn
