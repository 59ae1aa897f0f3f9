// Chooses the candidates that pair most together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "infer/candidates.hpp"
#include "infer/evaluate.hpp"

namespace symplant::infer {

/// The rules chosen, in the order in which they apply.
struct Choice {
  std::vector<name::SymbolRule> rules;
  name::Counts score;
  std::vector<std::string> steps;  ///< what was chosen and why, for --verbose
};

/// What the search begins with.
struct Start {
  std::size_t devices = SIZE_MAX;  ///< index of a candidate that is always chosen, since archetypes may join its tasks
  bool devices_first = true;       ///< rules of devices apply before those of motions
};

/// Adds the candidate that pairs most, again and again, until none pairs more. The readings of all candidates are made
/// once. O(samples * candidates * rounds).
class Search {
 public:
  /// `frame` is a naming rule without rules. Candidates and samples must outlive the search.
  Search(const name::Naming& frame, const std::vector<Candidate>& candidates, std::span<const Sample> samples);

  Choice run(Start start) const;

 private:
  std::vector<std::size_t> with(const std::vector<std::size_t>& chosen, std::size_t candidate,
                                bool devices_first) const;
  void add_best(std::vector<std::size_t>& chosen, std::vector<std::size_t> open, bool devices_first,
                Choice& choice) const;
  name::Counts score_of(const std::vector<std::size_t>& order) const;
  bool better(const name::Counts& a, const name::Counts& b) const;

  const std::vector<Candidate>& candidates_;
  std::span<const Sample> samples_;
  std::vector<std::size_t> first_rule_;  ///< of each candidate
  std::shared_ptr<const name::CompiledNaming> naming_;
  std::unique_ptr<name::SymbolReader> reader_;
  std::vector<std::vector<name::Reading>> readings_;  ///< by rule, then by sample
};

}  // namespace symplant::infer
