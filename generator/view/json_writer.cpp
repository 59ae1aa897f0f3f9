// Writes a JSON document part by part.
#include "view/json_writer.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace symplant::view {
namespace {

/// Whether a character is the same inside a JSON string.
bool is_plain(char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; }

}  // namespace

void JsonWriter::key(std::string_view name) {
  separate();
  quoted(name);
  out_.add(indented_ ? ": " : ":");
  keyed_ = true;
}

void JsonWriter::value(std::string_view text) {
  separate();
  quoted(text);
}

void JsonWriter::value(double number) { literal(nlohmann::json(number).dump()); }

void JsonWriter::literal(std::string_view json) {
  separate();
  out_.add(json);
}

void JsonWriter::begin(char bracket) {
  separate();
  out_.add({&bracket, 1});
  ++depth_;
  first_ = true;
}

void JsonWriter::end(char bracket) {
  --depth_;
  if (!first_) new_line();
  out_.add({&bracket, 1});
  first_ = false;
}

void JsonWriter::separate() {
  if (!keyed_ && depth_ != 0) {
    if (!first_) out_.add(",");
    new_line();
  }
  keyed_ = false;
  first_ = false;
}

void JsonWriter::new_line() {
  if (!indented_) return;
  out_.add("\n");
  for (std::size_t level = 0; level < depth_; ++level) out_.add("  ");
}

void JsonWriter::quoted(std::string_view text) {
  if (std::all_of(text.begin(), text.end(), is_plain)) {
    out_.add("\"");
    out_.add(text);
    out_.add("\"");
  } else {
    out_.add(nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
}

}  // namespace symplant::view
