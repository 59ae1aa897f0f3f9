// Patterns of names: `{process}_{class}_{device...}_{task:known}`, parsed by Boost.Spirit X3 and run by an automaton.
//
// A separator in a pattern matches any run of separators, and none at the ends of the text. `{field}` is the shortest
// run within a word that fits, `{field...}` one of any words, `*` any run, also an empty one, `(A|B)` one of its
// alternatives, `\` quotes the next character. All else matches itself, without regard to case.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "name/pattern_fault.hpp"
#include "name/prepared_text.hpp"

namespace symplant::name {

/// The fields that a pattern may have. Only archetypes have `x`.
enum class Field : std::uint8_t { line, process, device, direction, klass, task, x };
inline constexpr std::size_t kFields = 7;
std::string_view field_name(Field field);

/// Where a field of a pattern lies in a text.
struct Capture {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  bool set = false;
  bool fused = false;  ///< no separator follows it in the pattern

  bool empty() const { return begin == end; }
};
using Captures = std::array<Capture, kFields>;

/// Decides whether a run of a text may be a field.
class FieldTest {
 public:
  virtual ~FieldTest() = default;
  /// `known`: the field must be a word of the vocabulary; `fused`: no separator follows it in the pattern.
  virtual bool fits(Field field, const PreparedText& text, std::size_t begin, std::size_t end, bool known,
                    bool fused) const = 0;
};

class Pattern {
 public:
  struct Options {
    bool archetype = false;  ///< `|` separates alternatives of the whole, `{x}` is the only field and may be empty
  };
  static base::Result<Pattern, PatternFault> compile(std::string_view text, const Separators& separators,
                                                     Options options);

  /// Matches the whole text. O(text * pattern) runs of fields are tried at most. No recursion deeper than the pattern.
  bool match(const PreparedText& text, const FieldTest& test, Captures& captures) const;

  bool has(Field field) const { return fields_[static_cast<std::size_t>(field)]; }

  /// One step of the automaton.
  struct Step {
    enum class Kind : std::uint8_t { literal, separator, field, any, split, end } kind = Kind::end;
    Field field{};
    bool tail = false;  ///< separators included
    bool known = false;
    bool fused = false;  ///< neither a separator nor the end follows
    bool may_be_empty = false;
    std::uint32_t next = 0;                   ///< index of the next step; always less than that of this step
    std::string literal;                      ///< folded
    std::vector<std::uint32_t> alternatives;  ///< of a split, in their order
  };

 private:
  Pattern() = default;

  std::vector<Step> steps_;
  std::uint32_t first_ = 0;
  std::array<bool, kFields> fields_{};
};

}  // namespace symplant::name
