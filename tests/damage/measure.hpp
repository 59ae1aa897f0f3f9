// Damages a list again and again, has it checked, and counts what is found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "damage/kinds.hpp"

namespace symplant::damage {

/// One damaged copy, checked.
struct Trial {
  bool found = false;        ///< the rule told of one of the roots
  std::size_t findings = 0;  ///< beyond those of the clean list
  std::size_t others = 0;    ///< of these: by another rule, or of another row
  std::string reported;      ///< the findings, a line each, for whoever has to look
};

/// The findings of a list before it was damaged.
class Clean {
 public:
  explicit Clean(const ShopList& list);
  Trial compare(const Kind& kind, const Damaged& damaged) const;

 private:
  std::vector<std::string> findings_;  ///< sorted
};

/// Of all copies damaged in one way.
struct Figures {
  const Kind* kind = nullptr;
  std::size_t copies = 0;
  std::size_t found = 0;
  std::size_t findings = 0;
  std::size_t others = 0;
  std::string missed;  ///< what was told where it was not found, or where others were
};

/// `copies` of each kind, each by a seed of its own.
std::vector<Figures> measure(const Shop& shop, std::size_t copies, std::uint64_t seed);

/// The table of the manual: a row a kind, and the sum.
std::string table(const std::vector<Figures>& all);

}  // namespace symplant::damage
