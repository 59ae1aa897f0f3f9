// A server link that a malfunction cuts.
#include "unit/link/loss_bench.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A cut link closes its connections and answers nothing, afterwards it works again") {
  LossBench bench;
  bench.write_coil(0, true);
  bench.cycle();
  REQUIRE(bench.link->state() == LinkState::live);
  bench.link->cut(true);
  CHECK(bench.client->is_closed());
  RawClient other(port_of(*bench.link));
  CHECK(other.ask({1, 0, 0, 0, 1}).empty());
  bench.silence(2 * kSecond);
  CHECK(bench.link->state() == LinkState::lost);
  CHECK(bench.link->status().connections == 0);
  CHECK(bench.a());
  bench.link->cut(false);
  bench.client = std::make_unique<RawClient>(port_of(*bench.link));
  bench.write_coil(0, false);
  bench.cycle();
  CHECK(bench.link->state() == LinkState::live);
  CHECK_FALSE(bench.a());
}

}  // namespace
}  // namespace symplant::test
