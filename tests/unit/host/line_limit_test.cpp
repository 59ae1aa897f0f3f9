// How often lines about one subject are shown.
#include "symplant/host/line_limit.hpp"

#include "support/catch.hpp"

namespace symplant::test {
namespace {

using host::LineLimit;
using std::chrono::seconds;

constexpr LineLimit::Clock::time_point kBegin{seconds(1000)};

TEST_CASE("Five lines are shown in ten seconds, and the number of the others afterwards") {
  LineLimit limit;
  for (int i = 0; i < 5; ++i) CHECK(limit.admits(kBegin + seconds(i)));
  for (int i = 5; i < 8; ++i) CHECK_FALSE(limit.admits(kBegin + seconds(i)));
  CHECK(limit.take_hidden(kBegin + seconds(9), false) == 0);
  CHECK(limit.take_hidden(kBegin + seconds(10), false) == 3);
  CHECK(limit.take_hidden(kBegin + seconds(11), false) == 0);
  CHECK(limit.admits(kBegin + seconds(11)));
}

TEST_CASE("The end of the run does not wait for the ten seconds") {
  LineLimit limit;
  for (int i = 0; i < 6; ++i) limit.admits(kBegin);
  CHECK(limit.take_hidden(kBegin, true) == 1);
  CHECK(limit.take_hidden(kBegin, true) == 0);
}

}  // namespace
}  // namespace symplant::test
