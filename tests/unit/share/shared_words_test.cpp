// The shared image: every touched word arrives complete, whatever was skipped in between.
#include "symplant/share/shared_words.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <thread>
#include <vector>

#include "support/catch.hpp"

using symplant::share::SharedWords;

namespace {

std::vector<std::uint64_t> copy(std::span<const std::uint64_t> words) { return {words.begin(), words.end()}; }

}  // namespace

TEST_CASE("Both sides of an image start equal") {
  const SharedWords image({1, 2, 3});
  CHECK(copy(image.latest()) == std::vector<std::uint64_t>{1, 2, 3});
}

TEST_CASE("An image without words can be handed over") {
  SharedWords image({});
  image.publish();
  CHECK(image.update());
  CHECK(image.latest().empty());
}

TEST_CASE("Words written in earlier images are not lost if the reader skipped those") {
  SharedWords image({0, 0, 0, 0, 0, 0});
  for (std::size_t word = 0; word < 6; ++word) {
    image.words()[word] = word + 10;
    image.touch(word);
    image.publish();
  }
  REQUIRE(image.update());
  CHECK(copy(image.latest()) == std::vector<std::uint64_t>{10, 11, 12, 13, 14, 15});
}

TEST_CASE("The image equals the published one at any rate of reading") {
  std::mt19937 random(1);
  SharedWords image(std::vector<std::uint64_t>(40, 0));
  std::vector<std::uint64_t> published(40, 0);
  for (int step = 0; step < 20'000; ++step) {
    for (std::uint32_t change = random() % 4; change > 0; --change) {
      const std::size_t word = random() % 40;
      image.words()[word] = random();
      image.touch(word);
    }
    if (random() % 2 == 0) {
      image.publish();
      published = copy(image.words());
    }
    if (random() % 3 == 0) {
      image.update();
      REQUIRE(copy(image.latest()) == published);
    }
  }
}

TEST_CASE("Two threads hand over complete images of words, of which only some are touched") {
  constexpr std::uint64_t kLast = 100'000;
  SharedWords image(std::vector<std::uint64_t>(16, 0));
  std::thread writer([&image] {
    for (std::uint64_t value = 1; value <= kLast; ++value) {
      // Word 0 counts; one other word takes the count too. The image is complete if one of them equals it.
      image.words()[0] = value;
      image.words()[1 + value % 15] = value;
      image.touch(0);
      image.touch(1 + value % 15);
      image.publish();
    }
  });
  std::uint64_t torn = 0;
  std::uint64_t seen = 0;
  while (seen != kLast) {
    if (!image.update()) {
      std::this_thread::yield();
      continue;
    }
    const auto words = image.latest();
    seen = words[0];
    for (std::uint64_t age = 0; age < 15 && age < seen; ++age) {
      torn += words[1 + (seen - age) % 15] != seen - age ? 1U : 0U;
    }
  }
  writer.join();
  CHECK(torn == 0);
}
