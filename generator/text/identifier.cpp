// Converts names to C++ identifiers.
#include "text/identifier.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

#include "text/ascii.hpp"
#include "text/error_macros.hpp"
#include "text/utf8.hpp"

namespace symplant::text {

namespace {

using namespace std::string_view_literals;

static_assert(std::is_sorted(kErrorMacros.begin(), kErrorMacros.end()));

/// Sorted. Keywords and alternative tokens of C++20, and macros that common headers or compilers define.
constexpr std::array kTaken{"BUFSIZ"sv,       "CHAR_BIT"sv,      "EDOM"sv,
                            "EILSEQ"sv,       "EOF"sv,           "ERANGE"sv,
                            "EXIT_FAILURE"sv, "EXIT_SUCCESS"sv,  "FALSE"sv,
                            "FILENAME_MAX"sv, "HUGE_VAL"sv,      "I"sv,
                            "INFINITY"sv,     "INT_MAX"sv,       "INT_MIN"sv,
                            "LONG_MAX"sv,     "LONG_MIN"sv,      "NAN"sv,
                            "NULL"sv,         "RAND_MAX"sv,      "SIGABRT"sv,
                            "SIGFPE"sv,       "SIGILL"sv,        "SIGINT"sv,
                            "SIGSEGV"sv,      "SIGTERM"sv,       "TRUE"sv,
                            "alignas"sv,      "alignof"sv,       "and"sv,
                            "and_eq"sv,       "asm"sv,           "assert"sv,
                            "auto"sv,         "bitand"sv,        "bitor"sv,
                            "bool"sv,         "break"sv,         "case"sv,
                            "catch"sv,        "char"sv,          "char16_t"sv,
                            "char32_t"sv,     "char8_t"sv,       "class"sv,
                            "co_await"sv,     "co_return"sv,     "co_yield"sv,
                            "compl"sv,        "concept"sv,       "const"sv,
                            "const_cast"sv,   "consteval"sv,     "constexpr"sv,
                            "constinit"sv,    "continue"sv,      "decltype"sv,
                            "default"sv,      "delete"sv,        "do"sv,
                            "double"sv,       "dynamic_cast"sv,  "else"sv,
                            "enum"sv,         "errno"sv,         "explicit"sv,
                            "export"sv,       "extern"sv,        "false"sv,
                            "float"sv,        "for"sv,           "friend"sv,
                            "goto"sv,         "i386"sv,          "if"sv,
                            "import"sv,       "inline"sv,        "int"sv,
                            "linux"sv,        "long"sv,          "major"sv,
                            "minor"sv,        "module"sv,        "mutable"sv,
                            "namespace"sv,    "new"sv,           "noexcept"sv,
                            "not"sv,          "not_eq"sv,        "nullptr"sv,
                            "offsetof"sv,     "operator"sv,      "or"sv,
                            "or_eq"sv,        "private"sv,       "protected"sv,
                            "public"sv,       "register"sv,      "reinterpret_cast"sv,
                            "requires"sv,     "return"sv,        "setjmp"sv,
                            "short"sv,        "signed"sv,        "sizeof"sv,
                            "static"sv,       "static_assert"sv, "static_cast"sv,
                            "stderr"sv,       "stdin"sv,         "stdout"sv,
                            "struct"sv,       "switch"sv,        "template"sv,
                            "this"sv,         "thread_local"sv,  "throw"sv,
                            "true"sv,         "try"sv,           "typedef"sv,
                            "typeid"sv,       "typename"sv,      "union"sv,
                            "unix"sv,         "unsigned"sv,      "using"sv,
                            "va_arg"sv,       "va_copy"sv,       "va_end"sv,
                            "va_start"sv,     "virtual"sv,       "void"sv,
                            "volatile"sv,     "wchar_t"sv,       "while"sv,
                            "xor"sv,          "xor_eq"sv};
static_assert(std::is_sorted(kTaken.begin(), kTaken.end()));

/// Words that system headers define as macros by the hundred: those of errno, and families with common ends.
bool is_macro_like(std::string_view text) {
  const auto capital = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; };
  if (!std::all_of(text.begin(), text.end(), capital)) return false;
  if (std::binary_search(kErrorMacros.begin(), kErrorMacros.end(), text)) return true;
  if (text.find("_I_") != text.npos || text.find("_O_") != text.npos) return false;  // a symbol's name
  constexpr std::array kBeginnings{"ADJ_"sv,  "ATOMIC_"sv,  "CLOCK_"sv,  "CLONE_"sv,  "CPU_"sv,    "FD_"sv,  "LC_"sv,
                                   "MOD_"sv,  "PTHREAD_"sv, "RENAME_"sv, "SCHED_"sv,  "SEEK_"sv,   "STA_"sv, "SYS_"sv,
                                   "TIME_"sv, "TIMER_"sv,   "WCONT"sv,   "WEOF"sv,    "WEXIT"sv,   "WIF"sv,  "WNO"sv,
                                   "WSTOP"sv, "WTERM"sv,    "WUNTR"sv,   "CSIGNAL"sv, "NFDBITS"sv, "NZERO"sv};
  constexpr std::array kEnds{"_MAX"sv, "_MIN"sv, "_WIDTH"sv, "_BIT"sv, "_ENDIAN"sv, "_OK"sv, "_FILENO"sv, "_C"sv};
  return std::any_of(kBeginnings.begin(), kBeginnings.end(), [&](auto part) { return text.starts_with(part); }) ||
         std::any_of(kEnds.begin(), kEnds.end(), [&](auto part) { return text.ends_with(part); });
}

bool is_taken(std::string_view text) {
  return std::binary_search(kTaken.begin(), kTaken.end(), text) || is_macro_like(text);
}

bool is_word(char32_t c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }

std::string in_hex(std::uint32_t value, const char* format) {
  char buffer[16];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

std::uint32_t hash_of(std::string_view text) {
  std::uint32_t hash = 2166136261U;  // FNV-1a
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

/// Letters, digits and single `_` between them; a digit may come first.
std::string legal_body(std::string_view name) {
  std::string body;
  bool after_escape = false;
  for (std::size_t at = 0; at < name.size() && body.size() <= kMaxIdentifierBody;) {
    const CodePoint point = code_point_at(name, at);
    at += point.length;
    const bool at_gap = body.empty() || body.back() == '_';
    if (is_word(point.value)) {
      if (after_escape) body += '_';
      body += static_cast<char>(point.value);
      after_escape = false;
    } else if (point.value == U'_' && !at_gap && at < name.size()) {
      body += '_';
      after_escape = false;
    } else {
      if (!at_gap) body += '_';
      body += in_hex(point.value, "u%04X");
      after_escape = true;
    }
  }
  if (body.size() <= kMaxIdentifierBody) return body;
  body.resize(kMaxIdentifierBody);
  if (body.back() == '_') body.pop_back();
  return body + '_' + in_hex(hash_of(name), "%08x");
}

std::string lower(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

}  // namespace

bool is_plain_identifier(std::string_view name) {
  if (name.empty() || name.size() > kMaxIdentifierBody || name.front() == '_' || name.back() == '_') return false;
  bool after_gap = false;
  for (const char c : name) {
    const bool gap = c == '_';
    if ((gap && after_gap) || !(gap || is_word(static_cast<unsigned char>(c)))) return false;
    after_gap = gap;
  }
  return true;
}

bool is_identifier(std::string_view name) {
  return is_plain_identifier(name) && !is_digit(name.front()) && !is_taken(name);
}

std::string identifier(std::string_view utf8_name) {
  if (is_identifier(utf8_name)) return std::string(utf8_name);
  std::string body = legal_body(utf8_name);
  if (body.empty()) return "unnamed";
  if (is_digit(body.front())) body.insert(body.begin(), 'n');
  if (is_taken(body)) body += '_';
  return body;
}

std::string identifier(std::string_view utf8_name, std::string_view prefix) {
  if (prefix.empty()) return identifier(utf8_name);
  const std::string body = legal_body(utf8_name);
  return std::string(prefix) + (body.empty() ? "unnamed" : body);
}

std::string enumerator(std::string_view utf8_name) { return identifier(utf8_name, "k"); }

IdentifierScope::IdentifierScope(std::span<const std::string_view> reserved) {
  for (const std::string_view word : reserved) next_.emplace(lower(std::string(word)), 2);
}

std::string IdentifierScope::unique(std::string_view utf8_name, std::string_view prefix) {
  std::string wanted = identifier(utf8_name, prefix);
  const auto [entry, fresh] = next_.try_emplace(lower(wanted), 2);
  if (fresh) return wanted;
  std::size_t& number = entry->second;  // the reference stays valid while other entries are added
  if (wanted.back() != '_') wanted += '_';
  for (;;) {
    std::string candidate = wanted + std::to_string(number++);
    if (next_.emplace(lower(candidate), 2).second) return candidate;
  }
}

}  // namespace symplant::text
