// Reads and applies the scores that `check --min-score` requires.
#include "app/min_score.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace symplant::app {
namespace {

/// `0.3` or `30%`, from 0 to 1.
std::optional<double> share_of(std::string_view text) {
  const bool percent = text.ends_with('%');
  if (percent) text.remove_suffix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  if (percent) value /= 100;
  if (!(value >= 0 && value <= 1)) return std::nullopt;  // also not a number
  return value;
}

}  // namespace

base::Result<MinScore, std::string> read_min_score(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  if (equals == text.npos || (name != "paired" && name != "accounted")) {
    return fmt::format("`{}` is not a score: write paired=0.3 or accounted=80%", text);
  }
  const std::optional<double> least = share_of(text.substr(equals + 1));
  if (!least) return fmt::format("`{}` is not a share: write 0 to 1, or 0% to 100%", text.substr(equals + 1));
  return MinScore{std::string(text), name == "paired", *least};
}

std::optional<std::string> failed(const MinScore& required, const score::Counts& counts) {
  const std::size_t reached = required.paired ? counts.paired() : counts.accounted();
  const std::size_t all = counts.counted();
  constexpr double kRounding = 1e-9;  // of 0.3 of 10 symbols
  const double wanted = required.least * static_cast<double>(all);
  if (all == 0 ? required.least == 0 : static_cast<double>(reached) + kRounding >= wanted) return std::nullopt;
  const double share = all == 0 ? 0 : 100.0 * static_cast<double>(reached) / static_cast<double>(all);
  const auto missing = static_cast<std::size_t>(std::ceil(wanted - kRounding)) - reached;
  return fmt::format("{} of {} BOOL I/O symbols ({:.1f} %) {}, {} fewer than `--min-score {}` requires", reached, all,
                     share, required.paired ? "are paired" : "are accounted for", missing, required.written);
}

}  // namespace symplant::app
