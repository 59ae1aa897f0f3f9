// Comments and pragmas around declarations in Structured Text.
#include "read/st/surroundings.hpp"

#include <algorithm>

#include "text/ascii.hpp"

namespace symplant::read::st {

namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// The text of the attribute TcLinkTo in a pragma; empty if it has another attribute.
std::string_view link_in(std::string_view pragma) {
  constexpr std::string_view kName = "'TcLinkTo'";
  const auto found = std::search(pragma.begin(), pragma.end(), kName.begin(), kName.end(),
                                 [](char a, char b) { return text::upper(a) == text::upper(b); });
  if (found == pragma.end()) return {};
  const std::string_view rest = pragma.substr(static_cast<std::size_t>(found - pragma.begin()) + kName.size());
  const std::size_t begin = rest.find('\'');
  if (begin == std::string_view::npos) return {};
  return rest.substr(begin + 1, rest.find('\'', begin + 1) - begin - 1);
}

/// Whether a line ends with `;`, perhaps with a comment after it.
bool is_code(std::string_view comment) {
  for (std::size_t mark = comment.find(';'); mark != std::string_view::npos; mark = comment.find(';', mark + 1)) {
    const std::size_t next = std::min(comment.find_first_not_of(" \t", mark + 1), comment.size());
    const std::string_view rest = comment.substr(next, 2);
    if (rest.empty() || is_line_end(rest.front()) || rest == "//" || rest == "(*") return true;
    mark = next - 1;
  }
  return false;
}

}  // namespace

std::string_view comment_text(std::string_view comment) {
  if (comment.size() >= 4 && (comment.ends_with("*)") || comment.ends_with("*/"))) comment.remove_suffix(2);
  comment.remove_prefix(2);
  const auto is_frame = [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == '*' || c == '/'; };
  while (!comment.empty() && is_frame(comment.front())) comment.remove_prefix(1);
  while (!comment.empty() && is_frame(comment.back())) comment.remove_suffix(1);
  return comment;
}

void Surroundings::begin(std::size_t offset) {
  last_end_ = offset;
  on_line_ = true;
  above_ = {};
  link_ = {};
}

bool Surroundings::pass(const Token& token) {
  const std::size_t breaks = line_breaks(last_end_, token.begin);
  if (breaks != 0) on_line_ = false;
  if (breaks > 1) above_ = {};
  last_end_ = token.end;
  return on_line_;
}

void Surroundings::take_above(std::string_view comment) { above_ = is_code(comment) ? std::string_view() : comment; }

void Surroundings::take_link(std::string_view pragma) {
  if (const std::string_view link = link_in(pragma); !link.empty()) link_ = link;
}

/// 0, 1, or 2 for more than one.
std::size_t Surroundings::line_breaks(std::size_t begin, std::size_t end) const {
  std::size_t breaks = 0;
  for (std::size_t i = begin; i < end && breaks < 2; ++i) {
    const bool is_second_of_pair = text_[i] == '\n' && i > 0 && text_[i - 1] == '\r';
    if (is_line_end(text_[i]) && !is_second_of_pair) ++breaks;
  }
  return breaks;
}

}  // namespace symplant::read::st
