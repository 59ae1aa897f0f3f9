// The forced end of a run, while files are opened and closed.
#include "symplant/host/last_resort.hpp"

#include <chrono>
#include <csignal>
#include <fstream>
#include <string>

#include "support/catch.hpp"
#include "symplant/host/signals.hpp"

namespace symplant::test {
namespace {

TEST_CASE("Files opened and closed while a run ends are not taken for blocked output, and cause no race") {
  using Clock = std::chrono::steady_clock;
  host::catch_signals();
  {
    host::LastResort resort;
    resort.begun();
    std::raise(SIGTERM);
    std::size_t read = 0;
    for (const auto end = Clock::now() + std::chrono::milliseconds(800); Clock::now() < end;) {
      std::string line;
      read += std::getline(std::ifstream("/proc/self/maps"), line) ? 1U : 0U;
    }
    CHECK(read > 0);  // the run was not ended by force
  }
  CHECK(host::stop_requested().load());
  host::catch_signals();
}

}  // namespace
}  // namespace symplant::test
