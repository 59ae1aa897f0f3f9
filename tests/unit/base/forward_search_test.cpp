// A search that goes forward finds what a simple loop finds.
#include "base/forward_search.hpp"

#include <random>
#include <string>

#include "support/catch.hpp"

using symplant::base::ForwardSearch;

TEST_CASE("A forward search finds every character, at any distance and near the end") {
  std::mt19937 random(1);
  for (int round = 0; round < 2'000; ++round) {
    const std::string letters = round % 2 == 0 ? "abcdefghijklmnop" : ";\n\rx";
    std::string text;
    for (std::size_t size = random() % 300; size > 0; --size) text += letters[random() % letters.size()];
    if (round % 5 == 0) text += std::string(random() % 200, '\x80');
    ForwardSearch search(text, ';', '\n', '\r');
    CAPTURE(text);
    for (std::size_t from = random() % 3; from <= text.size(); from += 1 + random() % 3) {
      const std::size_t expected = std::min(text.find_first_of(";\n\r", from), text.size());
      REQUIRE(search.next(from) == expected);
    }
  }
}

TEST_CASE("A forward search in an empty text finds its end") { CHECK(ForwardSearch("", 'a', 'b', 'c').next(0) == 0); }
