// The words of traces and of the panel for what starts and ends malfunctions.
#include "symplant/trace/malfunction_text.hpp"

#include <algorithm>
#include <array>

namespace symplant::trace {
namespace {

constexpr std::array<std::string_view, 6> kBy{"scenario", "hand", "condition", "chance", "becomes", "end"};

}  // namespace

std::string_view malfunction_by(engine::MalfunctionChange::By by) { return kBy[static_cast<std::size_t>(by)]; }

std::optional<engine::MalfunctionChange::By> malfunction_by_named(std::string_view word) {
  const auto* const found = std::find(kBy.begin(), kBy.end(), word);
  if (found == kBy.end()) return std::nullopt;
  return static_cast<engine::MalfunctionChange::By>(found - kBy.begin());
}

}  // namespace symplant::trace
