// Normal form and case folding, by utf8proc.
#include "text/folding.hpp"

#include <utf8proc.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::text {
namespace {

bool is_ascii(std::string_view text) {
  return std::none_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
}

}  // namespace

std::string normal_form(std::string_view text) {
  if (is_ascii(text)) return std::string(text);
  utf8proc_uint8_t* mapped = nullptr;
  const auto size =
      utf8proc_map(reinterpret_cast<const utf8proc_uint8_t*>(text.data()), static_cast<utf8proc_ssize_t>(text.size()),
                   &mapped, static_cast<utf8proc_option_t>(UTF8PROC_STABLE | UTF8PROC_COMPOSE));
  const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> owner(mapped, &std::free);
  if (size < 0) return std::string(text);  // not UTF-8: compared byte by byte
  return {reinterpret_cast<const char*>(mapped), static_cast<std::size_t>(size)};
}

void fold_case(std::string_view text, std::string& folded) {
  folded.resize(text.size());
  std::size_t at = 0;
  for (; at < text.size() && static_cast<unsigned char>(text[at]) < 0x80; ++at) folded[at] = lower(text[at]);
  if (at == text.size()) return;
  folded.resize(at);
  while (at < text.size()) {
    const CodePoint character = code_point_at(text, at);
    const std::size_t before = folded.size();
    if (character.valid) {
      append_utf8(folded, static_cast<char32_t>(utf8proc_tolower(static_cast<utf8proc_int32_t>(character.value))));
    }
    if (folded.size() - before != character.length) {
      folded.resize(before);
      folded.append(text.substr(at, character.length));
    }
    at += character.length;
  }
}

std::string folded(std::string_view text) {
  std::string result;
  fold_case(text, result);
  return result;
}

int column_width(char32_t character) { return utf8proc_charwidth(static_cast<utf8proc_int32_t>(character)); }

}  // namespace symplant::text
