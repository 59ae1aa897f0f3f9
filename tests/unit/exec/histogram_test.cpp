// Compares the histogram with sorted lists: quantiles within 1.6 %, extremes exact.
#include "symplant/exec/histogram.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include "support/catch.hpp"
#include "symplant/exec/cycle_meter.hpp"

using namespace symplant;
using exec::Durations;
using exec::Histogram;
using tables::Time;

namespace {

/// The smallest value that at least `per_thousand` of all values do not exceed.
Time quantile(std::vector<Time> values, std::size_t per_thousand) {
  std::sort(values.begin(), values.end());
  return values[(values.size() * per_thousand + 999) / 1000 - 1];
}

void check_close(Time found, Time exact) {
  CHECK(found >= exact);
  CHECK(found - exact <= exact / 64);
}

TEST_CASE("An empty histogram is all 0") {
  const Durations durations = Histogram().durations();
  CHECK(durations.count == 0);
  CHECK(durations.p50 == 0);
  CHECK(durations.p999 == 0);
  CHECK(durations.max == 0);
}

TEST_CASE("One duration is every quantile, exactly, from 0 to the longest duration") {
  for (const Time time :
       {Time{0}, Time{1}, Time{63}, Time{64}, Time{65}, Time{1'000'003}, tables::kNever - 1, tables::kNever}) {
    Histogram histogram;
    histogram.add(time);
    const Durations durations = histogram.durations();
    CHECK(durations.count == 1);
    CHECK(durations.p50 == time);
    CHECK(durations.p999 == time);
    CHECK(durations.max == time);
  }
}

TEST_CASE("A negative duration counts as 0") {
  Histogram histogram;
  histogram.add(-5);
  CHECK(histogram.durations().count == 1);
  CHECK(histogram.durations().max == 0);
}

TEST_CASE("The p99.9 of 1000 values is the 999th, of 1001 values the 1000th") {
  Histogram histogram;
  for (Time time = 0; time < 60; ++time) histogram.add(0);
  for (Time time = 60; time < 998; ++time) histogram.add(1);
  histogram.add(2);
  histogram.add(3);
  CHECK(histogram.durations().p999 == 2);
  histogram.add(4);
  CHECK(histogram.durations().p999 == 3);
  CHECK(histogram.durations().max == 4);
}

TEST_CASE("Quantiles exceed those of the sorted list by at most 1/64, at every scale") {
  std::mt19937_64 random(7);
  for (int scale = 1; scale < 63; scale += 3) {
    Histogram histogram;
    std::vector<Time> values;
    for (int i = 0; i < 2000; ++i) {
      values.push_back(static_cast<Time>(random() >> (64 - scale)));
      histogram.add(values.back());
    }
    const Durations durations = histogram.durations();
    CHECK(durations.count == values.size());
    check_close(durations.p50, quantile(values, 500));
    check_close(durations.p99, quantile(values, 990));
    check_close(durations.p999, quantile(values, 999));
    CHECK(durations.max == *std::max_element(values.begin(), values.end()));
  }
}

TEST_CASE("The meter keeps the state of each link separately") {
  exec::CycleMeter meter;
  for (std::size_t link = 0; link < exec::CycleMeter::kMostLinks; ++link) {
    meter.note(link, link % 2 == 0 ? exec::LinkState::lost : exec::LinkState::live);
  }
  meter.note(4, exec::LinkState::waiting);
  meter.note(exec::CycleMeter::kMostLinks, exec::LinkState::lost);  // one link too many: not kept
  CHECK(meter.state(0) == exec::LinkState::lost);
  CHECK(meter.state(3) == exec::LinkState::live);
  CHECK(meter.state(4) == exec::LinkState::waiting);
  CHECK(meter.state(31) == exec::LinkState::live);
}

}  // namespace
