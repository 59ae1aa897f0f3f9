// Reads symbols by a naming rule.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "name/compiled_naming.hpp"
#include "name/rule_reading.hpp"

namespace symplant::name {

/// Reads the symbols of all lists of a plant. Keeps the texts of its readings. Not thread-safe.
class SymbolReader {
 public:
  explicit SymbolReader(std::shared_ptr<const CompiledNaming> naming);
  ~SymbolReader();
  SymbolReader(const SymbolReader&) = delete;
  SymbolReader& operator=(const SymbolReader&) = delete;

  /// O(text) for usual patterns; at worst O(text squared * pattern). Does not throw, whatever the texts hold.
  RuleReading read(const SymbolText& symbol);

  /// Reads by one rule, as if it were the only one; `no_rule` if it does not match.
  RuleReading read_by(std::size_t rule, const SymbolText& symbol);

  const CompiledNaming& naming() const;
  /// How many symbols each rule matched so far, by index in Naming::rules.
  const std::vector<std::size_t>& matched() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace symplant::name
