// What was read and waits to be taken.
#include "record/reader.hpp"

#include "support/catch.hpp"

using namespace symplant;
using link::record::Reading;

namespace {

/// Puts images of two symbols into a queue; both change in each.
class Putting {
 public:
  explicit Putting(record::ImageQueue& queue) : queue_(queue) {}

  void image(bool changes, bool reconnected = false) {
    for (Reading& reading : readings_) {
      reading.time = ++time_;
      reading.is_read = true;
      if (changes) ++reading.value;
    }
    queue_.image({readings_, reconnected});
  }

 private:
  record::ImageQueue& queue_;
  std::vector<Reading> readings_{{0}, {1}};
  tables::Time time_ = 0;
};

}  // namespace

TEST_CASE("The image after one that was dropped has what both changed, and says that one is missing") {
  record::ImageQueue queue(2, 8);
  Putting putting(queue);
  putting.image(true);
  putting.image(true);
  putting.image(true);  // no room
  const auto first = queue.take().batches;
  REQUIRE(first.size() == 2);
  CHECK_FALSE(first[1].after_loss);
  putting.image(false);
  putting.image(false);
  const auto next = queue.take().batches;
  REQUIRE(next.size() == 2);
  CHECK(next[0].after_loss);
  CHECK(next[0].lines.size() == 2);
  CHECK_FALSE(next[1].after_loss);
  CHECK(next[1].lines.empty());
}

TEST_CASE("A connection that was lost is not forgotten with a dropped image") {
  record::ImageQueue queue(2, 5);
  Putting putting(queue);
  putting.image(true);
  queue.lost();
  putting.image(false, true);  // no room
  CHECK(queue.take().is_lost);
  CHECK(queue.take().is_lost);
  putting.image(false);
  const auto taken = queue.take();
  CHECK_FALSE(taken.is_lost);
  REQUIRE(taken.batches.size() == 1);
  CHECK(taken.batches[0].after_loss);
}

TEST_CASE("Images without changes do not fill the memory") {
  record::ImageQueue queue(2, 100);
  Putting putting(queue);
  for (int i = 0; i < 1'000; ++i) putting.image(false);
  CHECK(queue.take().batches.size() < 50);
}
