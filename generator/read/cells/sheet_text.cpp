// The XML parts of a workbook, read in pieces that pugixml parses.
#include "read/cells/sheet_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <pugixml.hpp>
#include <unordered_map>

#include "read/cells/csv.hpp"
#include "text/utf8.hpp"

namespace symplant::read {

namespace {

constexpr std::size_t kMostPiece = 16 << 20;
constexpr std::uint32_t kMostRows = 1'048'576;
constexpr std::string_view kNotXml = "is no valid XML";
constexpr std::string_view kTooMuchText = "has more than 128 MB of text";

/// The name without its namespace.
std::string_view local(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

bool is_named(const pugi::xml_node& node, std::string_view name) { return local(node.name()) == name; }

std::string_view attribute(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    if (attribute.name() == name) return attribute.value();
  }
  return {};
}

/// A document without a type: none needs one, and its entities could make a small text large.
bool parse(pugi::xml_document& document, std::string_view xml, unsigned options) {
  return xml.find("<!DOCTYPE") == std::string_view::npos &&
         bool(document.load_buffer(xml.data(), xml.size(), options, pugi::encoding_utf8));
}

/// The offset of `<name` or `<x:name`; npos if not found.
std::size_t find_open(std::string_view text, std::string_view name) {
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find_first_of(" \t\r\n/>", at + 1);
    if (end == std::string_view::npos) return std::string_view::npos;
    if (local(text.substr(at + 1, end - at - 1)) == name && end != at + 1) return at;
  }
  return std::string_view::npos;
}

/// The end of the last `</name>` or `</x:name>`; npos if not found.
std::size_t find_last_close(std::string_view text, std::string_view name) {
  const std::string tail = std::string(name) + ">";
  for (std::size_t at = text.rfind(tail); at != std::string_view::npos && at > 0; at = text.rfind(tail, at - 1)) {
    const std::size_t open = text.rfind('<', at);
    if (open == std::string_view::npos) break;
    const std::string_view tag = text.substr(open, at + tail.size() - open);
    if (tag.starts_with("</") && local(tag.substr(2, tag.size() - 3)) == name) return at + tail.size();
  }
  return std::string_view::npos;
}

/// Parses the complete elements at the front of `rest` and removes them. Returns what is wrong.
template <class Take>
std::optional<std::string> take_elements(std::string& rest, std::string_view name, Take take) {
  const std::size_t end = find_last_close(rest, name);
  if (end == std::string_view::npos) {
    if (rest.size() <= kMostPiece) return std::nullopt;
    return fmt::format("has an element `{}` of more than 16 MiB", name);
  }
  const std::size_t begin = find_open(rest, name);
  if (begin >= end || std::string_view(rest).substr(0, begin).find("<!DOCTYPE") != std::string_view::npos) {
    return std::string(kNotXml);
  }
  pugi::xml_document document;
  constexpr unsigned kOptions =
      pugi::parse_fragment | pugi::parse_escapes | pugi::parse_ws_pcdata_single | pugi::parse_cdata;
  if (!parse(document, std::string_view(rest).substr(begin, end - begin), kOptions)) return std::string(kNotXml);
  for (const pugi::xml_node& node : document.children()) {
    if (!is_named(node, name)) continue;
    if (auto fault = take(node)) return fault;
  }
  rest.erase(0, end);
  return std::nullopt;
}

/// A text with its escapes decoded: `_x000D_` is a carriage return, `_x005F_x000D_` is `_x000D_`.
std::string unescaped(std::string text) {
  std::size_t to = 0;
  for (std::size_t at = text.find("_x"); at != std::string::npos; at = text.find("_x", to)) {
    to = at + 1;
    std::uint32_t point = 0;
    const char* const digits = text.data() + at + 2;
    if (text.size() < at + 7 || text[at + 6] != '_') continue;
    const auto [end, fault] = std::from_chars(digits, digits + 4, point, 16);
    if (fault != std::errc() || end != digits + 4 || point == 0 || (point >= 0xD800 && point < 0xE000)) continue;
    std::string character;
    text::append_utf8(character, point);
    text.replace(at, 7, character);
    to = at + character.size();
  }
  return text;
}

/// The texts of a string, in several formats or one; not their pronunciation.
std::string string_of(const pugi::xml_node& item) {
  std::string text;
  for (const pugi::xml_node& child : item.children()) {
    if (is_named(child, "t")) text += child.text().get();
    if (!is_named(child, "r")) continue;
    for (const pugi::xml_node& part : child.children()) {
      if (is_named(part, "t")) text += part.text().get();
    }
  }
  return text.find("_x") == std::string::npos ? text : unescaped(std::move(text));
}

/// "AB12" is column 27; nothing without letters.
std::optional<std::size_t> column_of(std::string_view reference) {
  std::size_t column = 0;
  std::size_t letters = 0;
  for (; letters < reference.size() && letters < 4 && reference[letters] >= 'A' && reference[letters] <= 'Z';
       ++letters) {
    column = column * 26 + static_cast<std::size_t>(reference[letters] - 'A' + 1);
  }
  return letters == 0 ? std::nullopt : std::optional(column - 1);
}

/// 1052.0999999999999 is 1052.1, as the sheet shows it.
std::string number_text(std::string_view text) {
  if (text.find_first_of(".eE") == std::string_view::npos) return std::string(text);
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() ? fmt::format("{:.15g}", value) : std::string(text);
}

}  // namespace

