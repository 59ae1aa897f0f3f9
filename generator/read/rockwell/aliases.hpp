// Resolves aliases of Logix tags to the operands that they name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "base/index_table.hpp"
#include "base/large_memory.hpp"

namespace symplant::read {

/// Operands beyond this length are not composed: no tag has them, and long chains must not fill the memory.
inline constexpr std::size_t kLongestOperand = 255;

/// An operand (`I_Rack.3`, `Local:9:I.Data[12].8`) in its two parts.
struct OperandParts {
  std::string_view base;  ///< the tag's name
  std::string_view tail;  ///< members, elements and bits: begins with `.` or `[`, or is empty
};
OperandParts split_operand(std::string_view operand);

/// Knows all tags of a controller and resolves operands through chains of aliases: with `Box:1:I` an alias of
/// `Box:I.Data[1]`, the operand `Box:1:I.3` is `Box:I.Data[1].3`. Names compare without regard to case. An operand is
/// looked up in its program first, then in the controller. All views must outlive the resolver. O(length) for each
/// operand and alias, over all calls.
class AliasResolver {
 public:
  enum class Outcome : std::uint8_t {
    tag,          ///< the base is a tag that is no alias
    unknown_tag,  ///< no row declares the base, as is usual for the tags of modules
    cycle,        ///< the alias leads to itself, or to an alias that does
    too_long,     ///< the operand would be longer than `kLongestOperand`
  };
  struct Operand {
    std::string_view text;  ///< resolved; as written if the outcome is `cycle` or `too_long`
    Outcome outcome;
  };

  /// Composed operands are kept in `arena`. Reserves room for `expected` tags.
  explicit AliasResolver(std::deque<std::string>& arena, std::size_t expected = 0) : arena_(arena), by_name_(expected) {
    base::reserve_large(tags_, expected);
  }

  /// Declares a tag; `target` is empty if it is no alias. `scope` is its program, empty for the controller. Returns
  /// false, without effect, if the scope has a tag of that name. All tags are declared before the first `resolve`.
  bool add(std::string_view scope, std::string_view name, std::string_view target = {});

  /// An operand as written in a scope. A tag of a program is resolved to `\SCOPE.NAME`, as Logix writes it.
  Operand resolve(std::string_view scope, std::string_view operand);

 private:
  enum class State : std::uint8_t { open, followed, done };
  struct Tag {
    std::string_view scope;
    std::string_view name;
    std::string_view target;
    Operand resolved{};
    State state = State::open;
  };

  std::uint32_t find(std::string_view scope, std::string_view name) const;
  std::uint32_t find_visible(std::string_view scope, std::string_view name) const;
  Operand of_tag(std::uint32_t tag);
  Operand of_base(const Tag& tag);
  Operand joined(const Operand& base, std::string_view tail, std::string_view written);

  std::deque<std::string>& arena_;
  std::vector<Tag> tags_;
  std::vector<std::uint32_t> path_;  ///< the aliases that are followed
  base::IndexTable by_name_;
};

}  // namespace symplant::read
