// The name that a client of the panel gives.
#include "symplant/panel/training/sender_name.hpp"

#include "symplant/panel/training/characters.hpp"
#include "symplant/panel/web/header_text.hpp"
#include "symplant/panel/web/percent.hpp"

namespace symplant::panel {
namespace {

constexpr std::size_t kMostNameBytes = 64;

}  // namespace

bool read_sender_name(std::string_view header, std::string& name) {
  std::string decoded;
  if (!decode_percent(header, false, decoded)) return false;
  name = trimmed(decoded);
  if (name.empty()) return header.empty();
  return name.size() <= kMostNameBytes && characters_of(name, false).has_value();
}

}  // namespace symplant::panel
