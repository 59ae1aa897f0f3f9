// Rules that may explain a list, found by looking at its words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "infer/words.hpp"
#include "name/naming.hpp"

namespace symplant::infer {

/// What a candidate is about; rules are tried in this order.
enum class CandidateKind : std::uint8_t {
  devices,     ///< devices named by a number, with any tasks
  motions,     ///< devices with a motion
  difference,  ///< two texts that differ in known words
  others,      ///< equal texts: only where nothing else pairs them, because the device level is coarse
};

/// One or two rules that belong together.
struct Candidate {
  CandidateKind kind = CandidateKind::motions;
  std::vector<name::SymbolRule> rules;
  std::size_t support = 0;  ///< samples that it seems to fit
  std::string why;          ///< for --verbose: "`sol` is on operations (120 of 120), `ls` on events (210 of 212)"
};

/// `words` are those of the samples' texts of one source. The strongest first within a kind. O(words).
std::vector<Candidate> candidates_of(const std::vector<SampleWords>& words, name::Source source,
                                     const name::Vocabulary& vocabulary);

/// Rules that take the device from the name and the task from the comment. `comments` are the words of the comments.
std::vector<Candidate> two_source_candidates(const std::vector<SampleWords>& comments,
                                             const name::Vocabulary& vocabulary);

}  // namespace symplant::infer
