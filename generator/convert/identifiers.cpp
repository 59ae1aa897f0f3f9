// Names that a target accepts.
#include "convert/identifiers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::convert {
namespace {

/// Sorted. Keywords, elementary types, standard functions and function blocks: a compiler takes none of them as a name.
constexpr auto kReserved = std::to_array<std::string_view>({
    "ABS",
    "ABSTRACT",
    "ACOS",
    "ACTION",
    "ADD",
    "ADR",
    "AND",
    "ANDN",
    "ANY",
    "ANY_BIT",
    "ANY_DATE",
    "ANY_INT",
    "ANY_NUM",
    "ANY_REAL",
    "ARRAY",
    "ASIN",
    "AT",
    "ATAN",
    "ATAN2",
    "BIT",
    "BITADR",
    "BOOL",
    "BY",
    "BYTE",
    "CAL",
    "CALC",
    "CALCN",
    "CASE",
    "CHAR",
    "CLASS",
    "CONCAT",
    "CONFIGURATION",
    "CONSTANT",
    "CONTINUE",
    "COS",
    "CTD",
    "CTU",
    "CTUD",
    "DATE",
    "DATE_AND_TIME",
    "DELETE",
    "DINT",
    "DIV",
    "DO",
    "DT",
    "DWORD",
    "ELSE",
    "ELSIF",
    "END_ACTION",
    "END_CASE",
    "END_CLASS",
    "END_CONFIGURATION",
    "END_FOR",
    "END_FUNCTION",
    "END_FUNCTION_BLOCK",
    "END_IF",
    "END_INTERFACE",
    "END_METHOD",
    "END_NAMESPACE",
    "END_PROGRAM",
    "END_PROPERTY",
    "END_REPEAT",
    "END_RESOURCE",
    "END_STEP",
    "END_STRUCT",
    "END_TRANSITION",
    "END_TYPE",
    "END_UNION",
    "END_VAR",
    "END_WHILE",
    "ENO",
    "EN",
    "EQ",
    "EXIT",
    "EXP",
    "EXPT",
    "EXTENDS",
    "FALSE",
    "FINAL",
    "FIND",
    "FOR",
    "FROM",
    "FUNCTION",
    "FUNCTION_BLOCK",
    "F_EDGE",
    "F_TRIG",
    "GE",
    "GT",
    "IF",
    "IMPLEMENTS",
    "INDEXOF",
    "INI",
    "INITIAL_STEP",
    "INSERT",
    "INT",
    "INTERFACE",
    "INTERNAL",
    "INTERVAL",
    "JMP",
    "JMPC",
    "JMPCN",
    "LD",
    "LDATE",
    "LDN",
    "LDT",
    "LE",
    "LEFT",
    "LEN",
    "LIMIT",
    "LINT",
    "LN",
    "LOG",
    "LREAL",
    "LT",
    "LTIME",
    "LTOD",
    "LWORD",
    "MAX",
    "METHOD",
    "MID",
    "MIN",
    "MOD",
    "MOVE",
    "MUL",
    "MUX",
    "NAMESPACE",
    "NE",
    "NON_RETAIN",
    "NOT",
    "NULL",
    "OF",
    "ON",
    "OR",
    "ORN",
    "OVERLAP",
    "OVERRIDE",
    "PERSISTENT",
    "PID",
    "POINTER",
    "PRIORITY",
    "PRIVATE",
    "PROGRAM",
    "PROPERTY",
    "PROTECTED",
    "PUBLIC",
    "RAMP",
    "READ_ONLY",
    "READ_WRITE",
    "REAL",
    "REFERENCE",
    "REF_TO",
    "REPEAT",
    "REPLACE",
    "RESOURCE",
    "RET",
    "RETAIN",
    "RETC",
    "RETCN",
    "RETURN",
    "RIGHT",
    "ROL",
    "ROR",
    "RS",
    "RTC",
    "R_EDGE",
    "R_TRIG",
    "SEL",
    "SEMA",
    "SHL",
    "SHR",
    "SIN",
    "SINGLE",
    "SINT",
    "SIZEOF",
    "SQRT",
    "SR",
    "ST",
    "STEP",
    "STN",
    "STRING",
    "STRUCT",
    "SUB",
    "SUPER",
    "TAN",
    "TASK",
    "THEN",
    "THIS",
    "TIME",
    "TIME_OF_DAY",
    "TO",
    "TOD",
    "TOF",
    "TON",
    "TP",
    "TRANSITION",
    "TRUE",
    "TRUNC",
    "TYPE",
    "UDINT",
    "UINT",
    "ULINT",
    "UNION",
    "UNTIL",
    "USING",
    "USINT",
    "VAR",
    "VAR_ACCESS",
    "VAR_CONFIG",
    "VAR_EXTERNAL",
    "VAR_GLOBAL",
    "VAR_INPUT",
    "VAR_IN_OUT",
    "VAR_OUTPUT",
    "VAR_STAT",
    "VAR_TEMP",
    "WCHAR",
    "WHILE",
    "WITH",
    "WORD",
    "WSTRING",
    "XOR",
    "XORN",
});

constexpr std::size_t kLongestReserved = 20;
constexpr std::size_t kLongestTiaName = 128;  ///< characters

constexpr bool is_letter_or_digit(char c) {
  return text::is_digit(c) || (text::upper(c) >= 'A' && text::upper(c) <= 'Z');
}

bool is_reserved(std::string_view name) {
  if (name.size() > kLongestReserved) return false;
  static const auto kSorted = [] {
    auto words = kReserved;
    std::sort(words.begin(), words.end());
    return words;
  }();
  const std::string word = text::to_upper(name);
  return std::binary_search(kSorted.begin(), kSorted.end(), word);
}

}  // namespace

