// Builds JSON texts piece by piece.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

#include "symplant/trace/value_text.hpp"

namespace symplant::trace {

/// Appends to a text, in the form of fmt::format.
template <class... Values>
void put(std::string& json, fmt::format_string<Values...> form, Values&&... values) {
  fmt::format_to(std::back_inserter(json), form, std::forward<Values>(values)...);
}

/// Appends `,` unless the text ends with the beginning of an array or object.
inline void put_comma(std::string& json) {
  if (!json.empty() && json.back() != '[' && json.back() != '{') json += ',';
}

/// Appends `"key":`, with a comma before it if one is due.
inline void put_key(std::string& json, std::string_view key) {
  put_comma(json);
  json += '"';
  json += key;
  json += "\":";
}

inline void put_text(std::string& json, std::string_view text) { json += json_string(text); }

/// `"key":"text"`
inline void put_member(std::string& json, std::string_view key, std::string_view text) {
  put_key(json, key);
  put_text(json, text);
}

/// `"key":[1,2,3]`
inline void put_indexes(std::string& json, std::string_view key, std::span<const std::uint32_t> indexes) {
  put_key(json, key);
  json += '[';
  for (const std::uint32_t index : indexes) {
    put_comma(json);
    put(json, "{}", index);
  }
  json += ']';
}

/// The text of an index, or `null` for `none`.
inline std::string index_or_null(std::uint32_t index, std::uint32_t none) {
  return index == none ? "null" : std::to_string(index);
}

}  // namespace symplant::trace
