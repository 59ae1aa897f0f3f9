// Texts without regard to the case of ASCII letters, eight bytes at a time.
#include "text/ascii.hpp"

#include <random>

#include "support/catch.hpp"

using namespace symplant::text;

TEST_CASE("Only ASCII letters change to capitals, in texts of any length") {
  for (int c = 0; c < 256; ++c) {
    const char as = static_cast<char>(c);
    const char capital = c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : as;
    for (const std::size_t size : {1U, 7U, 8U, 9U, 20U}) {
      std::string text(size, 'x');
      text[size / 2] = as;
      std::string expected(size, 'X');
      expected[size / 2] = capital;
      REQUIRE(to_upper(text) == expected);
      REQUIRE(equal_ignoring_case(text, expected));
    }
  }
}

TEST_CASE("Texts are equal without regard to case if their capitals are") {
  constexpr std::string_view kCharacters = "aAzZ@[`{0 \x81\xC1\xE1";
  std::mt19937 random(1);
  std::size_t equal = 0;
  for (int round = 0; round < 50'000; ++round) {
    std::string a;
    for (std::size_t size = random() % 20; size > 0; --size) a += kCharacters[random() % kCharacters.size()];
    std::string b = a;
    for (char& c : b) c = random() % 2 == 0 ? lower(c) : c;
    if (!b.empty() && random() % 2 == 0) b[random() % b.size()] = kCharacters[random() % kCharacters.size()];
    CAPTURE(a, b);
    const bool expected = to_upper(a) == to_upper(b);
    REQUIRE(equal_ignoring_case(a, b) == expected);
    if (expected) REQUIRE(hash_ignoring_case(a) == hash_ignoring_case(b));
    equal += expected ? 1U : 0U;
  }
  CHECK(equal > 10'000);
  CHECK_FALSE(equal_ignoring_case("ABCDEFGH", "ABCDEFGHI"));
  static_assert(equal_ignoring_case("abcdefghi", "ABCDEFGHI"));
}