bool is_iec_identifier(std::string_view name) {
  if (name.empty() || text::is_digit(name.front()) || name.back() == '_') return false;
  char before = ' ';
  for (const char c : name) {
    if (c == '_' ? before == '_' : !is_letter_or_digit(c)) return false;
    before = c;
  }
  return !is_reserved(name);
}

std::string iec_identifier(std::string_view utf8_name) {
  if (is_iec_identifier(utf8_name)) return std::string(utf8_name);
  std::string name = utf8_name.starts_with('_') ? "_" : "";
  bool gap = false;
  const auto begin_part = [&] {
    if (gap && !name.empty() && name.back() != '_') name += '_';
    gap = false;
  };
  for (std::size_t at = 0; at < utf8_name.size();) {
    const text::CodePoint point = text::code_point_at(utf8_name, at);
    const char c = utf8_name[at];
    at += point.length;
    if (point.value >= 0x80) {
      begin_part();
      fmt::format_to(std::back_inserter(name), "u{:04X}", static_cast<std::uint32_t>(point.value));
    } else if (is_letter_or_digit(c)) {
      begin_part();
      name += c;
    } else {
      gap = true;
    }
  }
  if (name.empty() || name == "_") return "_1";
  if (text::is_digit(name.front()) || is_reserved(name)) name.insert(name.begin(), '_');
  return name;
}

bool is_tia_name(std::string_view name) {
  const auto is_bad = [](char c) { return c == '"' || c == '\x7F' || static_cast<unsigned char>(c) < 0x20; };
  return std::none_of(name.begin(), name.end(), is_bad) &&
         (name.size() <= kLongestTiaName || text::count_code_points(name) <= kLongestTiaName);
}

std::string tia_name(std::string_view utf8_name) {
  std::string name;
  std::size_t count = 0;
  for (std::size_t at = 0; at < utf8_name.size() && count < kLongestTiaName; ++count) {
    const text::CodePoint point = text::code_point_at(utf8_name, at);
    if (point.value == U'"') {
      name += '\'';
    } else if (point.value < 0x20 || point.value == 0x7F) {
      name += ' ';
    } else {
      text::append_utf8(name, point.value);
    }
    at += point.length;
  }
  return name;
}

}  // namespace symplant::convert
