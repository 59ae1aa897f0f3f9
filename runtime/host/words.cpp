// Short texts shared by the messages of a run.
#include "symplant/host/words.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

namespace symplant::host {

std::string plural(std::size_t count, std::string_view word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

const char* state_name(exec::LinkState state) {
  if (state == exec::LinkState::waiting) return "waiting";
  return state == exec::LinkState::live ? "live" : "lost";
}

std::string shown(std::string_view name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto byte = static_cast<unsigned char>(name[i]);
    const std::string_view three = name.substr(i, 3);
    const bool changes_direction = three.starts_with("\xE2\x80") || three.starts_with("\xE2\x81");
    if (changes_direction && three.size() == 3) {
      text += '?';
      i += 2;
    } else {
      text += byte < 0x20 || byte == 0x7F ? '?' : name[i];
    }
  }
  return text;
}

std::string today() { return fmt::format("{:%Y-%m-%d}", fmt::localtime(std::time(nullptr))); }

}  // namespace symplant::host
