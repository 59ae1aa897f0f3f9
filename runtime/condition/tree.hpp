// A condition as a tree of a plant's units, symbols and values: the form in PlantModel.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::condition {

/// One side of a comparison of two operands, which compare as doubles.
struct Quantity {
  enum class Kind : std::uint8_t {
    number,  ///< `number`, nothing else is valid
    output,  ///< output `of` of a value
    symbol,  ///< numeric symbol `of` of type `type`, after forces
    parts,   ///< the number of parts at location `of`
    weight,  ///< the sum of the weights of the parts at location `of`
  };
  Kind kind = Kind::number;
  std::uint32_t of = 0;
  tables::DataType type = tables::DataType::boolean;  ///< of a symbol
  double number = 0;

  friend bool operator==(const Quantity&, const Quantity&) = default;
};

/// A test of one unit, symbol or location of parts, or a comparison of two operands.
struct Atom {
  enum class Kind : std::uint8_t {
    settled,  ///< unit `of` is settled in `state`
    moving,   ///< unit `of` is moving
    bit,      ///< BOOL symbol `of` is on, after forces
    number,   ///< numeric symbol `of`, after forces, compares with `operand`
    parts,    ///< the number of parts at location `of`, of kind `part`, compares with `operand`
    compare,  ///< `left` compares with `right`; `equal` holds within `tolerance`, at its ends too
  };
  Kind kind = Kind::settled;
  std::uint32_t of = 0;
  std::uint8_t state = 0;
  std::uint32_t part = 0xFFFF'FFFF;  ///< a kind of part; kNone: all kinds
  tables::Comparison comparison = tables::Comparison::equal;
  tables::NumberKind number = tables::NumberKind::signed_integer;
  std::uint64_t operand = 0;  ///< two's complement, or the bits of a double, by `number`
  // Only these and `comparison` are valid in `compare`. A number is always on the right.
  Quantity left{};
  Quantity right{};
  double tolerance = 0;

  friend bool operator==(const Atom&, const Atom&) = default;
};

/// `negation` has one child, `all` and `any` have two or more, the other kinds have no children. A comparison that no
/// value of the symbol or every value meets is a constant; only `kind` and `of` of its atom are then valid.
struct Tree {
  enum class Kind : std::uint8_t { constant, atom, negation, all, any };
  Kind kind = Kind::constant;
  bool value = false;  ///< of a constant
  Atom atom;
  std::vector<Tree> children;
};

}  // namespace symplant::condition
