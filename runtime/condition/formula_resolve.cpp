// Looks up the names of formulas.
#include "symplant/condition/formula_resolve.hpp"

#include <optional>
#include <utility>

#include "symplant/condition/lookup.hpp"

namespace symplant::condition {
namespace {

using Found = std::variant<FormulaInput, Fault>;

FormulaInput input_of(FormulaInput::Kind kind, std::uint32_t of) {
  FormulaInput input;
  input.kind = kind;
  input.of = of;
  return input;
}

FormulaInput input_of(const Atom& atom) {
  FormulaInput input;
  input.kind = FormulaInput::Kind::atom;
  input.atom = atom;
  return input;
}

Found symbol(const Name& name, const Lookup& lookup) {
  const auto found = lookup.symbol(name);
  if (!found) return lookup.no_symbol(name);
  if (found->type == tables::DataType::boolean) {
    Atom atom;
    atom.kind = Atom::Kind::bit;
    atom.of = found->index;
    return input_of(atom);
  }
  FormulaInput input = input_of(FormulaInput::Kind::number, found->index);
  input.type = found->type;
  return input;
}

/// A state, or what a location has.
Found member(Path path, const Lookup& lookup) {
  const auto location = lookup.location(path.front());
  if (location && path.size() == 2) {
    if (is_word(path.back().text, "parts")) return input_of(FormulaInput::Kind::parts, *location);
    if (is_word(path.back().text, "weight")) return input_of(FormulaInput::Kind::weight, *location);
  }
  auto found = lookup.state(path);
  if (auto* fault = std::get_if<Fault>(&found)) return std::move(*fault);
  const auto& atom = std::get<Atom>(found);
  if (atom.kind != Atom::Kind::parts) return input_of(atom);
  FormulaInput input = input_of(FormulaInput::Kind::parts, atom.of);
  input.part = atom.part;
  return input;
}

}  // namespace

Found formula_input(const Operand& operand, const Names& names) {
  const Lookup lookup(names);
  if (auto found = lookup.output(operand.names, operand.output)) {
    if (auto* fault = std::get_if<Fault>(&*found)) return std::move(*fault);
    return input_of(FormulaInput::Kind::output, std::get<std::uint32_t>(*found));
  }
  if (operand.output) {
    auto without = formula_input({operand.names, {}, {}, operand.index}, names);  // an unknown name comes first
    if (auto* fault = std::get_if<Fault>(&without)) return std::move(*fault);
    return Lookup::no_outputs(*operand.output);
  }
  return operand.names.size() == 1 ? symbol(operand.names.front(), lookup) : member(operand.names, lookup);
}

}  // namespace symplant::condition
