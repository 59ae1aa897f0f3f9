// Cuts texts into words.
#include "name/prepared_text.hpp"

#include <algorithm>

#include "text/folding.hpp"
#include "text/utf8.hpp"

namespace symplant::name {

Separators::Separators(std::string_view characters) {
  ascii_[' '] = true;
  for (std::size_t at = 0; at < characters.size();) {
    const text::CodePoint character = text::code_point_at(characters, at);
    if (character.value < 0x80) {
      ascii_[character.value] = true;
    } else {
      others_.emplace_back(characters.substr(at, character.length));
    }
    at += character.length;
  }
}

std::size_t Separators::other_length_at(std::string_view text, std::size_t offset) const {
  for (const std::string& other : others_) {
    if (text.substr(offset).starts_with(other)) return other.size();
  }
  return 0;
}

void PreparedText::prepare(std::string_view text, const Separators& separators) {
  words_.clear();
  separator_.assign(text.size(), 0);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = separators.length_at(text, at);
    std::fill_n(separator_.begin() + static_cast<std::ptrdiff_t>(at), length, std::uint8_t{1});
    at += std::max<std::size_t>(length, 1);
  }
  std::size_t begin = 0;
  std::size_t end = text.size();
  while (begin < end && separator_[begin] != 0) ++begin;
  while (end > begin && separator_[end - 1] != 0) --end;
  shown_.assign(text.substr(begin, end - begin));
  separator_.erase(separator_.begin(), separator_.begin() + static_cast<std::ptrdiff_t>(begin));
  separator_.resize(shown_.size());
  text::fold_case(shown_, folded_);
  for (std::size_t at = 0; at < shown_.size();) {
    const std::size_t run = run_end(at);
    if (separator_[at] == 0) words_.push_back({static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(run)});
    at = run;
  }
}

std::string joined_words(const PreparedText& text, std::size_t begin, std::size_t end, char joint) {
  std::string joined;
  for (std::size_t at = begin; at < end;) {
    const std::size_t run = std::min(text.run_end(at), end);
    if (!text.is_separator(at)) {
      if (!joined.empty()) joined += joint;
      joined.append(text.shown().substr(at, run - at));
    }
    at = run;
  }
  return joined;
}

}  // namespace symplant::name
