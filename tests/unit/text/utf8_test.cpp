// Characters in UTF-8.
#include "text/utf8.hpp"

#include <random>
#include <string>

#include "support/catch.hpp"

using namespace symplant::text;

TEST_CASE("Characters are counted, not bytes, in texts of any length") {
  const std::string pieces[] = {"a", "\x7F", "\xC3\x9C", "\xEC\x98\x88", "\xF0\x9F\x98\x80"};
  std::mt19937 random(1);
  for (int round = 0; round < 2'000; ++round) {
    std::string text;
    const std::size_t characters = random() % 40;
    for (std::size_t i = 0; i < characters; ++i) text += pieces[random() % (round % 2 == 0 ? 5U : 2U)];
    REQUIRE(count_code_points(text) == characters);
  }
}
