// A text of the user with the lines in it.
#include "text/source_file.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "base/words.hpp"
#include "text/utf8.hpp"

namespace symplant::text {

namespace {

std::vector<std::size_t> find_line_begins(std::string_view text) {
  std::vector<std::size_t> begins{0};
  for (std::size_t at = base::find_any(text, 0, '\n', '\r', '\n'); at < text.size();
       at = base::find_any(text, at, '\n', '\r', '\n')) {
    at += text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n' ? 2U : 1U;
    begins.push_back(at);
  }
  return begins;
}

}  // namespace

SourceFile::SourceFile(std::string path, std::string text, Counted columns)
    : path_(std::move(path)), text_(std::move(text)), columns_(columns) {}

const std::vector<std::size_t>& SourceFile::line_begins() const {
  std::call_once(lines_known_, [&] { line_begins_ = find_line_begins(text_); });
  return line_begins_;
}

Position SourceFile::position(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const std::vector<std::size_t>& begins = line_begins();
  const auto after = std::upper_bound(begins.begin(), begins.end(), offset);
  const std::size_t begin = *(after - 1);
  const auto line = static_cast<std::size_t>(after - begins.begin());
  if (columns_ == Counted::cells) {
    const std::string_view before = text().substr(begin, offset - begin);
    return {line, 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\t'))};
  }
  // An offset within a character is in the column of that character.
  while (offset > begin && offset < text_.size() && is_continuation(text_[offset])) --offset;
  return {line, 1 + count_code_points(text().substr(begin, offset - begin))};
}

std::string_view SourceFile::line_at(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const std::vector<std::size_t>& begins = line_begins();
  const auto after = std::upper_bound(begins.begin(), begins.end(), offset);
  const std::size_t begin = *(after - 1);
  std::string_view line = text();
  line = line.substr(begin, (after == begins.end() ? text_.size() : *after) - begin);
  if (line.ends_with('\n')) line.remove_suffix(1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

Span SourceFile::span_of(std::string_view view, Span fallback) const {
  const char* const begin = text_.data();
  const char* const end = begin + text_.size();
  // Only std::less orders pointers into different objects.
  const std::less<const char*> before;
  const char* const last = view.data() + view.size();
  if (view.data() == nullptr || before(view.data(), begin) || before(end, last)) return fallback;
  const auto offset = static_cast<std::size_t>(view.data() - begin);
  return {offset, offset + view.size()};
}

}  // namespace symplant::text
