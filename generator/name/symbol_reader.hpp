// Reads symbols by a naming rule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "name/compiled_naming.hpp"
#include "name/reading.hpp"

namespace symplant::name {

/// Reads the symbols of all lists of a plant, under every rule. Keeps what its readings point to, except that levels of
/// exact rules may be parts of the symbol's name. Not thread-safe.
class SymbolReader {
 public:
  explicit SymbolReader(std::shared_ptr<const CompiledNaming> naming);
  ~SymbolReader();
  SymbolReader(const SymbolReader&) = delete;
  SymbolReader& operator=(const SymbolReader&) = delete;

  /// O(text) for exact rules and usual patterns; at worst O(text squared * pattern). Does not throw, whatever the texts
  /// hold.
  Reading read(const SymbolText& symbol);

  /// Reads by one rule, as if it were the only one; `no_rule` if it does not match.
  Reading read_by(std::size_t rule, const SymbolText& symbol);

  const CompiledNaming& naming() const;
  /// How many symbols each rule matched so far, by index in Naming::rules.
  const std::vector<std::size_t>& matched() const;
  /// How many devices the symbols so far name.
  std::uint32_t devices() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace symplant::name
