// Catches what a request makes the program throw, so that no request ends it.
#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

namespace symplant::panel {

/// Gets a message in words, without `warning:` and line end. May be called by any thread.
using PanelLog = std::function<void(const std::string& message)>;

/// Any thread may use it.
class Guard {
 public:
  /// `log` may be null.
  explicit Guard(PanelLog log) : log_(std::move(log)) {}

  /// Calls `action`; false if it threw. Then the log gets a message about `what`, at most one in 10 s; the next one has
  /// the number of those that were left out.
  template <class Action>
  bool run(std::string_view what, Action&& action) noexcept {
    try {
      action();
      return true;
    } catch (const std::exception& error) {
      note(what, error.what());
    } catch (...) {
      note(what, "an unknown error");
    }
    return false;
  }

 private:
  void note(std::string_view what, std::string_view error) noexcept;

  PanelLog log_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point next_{};  ///< when a message may be logged again
  std::uint64_t left_out_ = 0;
};

}  // namespace symplant::panel
