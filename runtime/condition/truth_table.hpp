// Conditions in the engine's form: truth tables of at most six inputs, or networks of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "symplant/condition/tree.hpp"

namespace symplant::condition {

inline constexpr std::size_t kMostInputs = 6;

/// An input of a truth table: an atom, or another table of the network.
struct Input {
  bool is_table = false;
  std::uint32_t table = 0;  ///< index in the network; it is less than that of its reader
  Atom atom;
};

/// Bit i of `truth` is the value if input k is bit k of i; bits beyond 2^inputs are 0. The truth depends on every
/// input; without inputs it is a constant.
struct TruthTable {
  std::uint64_t truth = 0;
  std::vector<Input> inputs;  ///< at most kMostInputs, no atom twice in one table
};

/// The tables of a condition; the last one is the truth of the whole. There is only one if the condition has at most
/// kMostInputs different atoms. Every other table has one reader and is not a constant. The depth grows with the
/// logarithm of the tree's width. O(tree), some hundred steps per atom.
std::vector<TruthTable> truth_tables(const Tree& tree);

}  // namespace symplant::condition
