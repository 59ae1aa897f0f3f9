// Parts of a run.
#include "batch/shard.hpp"

#include "support/catch.hpp"

namespace symplant::batch {
namespace {

TEST_CASE("A part is I/N, with I from 1 to N") {
  const auto part = shard_of("2/8");
  REQUIRE(part);
  CHECK(part->index == 2);
  CHECK(part->count == 8);
  CHECK(part->has(1));
  CHECK(part->has(9));
  CHECK_FALSE(part->has(2));
  for (const char* text : {"", "2", "2/", "/8", "0/8", "9/8", "2/8x", "-1/8", "a/b", "1/0"})
    CHECK_FALSE(shard_of(text));
}

}  // namespace
}  // namespace symplant::batch
