// Conditions as the engine has them: truth tables of at most six inputs, larger ones as networks of such.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "symplant/condition/tree.hpp"

namespace symplant::condition {

inline constexpr std::size_t kMostInputs = 6;

/// Something that is true or false: an atom, or another table of the network.
struct Input {
  bool is_table = false;
  std::uint32_t table = 0;  ///< place in the network; it stands before its reader
  Atom atom;
};

/// Bit i of `truth` is the value where input k is bit k of i; bits that no input reaches are 0. The truth depends on
/// each of the inputs: without any it is a constant.
struct TruthTable {
  std::uint64_t truth = 0;
  std::vector<Input> inputs;  ///< at most kMostInputs, no atom twice within one table
};

/// The tables of a condition, the one of its whole truth last: just one where it has at most kMostInputs different
/// atoms. Each but the last has one reader, and none but the last is a constant. Their depth grows with the logarithm
/// of a wide tree. O(tree), with some hundred steps an atom.
std::vector<TruthTable> truth_tables(const Tree& tree);

}  // namespace symplant::condition
