// Words that differ by a typing error.
#include "check/spelling/near_words.hpp"

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
  using check::differ_by_axis;
  using check::differ_by_class_letter;
  CHECK(differ_by_class_letter(U"PB#", U"PL#"));
  CHECK(differ_by_class_letter(U"PB#", U"PBL#"));
  CHECK(differ_by_class_letter(U"PBLX", U"PBLY"));
  CHECK(differ_by_class_letter(U"#P#", U"#U#"));
  CHECK_FALSE(differ_by_class_letter(U"PB#", U"BP#"));  // exchanged
  CHECK_FALSE(differ_by_class_letter(U"CLAMP#", U"CLANP#"));
  CHECK_FALSE(differ_by_class_letter(U"CLAMP#", U"CLMP#"));
  CHECK(differ_by_axis(U"DRIVEX", U"DRIVEY"));
  CHECK(differ_by_axis(U"XAXIS#", U"YAXIS#"));
  CHECK(differ_by_axis(U"CLAMPL#", U"CLAMPR#"));
  CHECK(differ_by_axis(U"VALVEA", U"VALVEB"));
  CHECK_FALSE(differ_by_axis(U"BALVE", U"DALVE"));
  CHECK_FALSE(differ_by_axis(U"DRIVEX", U"DRIVE"));
}

TEST_CASE("A word gives its more common near words, the most common first") {
  const std::vector<NearWords::Word> words{{U"RTE", 1}, {U"RET", 200}, {U"RATE", 300}, {U"ADV", 200}, {U"RTED", 1}};
  const NearWords near(words);
  CHECK(near.commoner_near(0) == std::vector<std::uint32_t>{2, 1});
  CHECK(near.commoner_near(4) == std::vector<std::uint32_t>{0});
  CHECK(near.commoner_near(2).empty());
  CHECK(near.commoner_near(3).empty());
}

TEST_CASE("Every near pair is found unless more than the best three share a bucket") {
  std::vector<NearWords::Word> words;
  for (char32_t a = U'A'; a <= U'E'; ++a) {
    for (char32_t b = U'A'; b <= U'E'; ++b) words.push_back({std::u32string{U'X', a, b, U'X'}, words.size() + 1});
  }
  const NearWords near(words);
  for (std::uint32_t location = 0; location < words.size(); ++location) {
    const auto found = near.commoner_near(location);
    std::size_t all = 0;
    for (std::uint32_t other = location + 1; other < words.size(); ++other) {
      if (differ_by_slip(words[location].text, words[other].text)) ++all;
    }
    CHECK(found.size() <= all);
    CHECK((all == 0 || !found.empty()));
    if (all != 0) {
      // The most common of all near words is always among them.
      std::uint32_t best = location;
      for (std::uint32_t other = location + 1; other < words.size(); ++other) {
        if (differ_by_slip(words[location].text, words[other].text)) best = other;
      }
      CHECK(found.front() == best);
    }
  }
}

}  // namespace
}  // namespace symplant::test
