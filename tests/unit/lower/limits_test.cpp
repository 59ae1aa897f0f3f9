// Plants that exceed the engine's tables are reported.
#include "lower/limits.hpp"

#include "support/catch.hpp"

namespace symplant::test {
namespace {

TEST_CASE("The largest plant has no finding") {
  CHECK(lower::beyond_limits({8'388'607, 2'147'483'647, 2'147'483'647}) == "");
  CHECK(lower::beyond_limits({0, 0, 0}) == "");
}

TEST_CASE("One type or bit more is reported, with the limit") {
  CHECK(lower::beyond_limits({8'388'608, 64, 64}) ==
        "the plant has 8388608 types of devices, but at most 8388607 are supported; split it into several plants");
  CHECK(lower::beyond_limits({1, 2'147'483'648, 64}) ==
        "the plant has 2147483648 bits of operations, but at most 2147483647 are supported; split it into several "
        "plants");
  CHECK(lower::beyond_limits({1, 64, 2'147'483'648}) ==
        "the plant has 2147483648 bits of events, but at most 2147483647 are supported; split it into several plants");
}

TEST_CASE("Tables above a limit are an error, others are not") {
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
