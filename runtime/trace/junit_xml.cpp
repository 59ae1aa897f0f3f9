// Writes JUnit XML.
#include "symplant/trace/junit_xml.hpp"

#include <fmt/format.h>

#include "symplant/trace/finding_words.hpp"

namespace symplant::trace {
namespace {

/// Plant time in seconds, without the unit, to the nanosecond.
std::string time_text(tables::Time time) {
  const std::string text = seconds(time);
  return text.substr(0, text.find(' '));
}

/// The size in bytes of the first UTF-8 character; 0 if it is invalid or not allowed in XML.
std::size_t xml_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < size) return 0;
  char32_t code = first & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3F);
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code < kLeast[size] || code > 0x10FFFF || surrogate || code == 0xFFFE || code == 0xFFFF ? 0 : size;
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string xml;
  while (!text.empty()) {
    const std::size_t size = xml_character(text);
    const char c = text.front();
    if (size == 0) {
      xml += "\xEF\xBF\xBD";
    } else if (c == '&') {
      xml += "&amp;";
    } else if (c == '<') {
      xml += "&lt;";
    } else if (c == '>') {
      xml += "&gt;";
    } else if (c == '"') {
      xml += "&quot;";
    } else if (c == '\n' || c == '\t' || c == '\r') {  // unescaped, an attribute would turn it into a blank
      xml += fmt::format("&#{};", static_cast<int>(c));
    } else {
      xml += text.substr(0, size);
    }
    text.remove_prefix(size == 0 ? 1 : size);
  }
  return xml;
}

std::string junit_xml(std::string_view suite, std::span<const TestCase> cases, tables::Time end) {
  std::size_t failures = 0;
  std::size_t errors = 0;
  std::string lines;
  const std::string name = xml_text(suite);
  for (const TestCase& test : cases) {
    lines += fmt::format(R"(    <testcase classname="{}" name="{}" time="{}")", name, xml_text(test.name),
                         time_text(test.time));
    if (test.failure.empty() && test.error.empty()) {
      lines += "/>\n";
      continue;
    }
    const bool failed = test.error.empty();
    ++(failed ? failures : errors);
    lines += fmt::format(">\n      <{} message=\"{}\"/>\n    </testcase>\n", failed ? "failure" : "error",
                         xml_text(failed ? test.failure : test.error));
  }
  const std::string counts =
      fmt::format(R"(tests="{}" failures="{}" errors="{}" time="{}")", cases.size(), failures, errors, time_text(end));
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {1}>\n  <testsuite name=\"{0}\" {1}>\n{2}"
      "  </testsuite>\n</testsuites>\n",
      name, counts, lines);
}

}  // namespace symplant::trace
