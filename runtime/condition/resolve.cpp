// Makes the trees of conditions, and folds comparisons.
#include "symplant/condition/resolve.hpp"

#include <utility>

#include "symplant/condition/compare.hpp"
#include "symplant/condition/lookup.hpp"

namespace symplant::condition {
namespace {

using Resolved = std::variant<Tree, Fault>;

Tree tree_of(const Atom& atom) {
  Tree tree;
  tree.kind = Tree::Kind::atom;
  tree.atom = atom;
  return tree;
}

/// The constant to which a comparison with a symbol, or with a number of parts, was folded.
Tree constant(bool value, Atom::Kind kind, std::uint32_t of) {
  Tree tree;
  tree.value = value;
  tree.atom.kind = kind;
  tree.atom.of = of;
  return tree;
}

/// The comparison with the sides exchanged.
tables::Comparison mirrored(tables::Comparison comparison) {
  using tables::Comparison;
  switch (comparison) {
    case Comparison::less:
      return Comparison::greater;
    case Comparison::less_equal:
      return Comparison::greater_equal;
    case Comparison::equal:
      break;
    case Comparison::greater_equal:
      return Comparison::less_equal;
    case Comparison::greater:
      return Comparison::less;
  }
  return Comparison::equal;
}

bool is_number(const Operand& operand) { return operand.names.empty(); }

/// The number of an operand or of a tolerance, or what is wrong with it.
std::variant<double, Fault> real_of(const Operand& operand) {
  const auto real = operand.number.real();
  if (!real) return Fault{operand.index, "the number is out of range"};
  return *real;
}

class Resolver {
 public:
  explicit Resolver(const Names& names) : lookup_(names) {}

  Resolved resolve(const Expression& expression) const {
    switch (expression.kind) {
      case Expression::Kind::name:
        return alone(expression);
      case Expression::Kind::comparison:
        return comparison(expression);
      case Expression::Kind::negation:
      case Expression::Kind::all:
      case Expression::Kind::any:
        break;
    }
    Tree tree;
    tree.kind = expression.kind == Expression::Kind::negation ? Tree::Kind::negation
                : expression.kind == Expression::Kind::all    ? Tree::Kind::all
                                                              : Tree::Kind::any;
    tree.children.reserve(expression.children.size());
    for (const Expression& child : expression.children) {
      Resolved part = resolve(child);
      if (part.index() == 1) return part;
      tree.children.push_back(std::move(std::get<Tree>(part)));
    }
    return tree;
  }

 private:
  /// Names without a comparison.
  Resolved alone(const Expression& expression) const {
    const Path path = expression.names;
    if (const auto output = lookup_.output(path, {})) {
      const bool has_several = std::holds_alternative<Fault>(*output);
      return Fault{whole(path), ticked(dotted(path)) + " is a value and has no comparison; compare it, as in " +
                                    ticked(dotted(path) + (has_several ? "[1]" : "") + " = 1")};
    }
    if (path.size() == 1) return bit(path.front());
    auto found = lookup_.state(path);
    if (auto* fault = std::get_if<Fault>(&found)) return std::move(*fault);
    return tree_of(std::get<Atom>(found));
  }

  Resolved bit(const Name& name) const {
    const auto symbol = lookup_.symbol(name);
    if (!symbol) return lookup_.no_symbol(name);
    if (symbol->type != tables::DataType::boolean) {
      return Fault{name.index, ticked(name.text) + " is of type " + std::string(type_name(symbol->type)) +
                                   " and has no comparison; compare it, as in " + ticked(name.text + " > 0")};
    }
    Atom atom;
    atom.kind = Atom::Kind::bit;
    atom.of = symbol->index;
    return tree_of(atom);
  }

