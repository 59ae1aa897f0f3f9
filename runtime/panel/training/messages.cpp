// What the trainer writes to all browsers.
#include "symplant/panel/training/messages.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/panel/training/characters.hpp"

namespace symplant::panel {
namespace {

constexpr std::size_t kMostCharacters = 500;

}  // namespace

bool is_message(std::string_view utf8) {
  const std::optional<std::size_t> characters = characters_of(utf8, true);
  return characters && *characters <= kMostCharacters && utf8.find_first_not_of(" \n") != utf8.npos;
}

void Messages::add(tables::Time now, std::string text) {
  all_.push_back({now, std::move(text)});
  if (all_.size() <= kMost) return;
  all_.pop_front();
  ++first_;
}

void Messages::put(std::string& json, std::uint64_t from) const {
  json += '[';
  for (std::uint64_t n = std::max(from, first_); n < count(); ++n) {
    const Message& message = all_[n - first_];
    put_comma(json);
    panel::put(json, "{{\"n\":{},\"t\":{}", n, message.time);
    put_member(json, "text", message.text);
    json += '}';
  }
  json += ']';
}

}  // namespace symplant::panel
