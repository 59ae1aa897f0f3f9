// Matches rows with patterns.
#include "name/io_rows.hpp"

#include "text/pattern.hpp"

namespace symplant::name {

void IoRows::add(const std::vector<std::string>& patterns, Direction direction, std::string_view pointer) {
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    const std::string at = pointer.empty() ? std::string() : std::string(pointer) + "/" + std::to_string(i);
    patterns_.push_back({patterns[i], direction, at});
  }
}

std::optional<Direction> IoRows::direction_of(std::string_view name, std::string_view vendor_address,
                                              std::string_view iec_address) {
  std::optional<Direction> found;
  for (Pattern& pattern : patterns_) {
    bool matches = false;
    for (const std::string_view text : {name, vendor_address, iec_address}) {
      matches = matches || (!text.empty() && text::matches_pattern(text, pattern.text));
    }
    if (!matches) continue;
    ++pattern.matched;
    if (found && *found != pattern.direction && pattern.also.empty()) pattern.also = name;
    if (!found) found = pattern.direction;
  }
  return found;
}

}  // namespace symplant::name
