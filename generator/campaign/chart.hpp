// The series of a run and of the base case that its chart shows.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "campaign/base_case.hpp"
#include "compare/difference.hpp"

namespace symplant::campaign {

/// A line of a chart: a symbol, or an output of a value.
struct Shown {
  bool is_output = false;
  std::uint32_t of = 0;

  friend bool operator==(const Shown&, const Shown&) = default;
};

/// The first few of what is added, each once.
class ChartChoice {
 public:
  void add(const Shown& one);
  const std::vector<Shown>& shown() const { return shown_; }
  std::size_t left_out() const { return left_out_.size(); }

 private:
  std::vector<Shown> shown_;
  std::set<std::pair<bool, std::uint32_t>> left_out_;
};

/// `{"series": [{"name", "kind", "base": [t, v, ...], "run": [...]}], "differences": [{"t", "to", "of", "words"}],
/// "end", "left_out", "cut"}` as JSON in one line, for page/campaign.js. O(changes of both runs).
std::string chart_of(const BaseCase& base, const RunLog& log, const compare::Comparison& comparison,
                     const trace::PlantNames& names, const ChartChoice& choice);

}  // namespace symplant::campaign
