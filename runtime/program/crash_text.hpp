// What is reported of a program that crashes or does not return.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "symplant/tables/time.hpp"

namespace symplant::program {

inline constexpr int kCrashExitCode = 3;
inline constexpr int kLongestCall = 10;  // s

/// The call that runs. A signal handler has nothing else of what it reports.
struct Call {
  const char* volatile name = nullptr;  ///< null: none
  volatile std::int64_t scan = 0;
  volatile tables::Time now = 0;
};

/// "error: program `cell` ended by SIGSEGV in scan 812 (8.12 s)\n", without a heap, for a signal handler.
class CrashText {
 public:
  CrashText(const Call& call, std::string_view what, std::string_view after = "") {
    add("error: program `");
    add(std::string_view(call.name));
    add("` ");
    add(what);
    add_call(call);
    add(after);
    add("\n");
  }
  std::string_view text() const { return {bytes_.data(), size_}; }

 private:
  void add(std::string_view text) {
    const std::size_t size = std::min(text.size(), bytes_.size() - size_);
    std::memcpy(bytes_.data() + size_, text.data(), size);
    size_ += size;
  }
  void add(std::uint64_t number) {
    std::array<char, 20> digits{};
    std::size_t at = digits.size();
    do {
      digits[--at] = static_cast<char>('0' + number % 10);
      number /= 10;
    } while (number != 0);
    add({digits.data() + at, digits.size() - at});
  }
  /// "8.12 s"
  void add_seconds(tables::Time time) {
    add(static_cast<std::uint64_t>(time / tables::kSecond));
    auto rest = static_cast<std::uint64_t>(time % tables::kSecond);
    if (rest != 0) add(".");
    for (std::uint64_t unit = tables::kSecond / 10; rest != 0; unit /= 10) {
      add(rest / unit);
      rest %= unit;
    }
    add(" s");
  }
  /// " in scan 812 (8.12 s)"
  void add_call(const Call& call) {
    if (call.scan < 0) {
      add(" at its start or end (");
    } else {
      add(" in scan ");
      add(static_cast<std::uint64_t>(call.scan));
      add(" (");
    }
    add_seconds(call.now);
    add(")");
  }

  std::array<char, 512> bytes_{};
  std::size_t size_ = 0;
};

}  // namespace symplant::program
