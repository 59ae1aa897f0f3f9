// What time is proposed for durations.
#include "learn/proposal.hpp"

#include <string>
#include <vector>

#include "learn_support.hpp"

namespace symplant::test {
namespace {

std::vector<tables::Time> times(const std::vector<int>& durations) {
  std::vector<tables::Time> all;
  for (const int duration : durations) all.push_back(duration * kMilli);
  return all;
}

std::string proposed(const std::vector<int>& durations, int resolution = 0) {
  return learn::duration_words(learn::proposal_of(times(durations), resolution * kMilli));
}

TEST_CASE("Figures are given to the power of ten that is at most the resolution") {
  CHECK(learn::digit_of(0) == 1);
  CHECK(learn::digit_of(1) == 1);
  CHECK(learn::digit_of(9 * kMilli) == kMilli);
  CHECK(learn::digit_of(10 * kMilli) == 10 * kMilli);
  CHECK(learn::digit_of(50 * kMilli) == 10 * kMilli);
  CHECK(learn::rounded(814 * kMilli, 10 * kMilli) == 810 * kMilli);
  CHECK(learn::rounded(815 * kMilli, 10 * kMilli) == 820 * kMilli);
}

TEST_CASE("Durations within 2 resolutions are a constant, their mean") {
  CHECK(proposed({800, 800, 850, 850, 850, 900}, 50) == "0.84 s");
  CHECK(proposed({800, 850, 901}, 50) == "0.8 s to 0.9 s");
}

TEST_CASE("Durations within 1 % are a constant") {
  CHECK(proposed({990, 1000}) == "0.995 s");
  CHECK(proposed({989, 1000}) == "0.989 s to 1 s");
  CHECK(proposed({812, 812, 812}) == "0.812 s");
}

TEST_CASE("A range is rounded to the inside") {
  CHECK(proposed({803, 1199}, 50) == "0.81 s to 1.19 s");
  CHECK(proposed({803, 1199}) == "0.803 s to 1.199 s");
}

TEST_CASE("Statistics are rounded, and 95 % do not exceed p95") {
  std::vector<int> durations;
  for (int i = 1; i <= 20; ++i) durations.push_back(100 * i + 3);
  const learn::Statistics of = learn::statistics_of(times(durations), 50 * kMilli);
  CHECK(of.count == 20);
  CHECK(of.min == 100 * kMilli);
  CHECK(of.median == 1050 * kMilli);
  CHECK(of.p95 == 1900 * kMilli);
  CHECK(of.max == 2000 * kMilli);
  CHECK(learn::statistics_of(times({7}), 0).p95 == 7 * kMilli);
}

TEST_CASE("An overrun has a margin of 20 %, 2 resolutions and 100 ms, whichever is more") {
  const auto overrun = [](const std::vector<int>& durations, int resolution) {
    return learn::duration_words(learn::overrun_of(times(durations), resolution * kMilli));
  };
  CHECK(overrun({100, 1000}, 0) == "1.2 s");
  CHECK(overrun({100, 200}, 0) == "0.3 s");
  CHECK(overrun({100, 200}, 100) == "0.4 s");
}

}  // namespace
}  // namespace symplant::test
