// Work for several threads: every call once, also when one throws.
#include "base/parallel.hpp"

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "support/catch.hpp"

using namespace symplant::base;

TEST_CASE("Every number is given to one call, with any number of threads") {
  for (const std::size_t threads : {0U, 1U, 2U, 7U}) {
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
      CAPTURE(threads, count);
      std::vector<int> calls(count);
      for_each_number(count, threads, [&](std::size_t number) { ++calls.at(number); });
      CHECK(calls == std::vector<int>(count, 1));
    }
  }
}

TEST_CASE("Two calls run at the same time") {
  std::atomic<int> arrived = 0;
  for_each_number(2, 2, [&](std::size_t) {
    ++arrived;
    while (arrived != 2) std::this_thread::yield();  // the other call must begin before this one ends
  });
  CHECK(arrived == 2);
}

TEST_CASE("The exception of a call is passed on, after all threads ended") {
  std::atomic<int> running = 0;
  const auto work = [&](std::size_t number) {
    ++running;
    std::this_thread::yield();
    --running;
    if (number == 500) throw std::runtime_error("the 500th");
  };
  CHECK_THROWS_WITH(for_each_number(1000, 3, work), "the 500th");
  CHECK(running == 0);
}

TEST_CASE("A short list is not worth a thread") {
  CHECK(threads_for(0) == 1);
  CHECK(threads_for(10'000) == 1);
  CHECK(threads_for(1'000'000) >= 1);
}
