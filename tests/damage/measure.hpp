// Damages a list repeatedly, checks each copy, and counts the findings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "damage/kinds.hpp"

namespace symplant::damage {

/// One damaged copy and its check results.
struct Trial {
  bool found = false;        ///< the rule reported one of the roots
  std::size_t findings = 0;  ///< in addition to those of the clean list
  std::size_t others = 0;    ///< of these: by another rule, or at another row
  std::string reported;      ///< the findings, one per line, for inspection
};

/// The findings of the undamaged list.
class Clean {
 public:
  explicit Clean(const ShopList& list);
  Trial compare(const Kind& kind, const Damaged& damaged) const;

 private:
  std::vector<std::string> findings_;  ///< sorted
};

/// The counts of all copies with one kind of damage.
struct Figures {
  const Kind* kind = nullptr;
  std::size_t copies = 0;
  std::size_t found = 0;
  std::size_t findings = 0;
  std::size_t others = 0;
  std::string missed;  ///< what was reported instead, or in addition
};

/// `copies` of each kind, each with a separate seed.
std::vector<Figures> measure(const Shop& shop, std::size_t copies, std::uint64_t seed);

/// The table of the manual: a row for each kind, and the total.
std::string table(const std::vector<Figures>& all);

}  // namespace symplant::damage
