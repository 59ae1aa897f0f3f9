// Proposes cases for a suite: each does what a base case does, and one thing more.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "suite/run_case.hpp"

namespace symplant::suite {

/// What the base case did.
struct BaseRun {
  /// Something that its scenario did to the plant.
  struct Act {
    tables::Time time;
    std::string members;  ///< of a step: `"set":{"X":true}`
  };
  std::vector<Act> acts;             ///< by time
  std::vector<tables::Time> phases;  ///< a time within each different pattern of operations, ascending
  std::map<std::string, std::vector<tables::Time>> toggles;  ///< when BOOL events changed, which are off at first
  tables::Time end = 0;
  std::vector<std::uint64_t> pairs;  ///< state_pairs()
};

/// A case that could be added.
struct Proposal {
  enum class Kind : std::uint8_t { press, restart, state, malfunction };
  Kind kind;
  std::string name;   ///< `restart-in-phase-3`
  std::string words;  ///< `restart of the program in phase 3 (5.5 s)`
  std::string text;   ///< of its scenario
};

/// Runs a scenario like a case, in this process. `folder` may be used for files. False, with `error` set, if it fails.
bool run_base(const Setup& setup, const host::PlantProgram& plant, const std::string& scenario,
              const std::string& folder, BaseRun& base, std::string& error);

/// All cases that are proposed for a base case, in a fixed order: each input that no device drives changed for 500 ms
/// in each phase, the program restarted in each phase (`with_program`), each device at first in each other state, each
/// malfunction alone.
std::vector<Proposal> proposals_of(const BaseRun& base, const std::string& name, const tables::PlantTables& tables,
                                   bool with_program);

/// At most `most` proposals, spread evenly over each kind. A kind with few proposals keeps all of them.
std::vector<Proposal> spread(std::vector<Proposal> all, std::size_t most);

/// The pairs of a proposed scenario that the base case does not have; none if it cannot run. Runs in this process,
/// which ends if a program crashes.
std::vector<std::uint64_t> new_pairs(const Setup& setup, const host::PlantProgram& plant, const Proposal& proposal,
                                     const BaseRun& base, const std::string& folder);

/// The numbers of the proposals to keep, at most `most`: those with most pairs that neither the base case nor an
/// earlier one has come first, then the others in their order.
std::vector<std::size_t> choose(const std::vector<std::vector<std::uint64_t>>& pairs, std::size_t most);

}  // namespace symplant::suite
