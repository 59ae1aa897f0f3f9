// The check after a guarded run.
#pragma once

#include "support/catch.hpp"
#include "symplant/exec/guard/guard.hpp"

namespace symplant::test {

using exec::GuardReport;
using exec::run_guarded;

/// If system calls cannot be trapped, the run checks less than it should: ctest then reports the test as skipped
/// (tests/rt/CMakeLists.txt), unless it failed already.
inline void expect_trap(const GuardReport& report) {
  if (!report.no_trap.empty()) WARN("SKIPPED: no trap of system calls here: " << report.no_trap);
}

inline void expect_nothing(const GuardReport& report) {
  INFO(report.text());
  REQUIRE(report.count == 0);
  expect_trap(report);
}

}  // namespace symplant::test
