// A condition as a tree over what a plant has: the form that PlantModel holds.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::condition {

/// What a condition looks at.
struct Atom {
  enum class Kind : std::uint8_t {
    settled,  ///< unit `of` is settled in `state`
    moving,   ///< unit `of` is moving
    bit,      ///< BOOL symbol `of` is on, after forces
    number,   ///< numeric symbol `of`, after forces, compares with `operand`
  };
  Kind kind = Kind::settled;
  std::uint32_t of = 0;
  std::uint8_t state = 0;
  tables::Comparison comparison = tables::Comparison::equal;
  tables::NumberKind number = tables::NumberKind::signed_integer;
  std::uint64_t operand = 0;  ///< two's complement, or the bits of a double, as `number` says

  friend bool operator==(const Atom&, const Atom&) = default;
};

/// `negation` has one child, `all` and `any` have two or more, the others none. A comparison that no value of the
/// symbol can meet, or every one meets, is a constant; its atom still says which symbol (`kind` and `of` alone count).
struct Tree {
  enum class Kind : std::uint8_t { constant, atom, negation, all, any };
  Kind kind = Kind::constant;
  bool value = false;  ///< of a constant
  Atom atom;
  std::vector<Tree> children;
};

}  // namespace symplant::condition
