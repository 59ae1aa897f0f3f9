// The triple buffer: the latest value wins, complete values only.
#include "symplant/share/triple_buffer.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

#include "support/catch.hpp"

using symplant::share::TripleBuffer;

TEST_CASE("A reader sees the first value until another one is published") {
  TripleBuffer<int> buffer(7);
  CHECK(buffer.front() == 7);
  CHECK_FALSE(buffer.update());
  buffer.back() = 8;
  CHECK_FALSE(buffer.update());
  CHECK(buffer.front() == 7);
}

TEST_CASE("A published value is taken once") {
  TripleBuffer<int> buffer(0);
  buffer.back() = 1;
  buffer.publish();
  CHECK(buffer.front() == 0);
  CHECK(buffer.update());
  CHECK(buffer.front() == 1);
  CHECK_FALSE(buffer.update());
  CHECK(buffer.front() == 1);
}

TEST_CASE("The latest of several published values wins") {
  TripleBuffer<int> buffer(0);
  for (int value = 1; value <= 5; ++value) {
    buffer.back() = value;
    buffer.publish();
  }
  CHECK(buffer.update());
  CHECK(buffer.front() == 5);
  CHECK_FALSE(buffer.update());
}

TEST_CASE("The writer never gets the slot that the reader holds") {
  TripleBuffer<int> buffer(0);
  buffer.back() = 1;
  buffer.publish();
  REQUIRE(buffer.update());
  const int* held = &buffer.front();
  for (int value = 2; value < 20; ++value) {
    CHECK(&buffer.back() != held);
    buffer.back() = value;
    buffer.publish();
  }
  CHECK(*held == 1);
}

TEST_CASE("Two threads hand over only complete images, in order, and the last one arrives") {
  using Image = std::array<std::uint64_t, 64>;
  constexpr std::uint64_t kLast = 100'000;
  TripleBuffer<Image> buffer(Image{});

  std::thread writer([&buffer] {
    for (std::uint64_t value = 1; value <= kLast; ++value) {
      buffer.back().fill(value);
      buffer.publish();
    }
  });
  std::uint64_t torn = 0;
  std::uint64_t backwards = 0;
  std::uint64_t seen = 0;
  while (seen != kLast) {
    if (!buffer.update()) {
      std::this_thread::yield();
      continue;
    }
    const Image& image = buffer.front();
    for (const std::uint64_t word : image) torn += word != image[0] ? 1U : 0U;
    backwards += image[0] <= seen ? 1U : 0U;
    seen = image[0];
  }
  writer.join();
  CHECK(torn == 0);
  CHECK(backwards == 0);
}
