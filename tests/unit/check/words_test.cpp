// Words that differ by a typing error.
#include "check/words.hpp"

#include "support/catch.hpp"

namespace symplant::test {
namespace {

using check::differ_by_ending;
using check::differ_by_slip;
using check::NearWords;

TEST_CASE("One letter more, less or other, or two neighbors exchanged, is a slip") {
  CHECK(differ_by_slip(U"CLAMP#", U"CLMP#"));
  CHECK(differ_by_slip(U"CLMP#", U"CLAMP#"));
  CHECK(differ_by_slip(U"CLAMP", U"CLAMPS"));
  CHECK(differ_by_slip(U"CLAMP", U"CRAMP"));
  CHECK(differ_by_slip(U"CLAMP", U"CLAPM"));
  CHECK_FALSE(differ_by_slip(U"CLAMP", U"CLAMP"));
  CHECK_FALSE(differ_by_slip(U"CLAMP", U"CLA"));
  CHECK_FALSE(differ_by_slip(U"CLAMP", U"PLAMC"));
  CHECK_FALSE(differ_by_slip(U"CLAMP", U"LCAPM"));
}

TEST_CASE("Digits are not a slip, and single letters do not prove one") {
  CHECK_FALSE(differ_by_slip(U"CLAMP1", U"CLAMP2"));
  CHECK_FALSE(differ_by_slip(U"CLAMP#", U"CLAMP"));
  CHECK_FALSE(differ_by_slip(U"CLAMP#A", U"CLAMPA#"));
  CHECK(differ_by_slip(U"PIN#", U"PN#"));
  CHECK_FALSE(differ_by_slip(U"P#", U"PI#"));
  CHECK_FALSE(differ_by_slip(U"전진", U"후퇴"));
  CHECK(differ_by_slip(U"클램프전진", U"클램트전진"));
}

TEST_CASE("A word with an ending is another word, not a slip") {
  CHECK(differ_by_ending(U"CLOSED", U"CLOSE"));
  CHECK(differ_by_ending(U"CLAMP", U"CLAMPED"));
  CHECK_FALSE(differ_by_ending(U"CLOSE", U"CLOSER"));
}

TEST_CASE("A letter of a short code, an axis or a side distinguishes two classes") {
  using check::may_be_codes;
  CHECK(may_be_codes(U"PB#", U"PL#"));
  CHECK(may_be_codes(U"L_P_PB1_I_ON", U"L_P_PL1_I_ON"));
  CHECK(may_be_codes(U"PB#", U"PBL#"));
  CHECK(may_be_codes(U"PBLX", U"PBLY"));
  CHECK(may_be_codes(U"#P#", U"#U#"));
  CHECK_FALSE(may_be_codes(U"PB#", U"BP#"));  // exchanged
  CHECK_FALSE(may_be_codes(U"CLAMP#", U"CLANP#"));
  CHECK_FALSE(may_be_codes(U"CLAMP#", U"CLMP#"));
  CHECK(may_be_codes(U"DRIVEX", U"DRIVEY"));
  CHECK(may_be_codes(U"XAXIS#", U"YAXIS#"));
  CHECK(may_be_codes(U"CLAMPL#", U"CLAMPR#"));
  CHECK(may_be_codes(U"VALVEA", U"VALVEB"));
  CHECK_FALSE(may_be_codes(U"BALVE", U"DALVE"));
  CHECK_FALSE(may_be_codes(U"DRIVEX", U"DRIVE"));
}

TEST_CASE("A text gives the words near it, the most common first") {
  const std::vector<check::CountedWord> words{{U"RTE", 1}, {U"RET", 200}, {U"RATE", 300}, {U"ADV", 200}};
  const NearWords near(words);
  CHECK(near.near(U"RTE") == std::vector<std::uint32_t>{2, 1});
  CHECK(near.near(U"RTED") == std::vector<std::uint32_t>{0});
  CHECK(near.near(U"ADVX") == std::vector<std::uint32_t>{3});
  CHECK(near.near(U"HOME").empty());
}

TEST_CASE("Every near pair is found unless more than the best three share a bucket") {
  std::vector<check::CountedWord> words;
  for (char32_t a = U'A'; a <= U'E'; ++a) {
    for (char32_t b = U'A'; b <= U'E'; ++b) words.push_back({std::u32string{U'X', a, b, U'X'}, words.size() + 1});
  }
  const NearWords near(words);
  for (std::uint32_t location = 0; location < words.size(); ++location) {
    const auto found = near.near(words[location].text);
    std::uint32_t best = location;
    for (std::uint32_t other = 0; other < words.size(); ++other) {
      if (differ_by_slip(words[location].text, words[other].text)) best = other;
    }
    REQUIRE_FALSE(found.empty());
    CHECK(found.front() == best);  // the most common one is always among them
  }
}

}  // namespace
}  // namespace symplant::test
