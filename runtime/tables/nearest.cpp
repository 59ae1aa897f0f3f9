// The edit distance of two names: insertions, deletions, substitutions, and exchanges of adjacent letters.
#include "symplant/tables/nearest.hpp"

#include <algorithm>
#include <array>

#include "symplant/tables/ascii.hpp"

namespace symplant::tables {
namespace {

constexpr std::size_t kLongest = 200;  ///< bytes; longer names are not compared

/// The distance if it is below `limit`, else any number >= `limit`.
std::size_t distance(std::string_view a, std::string_view b, std::size_t limit) {
  std::array<std::array<std::size_t, kLongest + 1>, 3> rows{};
  for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto& row = rows[i % 3];
    const auto& above = rows[(i + 2) % 3];
    const auto& twice_above = rows[(i + 1) % 3];
    row[0] = i;
    std::size_t least = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = upper(a[i - 1]) == upper(b[j - 1]) ? 0 : 1;
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + change});
      if (i > 1 && j > 1 && upper(a[i - 1]) == upper(b[j - 2]) && upper(a[i - 2]) == upper(b[j - 1])) {
        row[j] = std::min(row[j], twice_above[j - 2] + 1);
      }
      least = std::min(least, row[j]);
    }
    if (least > limit) return least;  // not at `limit` itself: an exchange can still lower it
  }
  return rows[a.size() % 3][b.size()];
}

}  // namespace

NearestName::NearestName(std::string_view wanted)
    : wanted_(wanted), distance_(std::max<std::size_t>(wanted.size() / 3, 1) + 1) {}

void NearestName::offer(std::string_view name) {
  if (name.size() > kLongest || wanted_.size() > kLongest) return;
  const std::size_t lengths = std::max(name.size(), wanted_.size()) - std::min(name.size(), wanted_.size());
  if (lengths >= distance_) return;
  const std::size_t found = distance(wanted_, name, distance_);
  if (found >= distance_) return;
  distance_ = found;
  name_ = name;
}

}  // namespace symplant::tables
