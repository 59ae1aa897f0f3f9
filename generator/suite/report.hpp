// The forms in which the results of a suite are shown.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>

#include "base/text_source.hpp"
#include "suite/result.hpp"

namespace symplant::suite {

/// `passed start`, or `FAILED start`, with the messages indented.
void write_result(const Result& result, std::ostream& out);

/// How many results of each kind.
struct Counts {
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::size_t errors = 0;
  std::size_t without_reference = 0;
  std::size_t written = 0;  ///< reference traces
  std::size_t missing = 0;  ///< of the whole suite, in no file

  void add(const Result& result);
  bool well() const { return failed + errors + missing == 0; }
};
/// `12 cases: 10 passed, 1 failed, 1 error; 2 have no reference trace`
std::string summary(const Counts& counts);

/// Which cases of the suite have no result, for a message; empty: none is counted as missing.
std::string missing_text(const Results& results, const Counts& counts);
/// A test case for each result, for build servers, and an error if results are missing.
std::string junit_text(const Results& results, const Counts& counts);
/// All results, each with its chart: one page that needs no network.
void write_html(const Results& results, const Counts& counts, base::TextSink& sink);

}  // namespace symplant::suite
