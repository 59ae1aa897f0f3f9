// Plant models derived from a list and then changed, for what a list cannot express.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/compile.hpp"

namespace symplant::test {

using condition::Atom;
using condition::Tree;

/// The model of a list of bits (see bits()).
inline model::PlantModel model_of(const std::vector<std::string>& names) {
  Analysed analysed = analyse_rows(bits(names));
  REQUIRE(analysed.derived);
  return std::move(analysed.derived->plant);
}

inline std::uint32_t symbol_of(const model::PlantModel& plant, std::string_view name) {
  const auto found = std::find_if(plant.symbols.begin(), plant.symbols.end(),
                                  [&](const model::Symbol& symbol) { return symbol.name() == name; });
  REQUIRE(found != plant.symbols.end());
  return static_cast<std::uint32_t>(found - plant.symbols.begin());
}

inline Tree settled(std::uint32_t unit, std::uint8_t state) {
  return {Tree::Kind::atom, false, {Atom::Kind::settled, unit, state}, {}};
}
inline Tree moving(std::uint32_t unit) { return {Tree::Kind::atom, false, {Atom::Kind::moving, unit}, {}}; }
inline Tree bit(std::uint32_t symbol) { return {Tree::Kind::atom, false, {Atom::Kind::bit, symbol}, {}}; }
inline Tree number(std::uint32_t symbol, tables::Comparison comparison, tables::NumberKind kind,
                   std::uint64_t operand) {
  return {Tree::Kind::atom, false, {Atom::Kind::number, symbol, 0, model::kNone, comparison, kind, operand}, {}};
}
inline Tree constant(bool value) { return {Tree::Kind::constant, value, {}, {}}; }
inline Tree operator!(Tree tree) { return {Tree::Kind::negation, false, {}, {std::move(tree)}}; }
inline Tree operator&&(Tree a, Tree b) { return {Tree::Kind::all, false, {}, {std::move(a), std::move(b)}}; }
inline Tree operator||(Tree a, Tree b) { return {Tree::Kind::any, false, {}, {std::move(a), std::move(b)}}; }

/// On and off, one state each.
using Masks = std::vector<std::pair<std::uint64_t, std::uint64_t>>;
inline Masks masks(const std::vector<tables::EventMasks>& rows) {
  Masks masks;
  for (const tables::EventMasks& row : rows) masks.emplace_back(row.on, row.off);
  return masks;
}

}  // namespace symplant::test
