// The conditions of a plant's tables, as networks of truth tables whose inputs have names.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/condition/truth_table.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::why {

/// As condition::truth_tables() makes it: the last table is the truth of the whole.
using Network = std::vector<condition::TruthTable>;

class Conditions {
 public:
  /// O(conditions + watches).
  explicit Conditions(const tables::PlantTables& tables);

  /// The network of a condition. O(its inputs).
  Network network(std::uint32_t condition) const;

 private:
  /// An input of a condition: an atom, or another condition.
  struct Wire {
    std::uint32_t condition = 0;
    std::uint8_t input = 0;
    condition::Input from;
  };

  std::uint32_t add(std::uint32_t condition, Network& network) const;

  const tables::PlantTables& tables_;
  std::vector<Wire> wires_;  ///< sorted by condition and input
};

}  // namespace symplant::why
