// Replaces digits and blanks.
#include "text/shape.hpp"

#include "text/ascii.hpp"

namespace symplant::text {

std::string shape_of(std::string_view text) {
  std::string shape;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    const char as = is_digit(c) ? '#' : blank ? ' ' : c;
    const bool repeated = (as == '#' && c != '#') || blank;
    if (!repeated || shape.empty() || shape.back() != as) shape += as;
  }
  return shape;
}

}  // namespace symplant::text