/// Writes the cells of one row.
class RowWriter {
 public:
  explicit RowWriter(SheetText& sheet) : sheet_(sheet) {}

  std::optional<std::string> write(const pugi::xml_node& row) {
    begin_line(attribute(row, "r"));
    std::size_t next = 0;
    std::size_t written = 0;
    for (const pugi::xml_node& cell : row.children()) {
      if (!is_named(cell, "c")) continue;
      const std::size_t column = column_of(attribute(cell, "r")).value_or(next);
      next = column + 1;
      const std::string text = text_of(cell);
      if (text.empty() || column < written || column >= kMaxCells) continue;
      sheet_.text_.append(column - written, '\t');
      written = column;
      append(text);
    }
    sheet_.text_ += '\n';
    ++sheet_.lines_;
    if (sheet_.text_.size() <= sheet_.most_) return std::nullopt;
    return std::string(kTooMuchText);
  }

 private:
  /// Blank lines up to the row's number, so that lines and rows have the same number.
  void begin_line(std::string_view number) {
    std::uint32_t row = 0;
    const auto [end, fault] = std::from_chars(number.data(), number.data() + number.size(), row);
    if (fault != std::errc() || row > kMostRows) return;
    for (; sheet_.lines_ + 1 < row; ++sheet_.lines_) sheet_.text_ += '\n';
  }

  std::string text_of(const pugi::xml_node& cell) const {
    const std::string_view type = attribute(cell, "t");
    std::string value;
    for (const pugi::xml_node& child : cell.children()) {
      if (is_named(child, "is")) return string_of(child);
      if (is_named(child, "v")) value = child.text().get();
    }
    if (type == "s") {
      std::size_t index = 0;
      const auto [end, fault] = std::from_chars(value.data(), value.data() + value.size(), index);
      return fault == std::errc() && index < sheet_.strings_.size() ? sheet_.strings_[index] : "";
    }
    if (type == "b") return value == "1" ? "TRUE" : "FALSE";
    return type.empty() || type == "n" ? number_text(value) : value;
  }

  void append(std::string_view cell) {
    const std::size_t first = cell.find_first_not_of(" \t\r\n");
    const bool quoted = first != std::string_view::npos && cell[first] == '"';
    if (quoted) sheet_.text_ += '"';
    for (const char c : cell) {
      if (quoted && c == '"') sheet_.text_ += '"';
      sheet_.text_ += c == '\t' || c == '\n' || c == '\r' ? ' ' : c;
    }
    if (quoted) sheet_.text_ += '"';
  }

  SheetText& sheet_;
};

base::Result<std::vector<SheetPart>, std::string> sheet_parts(const std::string& book, const std::string& relations) {
  pugi::xml_document books;
  pugi::xml_document links;
  if (!parse(books, book, pugi::parse_default) || !parse(links, relations, pugi::parse_default)) {
    return "the list of sheets " + std::string(kNotXml);
  }
  std::unordered_map<std::string, std::string> paths;
  for (const pugi::xml_node& link : links.document_element().children()) {
    const std::string_view target = attribute(link, "Target");
    paths[std::string(attribute(link, "Id"))] =
        target.starts_with('/') ? std::string(target.substr(1)) : "xl/" + std::string(target);
  }
  std::vector<SheetPart> parts;
  for (const pugi::xml_node& group : books.document_element().children()) {
    if (!is_named(group, "sheets")) continue;
    for (const pugi::xml_node& sheet : group.children()) {
      for (const pugi::xml_attribute& id : sheet.attributes()) {
        if (local(id.name()) != "id" || std::string_view(id.name()) == "id") continue;
        parts.push_back({std::string(attribute(sheet, "name")), paths[id.value()]});
      }
    }
  }
  return parts;
}

std::optional<std::string> SharedStrings::take_from(std::string& rest) {
  return take_elements(rest, "si", [&](const pugi::xml_node& item) {
    texts_.push_back(string_of(item));
    size_ += texts_.back().size();
    return size_ <= most_ ? std::nullopt : std::optional<std::string>(kTooMuchText);
  });
}

std::optional<std::string> SheetText::take_from(std::string& rest) {
  return take_elements(rest, "row", [&](const pugi::xml_node& row) { return RowWriter(*this).write(row); });
}

}  // namespace symplant::read
