// Replaces names in braces within texts.
#include "text/braces.hpp"

namespace symplant::text {

Replaced replace_braces(std::string_view text, const BraceNames& names) {
  Replaced replaced;
  for (;;) {
    const std::size_t open = text.find('{');
    replaced.text += text.substr(0, open);
    if (open == text.npos) return replaced;
    const std::size_t close = text.find('}', open);
    const std::string_view whole = text.substr(open, close == text.npos ? text.npos : close + 1 - open);
    const auto value = close == text.npos ? std::nullopt : names(whole.substr(1, whole.size() - 2));
    if (!value) {
      replaced.unknown = whole;
      return replaced;
    }
    replaced.text += *value;
    text.remove_prefix(close + 1);
  }
}

}  // namespace symplant::text
