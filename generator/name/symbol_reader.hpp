// Reads symbols by a naming rule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "name/compiled_naming.hpp"
#include "name/reading.hpp"

namespace symplant::name {

/// What one rule says of a symbol, tried alone.
struct RuleTrial {
  enum class End : std::uint8_t {
    reads,        ///< it matches
    other_side,   ///< its side is not that of the address
    pattern,      ///< a pattern does not match
    word_absent,  ///< none of its words is in the text
  };
  End end{};
  std::size_t pattern = 0;  ///< index of the first pattern that does not match
};

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

  /// Each rule on a symbol, up to the first that reads it. O(rules) readings: for explaining one symbol.
  std::vector<RuleTrial> trials(const SymbolText& symbol);
  /// The text of the name, or of the comment, as patterns see it.
  std::string normal_text(const SymbolText& symbol, Source source);

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
