// The operands that a Logix export names, with their comments and the operands of which they are parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/index_table.hpp"

namespace symplant::read {

/// Whether an operand is a part of a module's input or output tag: `Local:1:I.Data.0`, `Box:O1.Data[2].7`,
/// `Box:SI.Pt00`.
bool is_module_io(std::string_view operand);

/// Operands by number. They compare without regard to case; the first spelling is kept. O(length) for each operand.
class RockwellOperands {
 public:
  static constexpr std::uint32_t kNone = base::IndexTable::kNothing;

  struct Operand {
    std::string_view text;
    std::string_view comment;
    std::uint32_t parent = kNone;  ///< the operand of which it is a part; set by `parent_of`
    bool parent_known = false;
    bool comment_decoded = false;
    bool has_row = false;
    bool is_whole = false;  ///< the operand of a row is a part of it
  };

  /// Reserves room for `expected` operands.
  void reserve(std::size_t expected);

  /// The number of an operand, which is added if it is new. Its view must outlive this object.
  std::uint32_t number_of(std::string_view operand);
  Operand& operator[](std::uint32_t number) { return operands_[number]; }

  /// The operand without its last member, element or bit: `Box:I.Data[2]` for `Box:I.Data[2].7`. kNone for a tag, and
  /// for an operand of more than `kLongestOperand` characters.
  std::uint32_t parent_of(std::uint32_t number);

  /// Marks all operands of which an operand is a part.
  void mark_wholes(std::uint32_t number);

 private:
  std::vector<Operand> operands_;
  base::IndexTable numbers_;
};

}  // namespace symplant::read
