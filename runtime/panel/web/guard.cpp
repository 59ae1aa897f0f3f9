// Catches what a request makes the program throw.
#include "symplant/panel/web/guard.hpp"

#include <fmt/format.h>

namespace symplant::panel {
namespace {

constexpr auto kPause = std::chrono::seconds(10);
constexpr std::size_t kLongestNamed = 100;

/// A text of a client, for a terminal.
std::string printable(std::string_view text) {
  std::string shown(text.substr(0, kLongestNamed));
  for (char& c : shown) {
    if (c < ' ' || c > '~') c = '?';
  }
  return shown.size() < text.size() ? shown + "..." : shown;
}

}  // namespace

void Guard::note(std::string_view what, std::string_view error) noexcept try {
  const auto now = std::chrono::steady_clock::now();
  std::uint64_t left_out = 0;
  {
    const std::lock_guard guard(mutex_);
    if (now < next_) {
      ++left_out_;
      return;
    }
    next_ = now + kPause;
    left_out = std::exchange(left_out_, 0);
  }
  if (!log_) return;
  const std::string more = left_out == 0 ? "" : fmt::format(" ({} more since the last message)", left_out);
  log_(fmt::format("panel: `{}` failed by an error of symplant: {}{}; the run goes on, please report this",
                   printable(what), printable(error), more));
} catch (...) {  // a message is lost, the run goes on
}

}  // namespace symplant::panel
