// What a description says of links to PLCs.
#include "model/links.hpp"

#include <algorithm>

namespace symplant::model {

bool is_controller_name(std::string_view name) {
  if (name.empty() || name.front() == ' ' || name.back() == ' ') return false;
  return std::none_of(name.begin(), name.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return c == '=' || c == ':' || byte < 0x20 || byte == 0x7F;
  });
}

}  // namespace symplant::model
