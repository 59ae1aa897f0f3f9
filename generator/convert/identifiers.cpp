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

// All three are sorted. A compiler takes none of these words as a name.
/// Of the language, and instructions of instruction lists.
constexpr auto kKeywords = std::to_array<std::string_view>({"ABSTRACT",
                                                            "ACTION",
                                                            "ANDN",
                                                            "ARRAY",
                                                            "AT",
                                                            "BY",
                                                            "CAL",
                                                            "CALC",
                                                            "CALCN",
                                                            "CASE",
                                                            "CLASS",
                                                            "CONFIGURATION",
                                                            "CONSTANT",
                                                            "CONTINUE",
                                                            "DO",
                                                            "ELSE",
                                                            "ELSIF",
                                                            "EN",
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
                                                            "EXIT",
                                                            "EXTENDS",
                                                            "FALSE",
                                                            "FINAL",
                                                            "FOR",
                                                            "FROM",
                                                            "FUNCTION",
                                                            "FUNCTION_BLOCK",
                                                            "F_EDGE",
                                                            "IF",
                                                            "IMPLEMENTS",
                                                            "INI",
                                                            "INITIAL_STEP",
                                                            "INTERFACE",
                                                            "INTERNAL",
                                                            "INTERVAL",
                                                            "JMP",
                                                            "JMPC",
                                                            "JMPCN",
                                                            "LD",
                                                            "LDN",
                                                            "METHOD",
                                                            "NAMESPACE",
                                                            "NON_RETAIN",
                                                            "NULL",
                                                            "OF",
                                                            "ON",
                                                            "ORN",
                                                            "OVERLAP",
                                                            "OVERRIDE",
                                                            "PERSISTENT",
                                                            "POINTER",
                                                            "PRIORITY",
                                                            "PRIVATE",
                                                            "PROGRAM",
                                                            "PROPERTY",
                                                            "PROTECTED",
                                                            "PUBLIC",
                                                            "READ_ONLY",
                                                            "READ_WRITE",
                                                            "REFERENCE",
                                                            "REF_TO",
                                                            "REPEAT",
                                                            "RESOURCE",
                                                            "RET",
                                                            "RETAIN",
                                                            "RETC",
                                                            "RETCN",
                                                            "RETURN",
                                                            "R_EDGE",
                                                            "SINGLE",
                                                            "ST",
                                                            "STEP",
                                                            "STN",
                                                            "STRUCT",
                                                            "SUPER",
                                                            "TASK",
                                                            "THEN",
                                                            "THIS",
                                                            "TO",
                                                            "TRANSITION",
                                                            "TRUE",
                                                            "TYPE",
                                                            "UNION",
                                                            "UNTIL",
                                                            "USING",
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
                                                            "WHILE",
                                                            "WITH",
                                                            "XORN"});
/// Elementary types.
constexpr auto kTypeNames = std::to_array<std::string_view>(
    {"ANY",      "ANY_BIT",    "ANY_DATE", "ANY_DERIVED", "ANY_ELEMENTARY", "ANY_INT", "ANY_MAGNITUDE", "ANY_NUM",
     "ANY_REAL", "ANY_STRING", "BIT",      "BOOL",        "BYTE",           "CHAR",    "DATE",          "DATE_AND_TIME",
     "DINT",     "DT",         "DWORD",    "INT",         "LDATE",          "LDT",     "LINT",          "LREAL",
     "LTIME",    "LTOD",       "LWORD",    "REAL",        "SINT",           "STRING",  "TIME",          "TIME_OF_DAY",
     "TOD",      "UDINT",      "UINT",     "ULINT",       "USINT",          "WCHAR",   "WORD",          "WSTRING"});
/// Standard functions and function blocks.
constexpr auto kFunctions = std::to_array<std::string_view>(
    {"ABS",    "ACOS", "ADD",  "ADR",        "AND",        "ASIN",    "ATAN",     "ATAN2", "BITADR", "CONCAT",  "COS",
     "CTD",    "CTU",  "CTUD", "DELETE",     "DERIVATIVE", "DIV",     "DIVTIME",  "EQ",    "EXP",    "EXPT",    "FIND",
     "F_TRIG", "GE",   "GT",   "HYSTERESIS", "INDEXOF",    "INSERT",  "INTEGRAL", "LE",    "LEFT",   "LEN",     "LIMIT",
     "LN",     "LOG",  "LT",   "MAX",        "MID",        "MIN",     "MOD",      "MOVE",  "MUL",    "MULTIME", "MUX",
     "NE",     "NOT",  "OR",   "PID",        "RAMP",       "REPLACE", "RIGHT",    "ROL",   "ROR",    "RS",      "RTC",
     "R_TRIG", "SEL",  "SEMA", "SHL",        "SHR",        "SIN",     "SIZEOF",   "SQRT",  "SR",     "SUB",     "TAN",
     "TOF",    "TON",  "TP",   "TRUNC",      "XOR"});

constexpr std::size_t kLongestReserved = 20;
constexpr std::size_t kLongestTiaName = 128;  ///< characters

constexpr bool is_letter_or_digit(char c) {
  return text::is_digit(c) || (text::upper(c) >= 'A' && text::upper(c) <= 'Z');
}

template <class Words>
bool holds(const Words& words, std::string_view word) {
  return std::binary_search(words.begin(), words.end(), word);
}

/// A function of certain types: ADD_INT, BOOL_TO_INT, WORD_BCD_TO_UINT. `word` is in upper case.
bool is_typed_function(std::string_view word) {
  const std::size_t last = word.rfind('_');
  std::size_t end = word.find('_');
  if (last == word.npos) return false;
  const auto is_type = [](std::string_view part) { return part == "BCD" || holds(kTypeNames, part); };
  if (!is_type(word.substr(last + 1))) return false;
  if (!is_type(word.substr(0, end)) && !holds(kFunctions, word.substr(0, end))) return false;
  while (end != last) {
    const std::size_t next = word.find('_', end + 1);
    const std::string_view part = word.substr(end + 1, next - end - 1);
    if (part != "TO" && !is_type(part)) return false;
    end = next;
  }
  return true;
}

static_assert(std::is_sorted(kKeywords.begin(), kKeywords.end()));
static_assert(std::is_sorted(kTypeNames.begin(), kTypeNames.end()));
static_assert(std::is_sorted(kFunctions.begin(), kFunctions.end()));

}  // namespace

bool is_iec_reserved(std::string_view name) {
  if (name.size() > kLongestReserved) return false;
  const std::string word = text::to_upper(name);
  return holds(kKeywords, word) || holds(kTypeNames, word) || holds(kFunctions, word) || is_typed_function(word);
}

bool is_iec_identifier(std::string_view name) {
  if (name.empty() || text::is_digit(name.front()) || name.back() == '_') return false;
  char before = ' ';
  for (const char c : name) {
    if (c == '_' ? before == '_' : !is_letter_or_digit(c)) return false;
    before = c;
  }
  return !is_iec_reserved(name);
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
  if (text::is_digit(name.front()) || is_iec_reserved(name)) name.insert(name.begin(), '_');
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
