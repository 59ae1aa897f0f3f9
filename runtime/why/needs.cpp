// What must change for a condition to hold: minimal sets of inputs of its truth tables.
#include "symplant/why/needs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <optional>
#include <string_view>

#include "symplant/condition/type_info.hpp"
#include "symplant/tables/compare.hpp"
#include "symplant/tables/level.hpp"

namespace symplant::why {
namespace {

using condition::Atom;
using condition::Quantity;
using condition::Tree;

constexpr std::size_t kMostShown = 8;  ///< literals of a text

class Changes {
 public:
  Changes(const Network& network, const StateView& view) : network_(network) {
    truth_.reserve(network.size());
    for (const condition::TruthTable& table : network) {
      std::uint8_t row = 0;
      for (std::size_t k = 0; k < table.inputs.size(); ++k) {
        const condition::Input& input = table.inputs[k];
        const bool on = input.is_table ? truth_[input.table] : why::holds(input.atom, view);
        row = static_cast<std::uint8_t>(row | (on ? 1U : 0U) << k);
      }
      rows_.push_back(row);
      truth_.push_back((table.truth >> row & 1) != 0);
    }
  }

  bool holds() const { return truth_.back(); }
  Tree whole() { return of(network_.size() - 1); }

 private:
  /// The sets of inputs whose change changes the truth of a table, as masks; no set includes another one.
  std::vector<std::uint8_t> minimal_sets(std::size_t table) const {
    const std::size_t inputs = network_[table].inputs.size();
    std::vector<std::uint8_t> sets;
    for (std::size_t size = 1; size <= inputs; ++size) {
      for (unsigned set = 1; set < 1U << inputs; ++set) {
        if (static_cast<std::size_t>(std::popcount(set)) != size) continue;
        if ((network_[table].truth >> (rows_[table] ^ set) & 1) == (truth_[table] ? 1U : 0U)) continue;
        const auto is_in = [set](std::uint8_t smaller) { return (smaller & set) == smaller; };
        if (std::none_of(sets.begin(), sets.end(), is_in)) sets.push_back(static_cast<std::uint8_t>(set));
      }
    }
    return sets;
  }

  /// What changes the truth of a table.
  Tree of(std::size_t table) {
    Tree any;
    any.kind = Tree::Kind::any;
    for (const std::uint8_t set : minimal_sets(table)) {
      if (literals_ >= kMostLiterals) break;
      Tree all;
      all.kind = Tree::Kind::all;
      for (std::size_t k = 0; k < network_[table].inputs.size(); ++k) {
        if ((set >> k & 1) != 0) add(all, of_input(network_[table].inputs[k], (rows_[table] >> k & 1) != 0));
      }
      add(any, all.children.size() == 1 ? std::move(all.children.front()) : std::move(all));
    }
    if (any.children.empty()) return {};
    return any.children.size() == 1 ? std::move(any.children.front()) : any;
  }

  Tree of_input(const condition::Input& input, bool now) {
    if (input.is_table) return of(input.table);
    ++literals_;
    Tree atom;
    atom.kind = Tree::Kind::atom;
    atom.atom = input.atom;
    if (!now) return atom;
    Tree negation;
    negation.kind = Tree::Kind::negation;
    negation.children.push_back(std::move(atom));
    return negation;
  }

  /// Adds a child, or its children if it is of the same kind.
  static void add(Tree& tree, Tree child) {
    if (child.kind != tree.kind) {
      tree.children.push_back(std::move(child));
      return;
    }
    for (Tree& other : child.children) tree.children.push_back(std::move(other));
  }

