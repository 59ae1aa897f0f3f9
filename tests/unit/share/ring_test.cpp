// The queue between two threads.
#include "symplant/share/ring.hpp"

#include <thread>

#include "support/catch.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A ring gives back its values in their order, and takes no more than it holds") {
  share::Ring<int> ring(3);
  CHECK(ring.front() == nullptr);
  for (int i = 0; i < 4; ++i) CHECK(ring.put(i));  // a power of two
  CHECK_FALSE(ring.put(4));
  REQUIRE(ring.front() != nullptr);
  CHECK(*ring.front() == 0);
  ring.pop();
  CHECK(ring.put(5));
  for (const int expected : {1, 2, 3, 5}) {
    REQUIRE(ring.front() != nullptr);
    CHECK(*ring.front() == expected);
    ring.pop();
  }
  CHECK(ring.front() == nullptr);
}

TEST_CASE("Another thread reads every value of a ring once") {
  constexpr int kValues = 20'000;
  share::Ring<int> ring(16);
  int in_order = 0;
  std::thread reader([&] {
    for (int expected = 0; expected < kValues;) {
      const int* const value = ring.front();
      if (value == nullptr) {
        std::this_thread::yield();
        continue;
      }
      in_order += *value == expected++ ? 1 : 0;
      ring.pop();
    }
  });
  for (int i = 0; i < kValues;) {
    if (ring.put(i)) {
      ++i;
    } else {
      std::this_thread::yield();
    }
  }
  reader.join();
  CHECK(in_order == kValues);
}

}  // namespace
}  // namespace symplant::test
