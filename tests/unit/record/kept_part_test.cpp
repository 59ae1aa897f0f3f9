// What is kept from before the start.
#include "record/kept_part.hpp"

#include "support/catch.hpp"

using namespace symplant::record;

namespace {

constexpr std::uint32_t kA = 0;
constexpr std::uint32_t kB = 1;

}  // namespace

TEST_CASE("The values at the beginning of the kept part follow the changes that are too old") {
  KeptPart kept(2, 100);
  kept.add({{1000, 1, kA}}, 1000);
  CHECK(kept.begin() == 1000);
  CHECK(kept.value(kA) == 1);
  CHECK(kept.lines().empty());
  kept.add({{1050, 0, kA}, {1060, 7, kB}}, 1060);
  CHECK(kept.begin() == 1000);
  CHECK(kept.value(kA) == 1);
  CHECK_FALSE(kept.is_known(kB));
  CHECK(kept.lines().size() == 2);
  kept.add({}, 1155);
  CHECK(kept.begin() == 1055);
  CHECK(kept.value(kA) == 0);
  CHECK_FALSE(kept.is_known(kB));
  CHECK(kept.lines().size() == 1);
  kept.add({}, 1160);
  CHECK(kept.is_known(kB));
  CHECK(kept.value(kB) == 7);
  CHECK(kept.lines().empty());
}

TEST_CASE("A gap over the beginning of the kept part is known") {
  KeptPart kept(1, 100);
  kept.add({{1000, 1, kA}}, 1000);
  kept.add({{1000, 150, Line::kGap}}, 1150);
  kept.add({{1150, 0, kA}}, 1150);
  CHECK(kept.begin() == 1050);
  CHECK(kept.gap_end() == 1150);
  kept.add({}, 1260);
  CHECK(kept.gap_end() < kept.begin());
}

TEST_CASE("More changes than there is room for shorten the kept part") {
  KeptPart kept(2, 1'000'000, 3);
  for (Time time = 1; time <= 10; ++time) kept.add({{time, static_cast<std::uint64_t>(time), kA}}, time);
  CHECK(kept.is_shortened());
  CHECK(kept.lines().size() == 3);
  CHECK(kept.begin() == 7);
  CHECK(kept.value(kA) == 7);
  CHECK(kept.lines().front().value == 8);
}

TEST_CASE("Without a length the kept part has the values of the latest image") {
  KeptPart kept(2, 0);
  kept.add({{10, 1, kA}, {12, 5, kB}}, 12);
  CHECK(kept.begin() == 12);
  CHECK(kept.is_known(kA));
  CHECK(kept.value(kB) == 5);
  CHECK(kept.lines().empty());
}