  const Network& network_;
  std::vector<bool> truth_;         ///< by table
  std::vector<std::uint8_t> rows_;  ///< by table: its inputs, as bits
  std::size_t literals_ = 0;
};

std::string_view sign_of(const Atom& atom) {
  constexpr std::array<std::string_view, 5> kSigns = {"<", "<=", "=", ">=", ">"};
  return kSigns[static_cast<std::size_t>(atom.comparison)];
}

std::string number_text(const Atom& atom) {
  const std::string_view sign = sign_of(atom);
  switch (atom.number) {
    case tables::NumberKind::signed_integer:
      return fmt::format("{} {}", sign, static_cast<std::int64_t>(atom.operand));
    case tables::NumberKind::unsigned_integer:
      break;
    case tables::NumberKind::real:
      return fmt::format("{} {}", sign, std::bit_cast<double>(atom.operand));
  }
  return fmt::format("{} {}", sign, atom.operand);
}

bool is_one_or_more(const Atom& atom) {
  return (atom.comparison == tables::Comparison::greater_equal && atom.operand == 1) ||
         (atom.comparison == tables::Comparison::greater && atom.operand == 0);
}

/// The thing that a side of a comparison reads; nothing if it is a number.
std::optional<Reference> reference_of(const Quantity& quantity) {
  switch (quantity.kind) {
    case Quantity::Kind::number:
      return std::nullopt;
    case Quantity::Kind::output:
      return Reference{Reference::Kind::value, quantity.of};
    case Quantity::Kind::symbol:
      return Reference{Reference::Kind::symbol, quantity.of};
    case Quantity::Kind::parts:
    case Quantity::Kind::weight:
      break;
  }
  return Reference{Reference::Kind::location, quantity.of};
}

std::string side_text(const Quantity& quantity, const trace::PlantNames& names) {
  const auto of = reference_of(quantity);
  if (!of) return fmt::format("{}", quantity.number);
  const bool of_location = of->kind == Reference::Kind::location;
  return name_of(*of, names) + (!of_location ? "" : quantity.kind == Quantity::Kind::parts ? ".parts" : ".weight");
}

/// `TANK.level >= SETPOINT`, `SPEED = 80 +- 1`.
std::string compare_text(const Atom& atom, const trace::PlantNames& names) {
  return fmt::format("{} {} {}", side_text(atom.left, names), sign_of(atom), side_text(atom.right, names)) +
         (atom.tolerance == 0 ? "" : fmt::format(" +- {}", atom.tolerance));
}

/// NaN if it is unknown.
double number_of(const Quantity& quantity, const StateView& view) {
  switch (quantity.kind) {
    case Quantity::Kind::number:
      break;
    case Quantity::Kind::output:
      return view.output(quantity.of).value_or(std::numeric_limits<double>::quiet_NaN());
    case Quantity::Kind::symbol:
      return tables::number_of(condition::info_of(quantity.type).kind, view.value(quantity.of));
    case Quantity::Kind::parts:
      return static_cast<double>(view.parts(quantity.of).size());
    case Quantity::Kind::weight:
      return view.weight(quantity.of).value_or(std::numeric_limits<double>::quiet_NaN());
  }
  return quantity.number;
}

/// `L_P_AGV.P2`, `L_P_AGV_O_P1`, `SPEED > 5`, `CV1.part`, `CV1.parts >= 3`.
std::string atom_text(const Atom& atom, const trace::PlantNames& names) {
  switch (atom.kind) {
    case Atom::Kind::settled:
      return fmt::format("{}.{}", names.unit(atom.of), names.state(atom.of, atom.state));
    case Atom::Kind::moving:
      return fmt::format("{}.moving", names.unit(atom.of));
    case Atom::Kind::bit:
      return std::string(names.symbol(atom.of));
    case Atom::Kind::number:
      return fmt::format("{} {}", names.symbol(atom.of), number_text(atom));
    case Atom::Kind::compare:
      return compare_text(atom, names);
    case Atom::Kind::parts:
      break;
  }
  const std::string_view location = names.location(atom.of);
  if (atom.part == tables::kNone && !is_one_or_more(atom))
    return fmt::format("{}.parts {}", location, number_text(atom));
  return fmt::format("{}.{}", location, atom.part == tables::kNone ? "part" : names.part_kind(atom.part));
}

/// An atom, or its negation. A bit of an inverted symbol is named by its meaning: `L_P_EYE_I_PART off (bit 1)`.
std::string literal_text(const Atom& atom, bool is_true, const trace::PlantNames& names) {
  const bool inverted = atom.kind == Atom::Kind::bit && names.tables().symbols[atom.of].inverted();
  if (inverted) return fmt::format("{} {}", atom_text(atom, names), tables::level_text(!is_true, true));
  return (is_true ? "" : "not ") + atom_text(atom, names);
}

/// Adds the text of a tree of literals; `left` is the number of those that it may still have.
void add_text(const Tree& tree, const trace::PlantNames& names, std::size_t& left, std::string& text) {
  if (tree.kind == Tree::Kind::constant) {
    text += tree.value ? "true" : "false";
  } else if (tree.kind == Tree::Kind::atom) {
    --left;
    text += literal_text(tree.atom, true, names);
  } else if (tree.kind == Tree::Kind::negation) {
    --left;
    text += literal_text(tree.children.front().atom, false, names);
  } else {
    const std::string_view word = tree.kind == Tree::Kind::all ? " and " : " or ";
    for (const Tree& child : tree.children) {
      if (&child != tree.children.data()) text += word;
      if (left == 0) {
        text += "more";
        return;
      }
      const bool nested = child.kind == Tree::Kind::all || child.kind == Tree::Kind::any;
      text += nested ? "(" : "";
      add_text(child, names, left, text);
      text += nested ? ")" : "";
    }
  }
}

void add_atoms(const Tree& tree, std::vector<Atom>& atoms) {
  if (tree.kind == Tree::Kind::atom && std::find(atoms.begin(), atoms.end(), tree.atom) == atoms.end()) {
    atoms.push_back(tree.atom);
  }
  for (const Tree& child : tree.children) add_atoms(child, atoms);
}

}  // namespace

bool holds(const Atom& atom, const StateView& view) {
  switch (atom.kind) {
    case Atom::Kind::settled: {
      const plant::UnitView unit = view.unit(atom.of);
      return !unit.moving && unit.state == atom.state;
    }
    case Atom::Kind::moving:
      return view.unit(atom.of).moving;
    case Atom::Kind::bit:
      return view.value(atom.of) != 0;
    case Atom::Kind::number:
      return tables::holds({atom.operand, 0, 0, 0, atom.comparison, atom.number}, view.value(atom.of));
    case Atom::Kind::compare:
      return tables::compares_near(number_of(atom.left, view), atom.comparison, number_of(atom.right, view),
                                   atom.tolerance);
    case Atom::Kind::parts:
      break;
  }
  const std::vector<PartState> parts = view.parts(atom.of);
  const auto count = std::count_if(parts.begin(), parts.end(), [&](const PartState& part) {
    return atom.part == tables::kNone || part.kind == atom.part;
  });
  return tables::holds({atom.operand, 0, 0, 0, atom.comparison, atom.number}, static_cast<std::uint64_t>(count));
}

bool holds(const Network& network, const StateView& view) { return Changes(network, view).holds(); }

Tree changes_of(const Network& network, const StateView& view) { return Changes(network, view).whole(); }

Reference reference_of(const Atom& atom) {
  switch (atom.kind) {
    case Atom::Kind::settled:
    case Atom::Kind::moving:
      return {Reference::Kind::unit, atom.of};
    case Atom::Kind::bit:
    case Atom::Kind::number:
      return {Reference::Kind::symbol, atom.of};
    case Atom::Kind::compare:
      return *reference_of(atom.left);  // a number is on the right
    case Atom::Kind::parts:
      break;
  }
  return {Reference::Kind::location, atom.of};
}

std::vector<Atom> atoms_of(const Tree& tree) {
  std::vector<Atom> atoms;
  add_atoms(tree, atoms);
  return atoms;
}

std::string condition_text(const Tree& tree, const trace::PlantNames& names) {
  std::string text;
  std::size_t left = kMostShown;
  add_text(tree, names, left, text);
  return text;
}

}  // namespace symplant::why
