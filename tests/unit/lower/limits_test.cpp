// What the engine's tables cannot hold is told.
#include "lower/limits.hpp"

#include "support/catch.hpp"

namespace symplant::test {
namespace {

TEST_CASE("The largest plant is told nothing") {
  CHECK(lower::beyond_limits({8'388'607, 2'147'483'647, 2'147'483'647}) == "");
  CHECK(lower::beyond_limits({0, 0, 0}) == "");
}

TEST_CASE("One type or bit more is told, and how many there may be") {
  CHECK(lower::beyond_limits({8'388'608, 64, 64}) ==
        "the plant has 8388608 types of devices, and 8388607 are the most: make several plants of it");
  CHECK(lower::beyond_limits({1, 2'147'483'648, 64}) ==
        "the plant has 2147483648 bits of operations, and 2147483647 are the most: make several plants of it");
  CHECK(lower::beyond_limits({1, 64, 2'147'483'648}) ==
        "the plant has 2147483648 bits of events, and 2147483647 are the most: make several plants of it");
}

TEST_CASE("Tables beyond a limit are an error, others none") {
  lower::EngineTables tables;
  diag::Diagnostics diagnostics;
  lower::check_limits(tables, diagnostics);
  CHECK_FALSE(diagnostics.has_errors());
  tables.event_bits = 0x8000'0000;
  lower::check_limits(tables, diagnostics);
  CHECK(diagnostics.has_errors());
}

}  // namespace
}  // namespace symplant::test
