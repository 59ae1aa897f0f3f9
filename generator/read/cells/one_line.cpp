// Cells of formats whose texts may have line ends.
#include "read/cells/one_line.hpp"

#include <algorithm>
#include <string>

#include "text/utf8.hpp"

namespace symplant::read {

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7F'; }
bool is_blank_or_control(char c) { return c == ' ' || is_control(c); }

/// The text without blanks around it, with each run of blanks that has a control character as one blank.
std::string collapsed(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    if (is_blank_or_control(text[at])) {
      std::size_t end = at;
      while (end < text.size() && is_blank_or_control(text[end])) ++end;
      const std::string_view run = text.substr(at, end - at);
      const bool breaks = std::any_of(run.begin(), run.end(), is_control);
      result.append(breaks ? " " : run);
      at = end;
      continue;
    }
    const text::CodePoint point = text::code_point_at(text, at);
    text::append_utf8(result, point.value);
    at += point.length;
  }
  return result;
}

}  // namespace

std::string_view one_line(TableBuilder& builder, std::size_t offset, std::string_view text) {
  std::size_t begin = 0;
  while (begin < text.size() && is_blank_or_control(text[begin])) ++begin;
  while (text.size() > begin && is_blank_or_control(text.back())) text.remove_suffix(1);
  text.remove_prefix(begin);
  if (text.empty()) return {};
  if (offset < builder.text().size()) offset += begin;
  const bool in_file = offset < builder.text().size() && builder.text().substr(offset, text.size()) == text;
  if (in_file && std::none_of(text.begin(), text.end(), is_control)) return builder.text().substr(offset, text.size());
  return builder.keep(collapsed(text));
}

}  // namespace symplant::read
