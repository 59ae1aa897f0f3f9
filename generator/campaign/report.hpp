// The forms in which the results of a campaign are shown.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "base/text_source.hpp"
#include "campaign/result.hpp"

namespace symplant::campaign {

/// How many results of each class, and those that there are, worst first.
struct Overview {
  std::array<std::size_t, kClasses> counts{};
  std::size_t not_run = 0;           ///< of `no effect`: the base case shows them
  std::size_t missing = 0;           ///< have no result
  std::vector<std::size_t> numbers;  ///< of the results, worst first, then in the order of the faults

  std::size_t count(Class one) const { return counts[static_cast<std::size_t>(one)]; }
};
/// Reads each result once.
Overview overview_of(const Results& results);

/// `12 faults: 1 violated, 2 undetected, ...`
std::string summary(const Overview& overview);

/// Classes that make a campaign fail.
using Classes = std::bitset<kClasses>;
/// Whether a result has such a class or is an error, or results are missing.
bool fails(const Overview& overview, const Classes& fail_on);

/// The first results of each class, at most `most`, as a table for a terminal, worst first; none without effect.
void write_table(const Results& results, const Overview& overview, std::size_t most, std::ostream& out);
/// A row for each result, worst first, with a header.
void write_csv(const Results& results, const Overview& overview, base::TextSink& sink);
/// A test case for each result, for build servers, and an error if results are missing.
std::string junit_text(const Results& results, const Overview& overview, const Classes& fail_on);
/// All results as one page that needs no network, each with the chart of its run.
void write_html(const Results& results, const Overview& overview, base::TextSink& sink);

}  // namespace symplant::campaign
