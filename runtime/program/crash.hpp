// Reports a program that crashes.
#pragma once

#include <cstdint>

#include "symplant/tables/time.hpp"

namespace symplant::program {

/// While one exists, a signal that ends the process (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) in a call of a program
/// is reported: "program `cell` ended by SIGSEGV in scan 812 (8.12 s)" on standard error, then the process ends with
/// exit code 3. At any other time the signal does what it did before. At most one may exist.
class CrashReport {
 public:
  CrashReport();
  CrashReport(const CrashReport&) = delete;
  CrashReport& operator=(const CrashReport&) = delete;
  ~CrashReport();
};

/// While one exists, a call of a program that takes over ten seconds of wall time ends the process with exit code 3 and
/// "program `cell` does not return in scan 812 (8.12 s) after 10 s". At most one may exist, also together with a
/// CrashReport.
class CallLimit {
 public:
  CallLimit();
  CallLimit(const CallLimit&) = delete;
  CallLimit& operator=(const CallLimit&) = delete;
  ~CallLimit();
};

/// Marks during its lifetime that this thread calls a program, for CrashReport and CallLimit. Costs a few stores.
class Called {
 public:
  /// A scan; -1: the start or end of the program. `name` must outlive it.
  Called(const char* name, std::int64_t scan, tables::Time now) noexcept;
  Called(const Called&) = delete;
  Called& operator=(const Called&) = delete;
  ~Called();
};

}  // namespace symplant::program
