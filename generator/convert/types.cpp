// Types and initial values as IEC 61131-3 and TIA Portal write them.
#include "convert/types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "model/classify.hpp"
#include "text/ascii.hpp"

namespace symplant::convert {
namespace {

using tables::DataType;

/// Elementary types that symplant does not serve.
struct OtherType {
  std::string_view written;
  std::string_view iec;
};
constexpr std::array kOtherTypes{
    OtherType{"TIME", "TIME"},   OtherType{"LTIME", "LTIME"},      OtherType{"DATE", "DATE"},
    OtherType{"TOD", "TOD"},     OtherType{"LTOD", "LTOD"},        OtherType{"TIME_OF_DAY", "TOD"},
    OtherType{"DT", "DT"},       OtherType{"DATE_AND_TIME", "DT"}, OtherType{"CHAR", "CHAR"},
    OtherType{"WCHAR", "WCHAR"}, OtherType{"STRING", "STRING"},    OtherType{"WSTRING", "WSTRING"}};

struct TiaName {
  std::string_view iec;
  std::string_view tia;
};
constexpr std::array kTiaTypes{
    TiaName{"BOOL", "Bool"},       TiaName{"BYTE", "Byte"},        TiaName{"WORD", "Word"},   TiaName{"DWORD", "DWord"},
    TiaName{"LWORD", "LWord"},     TiaName{"SINT", "SInt"},        TiaName{"USINT", "USInt"}, TiaName{"INT", "Int"},
    TiaName{"UINT", "UInt"},       TiaName{"DINT", "DInt"},        TiaName{"UDINT", "UDInt"}, TiaName{"LINT", "LInt"},
    TiaName{"ULINT", "ULInt"},     TiaName{"REAL", "Real"},        TiaName{"LREAL", "LReal"}, TiaName{"TIME", "Time"},
    TiaName{"LTIME", "LTime"},     TiaName{"DATE", "Date"},        TiaName{"CHAR", "Char"},   TiaName{"WCHAR", "WChar"},
    TiaName{"TOD", "Time_Of_Day"}, TiaName{"LTOD", "LTime_Of_Day"}};

constexpr std::size_t kLongestType = 200;

bool is_letter(char c) { return text::upper(c) >= 'A' && text::upper(c) <= 'Z'; }

bool holds_only(std::string_view text, std::string_view others) {
  return std::all_of(text.begin(), text.end(),
                     [&](char c) { return is_letter(c) || text::is_digit(c) || others.find(c) != others.npos; });
}

std::string_view trimmed_type(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// A type that is not an array.
std::optional<std::string> simple_type(std::string_view text) {
  if (const auto type = model::data_type(text)) return std::string(model::data_type_name(*type));
  for (const OtherType& type : kOtherTypes) {
    if (text::equal_ignoring_case(type.written, text)) return std::string(type.iec);
  }
  const std::string_view length = string_length(text);
  if (length.empty()) return std::nullopt;
  const char first = text::upper(text.front());
  return fmt::format("{}[{}]", first == 'W' ? "WSTRING" : "STRING", length);
}

std::string type_of_size(address::Size size) {
  switch (size) {
    case address::Size::byte:
      return "BYTE";
    case address::Size::word:
      return "WORD";
    case address::Size::dword:
      return "DWORD";
    case address::Size::lword:
      return "LWORD";
    case address::Size::bit:
      break;
  }
  return "BOOL";
}

/// 3.14, 1.0e+20: IEC 61131-3 wants digits on both sides of the point.
std::string real_literal(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find('.') != text.npos) return text;
  text.insert(std::min(text.find('e'), text.size()), ".0");
  return text;
}

std::string integer_literal(std::string_view text) {
  const char first = text::upper(text.front());
  if (first == 'K') return std::string(text.substr(1));
  if (first == 'H') return "16#" + std::string(text.substr(1));
  return std::string(text);
}

std::optional<std::string> number_literal(std::string_view initial, DataType type) {
  const auto value = model::initial_value(initial, type);
  if (!value) return std::nullopt;
  if (type == DataType::boolean) return *value != 0 ? "TRUE" : "FALSE";
  if (type == DataType::real || type == DataType::lreal) return real_literal(std::bit_cast<double>(*value));
  return integer_literal(initial);
}

bool is_quoted(std::string_view text, char quote) {
  return text.size() >= 2 && text.front() == quote && text.back() == quote &&
         std::all_of(text.begin() + 1, text.end() - 1,
                     [&](char c) { return c != quote && c != '$' && static_cast<unsigned char>(c) >= 0x20; });
}

}  // namespace

std::optional<ArrayType> array_type(std::string_view type) {
  const std::size_t open = type.find('[');
  const std::size_t close = type.find(']');
  if (type.size() > kLongestType || open == type.npos || close == type.npos || close < open) return std::nullopt;
  const std::string_view rest = trimmed_type(type.substr(close + 1));
  if (!text::equal_ignoring_case(trimmed_type(type.substr(0, open)), "ARRAY")) return std::nullopt;
  if (rest.size() < 4 || !text::equal_ignoring_case(rest.substr(0, 3), "OF ")) return std::nullopt;
  const std::string_view bounds = type.substr(open + 1, close - open - 1);
  const auto is_bound = [](char c) { return text::is_digit(c) || c == '.' || c == ',' || c == '-' || c == ' '; };
  if (bounds.empty() || !std::all_of(bounds.begin(), bounds.end(), is_bound)) return std::nullopt;
  return ArrayType{bounds, trimmed_type(rest.substr(3))};
}

std::string_view string_length(std::string_view type) {
  const std::size_t open = type.find_first_of("[(");
  if (open == type.npos || type.size() > kLongestType || (type.back() != ']' && type.back() != ')')) return {};
  const std::string_view name = trimmed_type(type.substr(0, open));
  if (!text::equal_ignoring_case(name, "STRING") && !text::equal_ignoring_case(name, "WSTRING")) return {};
  const std::string_view length = trimmed_type(type.substr(open + 1, type.size() - open - 2));
  return std::all_of(length.begin(), length.end(), text::is_digit) ? length : std::string_view();
}

std::optional<std::string> iec_type(const Symbol& symbol) {
  const std::string_view text = symbol.row->type;
  if (text.empty()) {
    if (symbol.address) return type_of_size(symbol.address->size);
    if (symbol.kind == Kind::input || symbol.kind == Kind::output) return "BOOL";
    return std::nullopt;
  }
  if (auto type = simple_type(text)) return type;
  const auto array = array_type(text);
  if (!array) return std::nullopt;
  const auto element = simple_type(array->element);
  if (!element) return std::nullopt;
  return fmt::format("ARRAY [{}] OF {}", array->bounds, *element);
}

std::optional<std::string> tia_type(const Symbol& symbol) {
  if (const auto type = iec_type(symbol)) {
    for (const TiaName& name : kTiaTypes) {
      if (name.iec == *type) return std::string(name.tia);
    }
  }
  const read::ListRow& row = *symbol.row;
  const bool is_tag = symbol.notation == address::Notation::siemens && row.vendor_address.starts_with('%');
  return is_tag && !row.type.empty() ? std::optional(std::string(row.type)) : std::nullopt;
}

std::optional<std::string> iec_literal(std::string_view initial, std::string_view iec_type) {
  if (initial.empty()) return "";
  if (const auto type = model::data_type(iec_type)) return number_literal(initial, *type);
  if (iec_type.starts_with("STRING") || iec_type.starts_with("WSTRING") || iec_type.ends_with("CHAR")) {
    const char quote = iec_type.starts_with('W') ? '"' : '\'';
    return is_quoted(initial, quote) ? std::optional(std::string(initial)) : std::nullopt;
  }
  if (iec_type.starts_with("ARRAY")) {
    const bool is_list = initial.front() == '[' && initial.back() == ']' && holds_only(initial, "_#+-.,()[] ");
    return is_list ? std::optional(std::string(initial)) : std::nullopt;
  }
  const bool is_time = is_letter(initial.front()) && initial.find('#') != initial.npos && holds_only(initial, "_#+-.:");
  return is_time ? std::optional(std::string(initial)) : std::nullopt;
}

}  // namespace symplant::convert
