// Conditions that start and stop a recording.
#include "record/trigger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "symplant/condition/resolve.hpp"
#include "symplant/condition/type_info.hpp"
#include "symplant/scenario/table_names.hpp"
#include "symplant/tables/compare.hpp"

namespace symplant::record {
namespace {

using condition::Atom;
using condition::Quantity;
using condition::Tree;
using Values = std::span<const std::uint64_t>;

double number_of(const Quantity& quantity, Values values) {
  if (quantity.kind == Quantity::Kind::number) return quantity.number;
  return tables::number_of(condition::info_of(quantity.type).kind, values[quantity.of]);
}

bool atom_holds(const Atom& atom, Values values) {
  if (atom.kind == Atom::Kind::bit) return values[atom.of] != 0;
  if (atom.kind == Atom::Kind::compare) {
    return tables::compares_near(number_of(atom.left, values), atom.comparison, number_of(atom.right, values),
                                 atom.tolerance);
  }
  tables::ValueWatch watch{};
  watch.operand = atom.operand;
  watch.comparison = atom.comparison;
  watch.kind = atom.number;
  return tables::holds(watch, values[atom.of]);
}

bool tree_holds(const Tree& tree, Values values) {
  const auto child_holds = [&](const Tree& child) { return tree_holds(child, values); };
  switch (tree.kind) {
    case Tree::Kind::constant:
      return tree.value;
    case Tree::Kind::atom:
      return atom_holds(tree.atom, values);
    case Tree::Kind::negation:
      return !tree_holds(tree.children.front(), values);
    case Tree::Kind::all:
      return std::all_of(tree.children.begin(), tree.children.end(), child_holds);
    case Tree::Kind::any:
      break;
  }
  return std::any_of(tree.children.begin(), tree.children.end(), child_holds);
}

/// Finds what a recording does not have.
class Checker {
 public:
  Checker(const trace::PlantNames& names, const std::vector<bool>& is_read) : names_(names), is_read_(is_read) {}

  /// What is wrong; empty: nothing.
  std::string fault(const Tree& tree) const {
    if (tree.kind == Tree::Kind::constant || tree.kind == Tree::Kind::atom) return fault(tree.atom);
    for (const Tree& child : tree.children) {
      if (std::string found = fault(child); !found.empty()) return found;
    }
    return "";
  }

 private:
  static std::string no_symbol(const std::string& what) {
    return what + ", which is not read from a PLC; name a symbol instead that shows it";
  }

  std::string fault(const Atom& atom) const {
    switch (atom.kind) {
      case Atom::Kind::settled:
      case Atom::Kind::moving:
        return no_symbol(fmt::format("it names a state of the device `{}`", names_.unit(atom.of)));
      case Atom::Kind::parts:
        return no_symbol(fmt::format("it names the parts at `{}`", names_.location(atom.of)));
      case Atom::Kind::bit:
      case Atom::Kind::number:
        return symbol_fault(atom.of);
      case Atom::Kind::compare:
        break;
    }
    std::string found = fault(atom.left);
    return found.empty() ? fault(atom.right) : found;
  }

  std::string fault(const Quantity& quantity) const {
    switch (quantity.kind) {
      case Quantity::Kind::number:
        return "";
      case Quantity::Kind::symbol:
        return symbol_fault(quantity.of);
      case Quantity::Kind::output:
        return no_symbol(fmt::format("it names the value `{}`", names_.output(quantity.of)));
      case Quantity::Kind::parts:
      case Quantity::Kind::weight:
        break;
    }
    return no_symbol(fmt::format("it names the parts at `{}`", names_.location(quantity.of)));
  }

  std::string symbol_fault(std::uint32_t symbol) const {
    if (is_read_[symbol]) return "";
    return fmt::format("this link does not read `{}`; `symplant map PLANT --link URL` lists what it reads",
                       names_.symbol(symbol));
  }

  const trace::PlantNames& names_;
  const std::vector<bool>& is_read_;
};

}  // namespace

bool Trigger::holds(std::span<const std::uint64_t> values) const { return tree_holds(tree_, values); }

std::variant<Trigger, std::string> read_trigger(std::string_view text, const trace::PlantNames& names,
                                                const std::vector<bool>& is_read) {
  auto resolved = condition::parse_and_resolve(text, scenario::TableNames(names));
  if (const auto* fault = std::get_if<condition::Fault>(&resolved)) {
    return fmt::format("`{}`, character {}: {}", text, fault->index.offset + 1, fault->message);
  }
  Tree& tree = std::get<Tree>(resolved);
  if (std::string fault = Checker(names, is_read).fault(tree); !fault.empty()) {
    return fmt::format("`{}`: {}", text, fault);
  }
  return Trigger(std::move(tree));
}

}  // namespace symplant::record