  Resolved comparison(const Expression& expression) const {
    const Operand& left = expression.operands[0];
    const Operand& right = expression.operands[1];
    if (is_number(left) && is_number(right)) {
      return Fault{{left.index.offset, right.index.offset + right.index.length - left.index.offset},
                   "both sides are numbers; compare a name, which is in single quotes if it reads as a number"};
    }
    if (expression.operands.size() > 2) return near(expression);
    if (is_number(right)) return with_number(left, expression.comparison, right);
    if (is_number(left)) return with_number(right, mirrored(expression.comparison), left);
    return of_two(left, expression.comparison, right, 0);
  }

  /// With a tolerance.
  Resolved near(const Expression& expression) const {
    const Operand& tolerance = expression.operands[2];
    if (expression.comparison != tables::Comparison::equal) {
      return Fault{tolerance.index, "a tolerance is only for `=`; write `=`, or remove the `+-`"};
    }
    if (tolerance.number.negative) {
      return Fault{tolerance.index, "a tolerance is at least 0; remove the `-`"};
    }
    const auto real = real_of(tolerance);
    if (const auto* fault = std::get_if<Fault>(&real)) return *fault;
    const bool exchanged = is_number(expression.operands[0]);
    return of_two(expression.operands[exchanged ? 1 : 0], tables::Comparison::equal,
                  expression.operands[exchanged ? 0 : 1], std::get<double>(real));
  }

  Resolved with_number(const Operand& operand, tables::Comparison comparison, const Operand& number) const {
    const auto found = lookup_.quantity(operand);
    if (const auto* fault = std::get_if<Fault>(&found)) return *fault;
    const auto& quantity = std::get<Quantity>(found);
    const bool is_symbol = quantity.kind == Quantity::Kind::symbol;
    if (!is_symbol && quantity.kind != Quantity::Kind::parts) return of_two(operand, comparison, number, 0);
    const auto folded = fold(is_symbol ? quantity.type : tables::DataType::ulint, comparison, number.number);
    if (!folded) {
      return Fault{number.index, is_symbol ? "the number is out of range for " + std::string(type_name(quantity.type))
                                           : "the number is out of range"};
    }
    return folded_tree(*folded, is_symbol ? Atom::Kind::number : Atom::Kind::parts, quantity.of);
  }

  static Tree folded_tree(const std::variant<FoldedComparison, bool>& folded, Atom::Kind kind, std::uint32_t of) {
    if (const bool* always = std::get_if<bool>(&folded)) return constant(*always, kind, of);
    const auto& found = std::get<FoldedComparison>(folded);
    Atom atom;
    atom.kind = kind;
    atom.of = of;
    atom.comparison = found.comparison;
    atom.number = found.number;
    atom.operand = found.operand;
    return tree_of(atom);
  }

  Resolved of_two(const Operand& left, tables::Comparison comparison, const Operand& right, double tolerance) const {
    const auto first = side(left);
    if (const auto* fault = std::get_if<Fault>(&first)) return *fault;
    const auto second = side(right);
    if (const auto* fault = std::get_if<Fault>(&second)) return *fault;
    Atom atom;
    atom.kind = Atom::Kind::compare;
    atom.comparison = comparison;
    atom.left = std::get<Quantity>(first);
    atom.right = std::get<Quantity>(second);
    atom.tolerance = tolerance;
    return tree_of(atom);
  }

  std::variant<Quantity, Fault> side(const Operand& operand) const {
    if (!is_number(operand)) return lookup_.quantity(operand);
    const auto real = real_of(operand);
    if (const auto* fault = std::get_if<Fault>(&real)) return *fault;
    Quantity quantity;
    quantity.number = std::get<double>(real);
    return quantity;
  }

  const Lookup lookup_;
};

}  // namespace

std::variant<Tree, Fault> resolve(const Expression& expression, const Names& names) {
  return Resolver(names).resolve(expression);
}

std::variant<Tree, Fault> parse_and_resolve(std::string_view text, const Names& names) {
  auto parsed = parse(text);
  if (auto* fault = std::get_if<Fault>(&parsed)) return std::move(*fault);
  return resolve(std::get<Expression>(parsed), names);
}

}  // namespace symplant::condition
