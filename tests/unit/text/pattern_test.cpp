// Patterns, and names in braces.
#include "text/pattern.hpp"

#include <random>

#include "support/catch.hpp"
#include "text/braces.hpp"

namespace symplant::text {
namespace {

std::string shares(std::string_view text, std::string_view pattern) {
  std::string joined;
  for (const std::string_view share : wildcard_shares(text, pattern)) joined.append("[").append(share).append("]");
  return joined;
}

std::string replaced(std::string_view text) {
  const Replaced result = replace_braces(text, [](std::string_view name) -> std::optional<std::string_view> {
    if (name == "line") return "L1";
    if (name == "braces") return "{line}";
    if (name == "1") return "";
    return std::nullopt;
  });
  return result.unknown.empty() ? result.text : "unknown: " + result.unknown;
}

TEST_CASE("Each wildcard has one share of the text, from left to right") {
  CHECK(shares("BB_S10_RBT3", "BB_*_RBT?") == "[S10][3]");
  CHECK(shares("BB_S10_RBT3", "?B_S10_*") == "[B][RBT3]");
  CHECK(shares("BB_S10_RBT3", "BB_S10_RBT3").empty());
  CHECK(shares("BB_S10_RBT3", "CC_*").empty());
}

TEST_CASE("A star has the shortest run, from the left, that lets the rest match") {
  CHECK(shares("A_B_C", "*_*") == "[A][B_C]");
  CHECK(shares("A_B_C", "*_?") == "[A_B][C]");
  CHECK(shares("A_B_C", "*_*_*") == "[A][B][C]");
  CHECK(shares("ABAB", "*B") == "[ABA]");
  CHECK(shares("ABAB", "*AB*") == "[][AB]");
  CHECK(shares("AAB", "*A?") == "[A][B]");
  CHECK(shares("AB", "**") == "[][AB]");
  CHECK(shares("AB", "*?*") == "[][A][B]");
  CHECK(shares("AB", "AB*") == "[]");
  CHECK(shares("", "*") == "[]");
}

TEST_CASE("The share of a star ends where the whole rest matches, not where it begins to") {
  CHECK(shares("ABCABD", "*AB?") == "[ABC][D]");
  CHECK(shares("A_X_A_Y", "*_?_Y") == "[A_X][A]");
  CHECK(shares("L_P?Q_P1", "*_P?") == "[L_P?Q][1]");
}

TEST_CASE("Shares are those of the text, whatever the case of the pattern") {
  CHECK(shares("Line_s1_D", "LINE_*_d") == "[s1]");
  CHECK(shares("LINE_S1_Dx", "line_s?_d?") == "[1][x]");
}

TEST_CASE("A question mark has a whole character, in any script") {
  CHECK(shares("Т1_П", "?1_?") == "[Т][П]");
  CHECK(shares("전진", "*?") == "[전][진]");
}

/// What `*` and `?` mean, by trying every run.
bool slow_shares(std::string_view text, std::string_view pattern, std::vector<std::string_view>& shares) {
  if (pattern.empty()) return text.empty();
  if (pattern[0] != '*' && pattern[0] != '?') {
    return !text.empty() && text[0] == pattern[0] && slow_shares(text.substr(1), pattern.substr(1), shares);
  }
  for (std::size_t n = pattern[0] == '?' ? 1 : 0; n <= (pattern[0] == '?' ? 1 : text.size()); ++n) {
    if (n > text.size()) break;
    shares.push_back(text.substr(0, n));
    if (slow_shares(text.substr(n), pattern.substr(1), shares)) return true;
    shares.pop_back();
  }
  return false;
}

TEST_CASE("Shares agree with trying every run from the left") {
  std::mt19937 random(7);
  const auto drawn = [&](std::string_view letters, std::size_t most) {
    std::string text;
    for (std::size_t n = random() % most; n > 0; --n) text += letters[random() % letters.size()];
    return text;
  };
  std::size_t matching = 0;
  for (int i = 0; i < 50'000; ++i) {
    const std::string text = drawn("AB", 9);
    const std::string pattern = drawn("AB*?*", 7);
    std::vector<std::string_view> expected;
    const bool matches = slow_shares(text, pattern, expected);
    CAPTURE(text, pattern);
    REQUIRE(matches_pattern(text, pattern) == matches);
    REQUIRE(wildcard_shares(text, pattern) == expected);
    matching += matches ? 1 : 0;
  }
  CHECK(matching > 2'000);
}

TEST_CASE("Names in braces are replaced, everything else is kept") {
  CHECK(replaced("{line}_S1.OPEN and not {line}{line}") == "L1_S1.OPEN and not L1L1");
  CHECK(replaced("A{1}B") == "AB");
  CHECK(replaced("").empty());
  CHECK(replaced("A } B") == "A } B");
  CHECK(replaced("'{line} 2'") == "'L1 2'");
}

TEST_CASE("A replacement is not replaced again") { CHECK(replaced("{braces}") == "{line}"); }

TEST_CASE("The first unknown name is reported as it is written") {
  CHECK(replaced("{line} {lin} {x}") == "unknown: {lin}");
  CHECK(replaced("{line} {LINE}") == "unknown: {LINE}");
  CHECK(replaced("{}") == "unknown: {}");
  CHECK(replaced("{line} {line") == "unknown: {line");
  CHECK(replaced("{{line}}") == "unknown: {{line}");
}

}  // namespace
}  // namespace symplant::text
