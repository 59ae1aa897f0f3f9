// What the user says about a shared area.
#include "read/io_words.hpp"

#include <charconv>
#include <optional>

namespace symplant::read {

namespace {

std::optional<std::uint64_t> word_number(std::string_view digits) {
  std::uint64_t number = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (fault != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return number;
}

/// "inputs=0-99", "outputs=3300".
std::optional<address::IoRanges::Range> range_of(std::string_view entry) {
  address::IoRanges::Range range;
  if (entry.starts_with("inputs=")) {
    range.area = address::Area::input;
    entry.remove_prefix(7);
  } else if (entry.starts_with("outputs=")) {
    range.area = address::Area::output;
    entry.remove_prefix(8);
  } else {
    return std::nullopt;
  }
  const std::size_t dash = entry.find('-');
  const auto first = word_number(entry.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : word_number(entry.substr(dash + 1));
  if (!first || !last || *last < *first) return std::nullopt;
  range.first = *first;
  range.last = *last;
  return range;
}

}  // namespace

base::Result<address::IoRanges, std::string> io_words_of(std::string_view text) {
  address::IoRanges words;
  for (;;) {
    const std::size_t comma = text.find(',');
    const std::string_view entry = text.substr(0, comma);
    const auto range = range_of(entry);
    if (!range) {
      return "`" + std::string(entry) +
             "` is no range of words; write it as inputs=0-99, outputs=100-199 or inputs=3300";
    }
    words.ranges.push_back(*range);
    if (comma == std::string_view::npos) return base::Result<address::IoRanges, std::string>(std::move(words));
    text.remove_prefix(comma + 1);
  }
}

}  // namespace symplant::read
