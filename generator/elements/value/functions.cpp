// Formulas as C++ functions.
#include "elements/value/functions.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "emit/row_text.hpp"
#include "model/condition_text.hpp"
#include "symplant/tables/formula.hpp"
#include "symplant/tables/names.hpp"
#include "text/ascii.hpp"
#include "text/generated_names.hpp"
#include "text/identifier.hpp"

namespace symplant::emit {
namespace {

using condition::FormulaInput;
using tables::FormulaOp;

/// A part of an expression, with how tightly its outermost operator binds.
struct Term {
  enum Binding : std::uint8_t { choice, any, all, comparison, sum, product, unary, atom };
  std::string text;
  Binding binding = atom;
  bool is_truth = false;  ///< a bool, not a double
};

std::string in_parentheses(std::string text) { return "(" + std::move(text) + ")"; }

/// As a double, for an operator or an argument.
Term number(Term term) {
  if (!term.is_truth) return term;
  return {"formula::truth(" + std::move(term.text) + ")"};
}

/// As a bool: a number is true if it is not 0.
Term truth(Term term) {
  if (term.is_truth) return term;
  if (term.binding <= Term::comparison) term.text = in_parentheses(std::move(term.text));
  return {std::move(term.text) + " != 0.0", Term::comparison, true};
}

std::string bound(Term term, bool tightly_enough) {
  return tightly_enough ? std::move(term.text) : in_parentheses(std::move(term.text));
}

/// Operators of one level group from the left.
Term operation(Term a, std::string_view op, Term b, Term::Binding binding, bool is_truth) {
  const bool a_fits = a.binding >= binding;
  const bool b_fits = b.binding > binding;
  std::string text = bound(std::move(a), a_fits);
  text.append(" ").append(op).append(" ").append(bound(std::move(b), b_fits));
  return {std::move(text), binding, is_truth};
}

Term arithmetic(Term a, std::string_view op, Term b, Term::Binding binding) {
  return operation(number(std::move(a)), op, number(std::move(b)), binding, false);
}

Term compared(Term a, std::string_view op, Term b) {
  a = number(std::move(a));
  b = number(std::move(b));
  return operation(std::move(a), op, std::move(b), Term::comparison, true);
}

/// Compilers warn of `and` within `or` without parentheses.
Term joined(Term a, std::string_view op, Term b, Term::Binding binding) {
  a = truth(std::move(a));
  b = truth(std::move(b));
  const auto fits = [binding](const Term& term) { return term.binding == binding || term.binding >= Term::comparison; };
  const bool a_fits = fits(a);
  const bool b_fits = fits(b);
  std::string text = bound(std::move(a), a_fits);
  text.append(" ").append(op).append(" ").append(bound(std::move(b), b_fits));
  return {std::move(text), binding, true};
}

Term prefixed(std::string_view op, Term a, bool is_truth) {
  const bool fits = a.binding == Term::atom;
  return {std::string(op) + bound(std::move(a), fits), Term::unary, is_truth};
}

Term call(std::string_view function, std::span<Term> arguments) {
  std::string text = fmt::format("formula::{}(", function);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    text.append(i == 0 ? "" : ", ").append(number(std::move(arguments[i])).text);
  }
  return {std::move(text) + ")"};
}

Term choice(Term condition, Term a, Term b) {
  const bool a_fits = a.binding != Term::choice;
  const bool b_fits = b.binding != Term::choice;
  std::string text = std::move(condition.text) + " ? " + bound(std::move(a), a_fits);
  return {std::move(text) + " : " + bound(std::move(b), b_fits), Term::choice};
}

/// The points of a curve, x and y of each.
Term curve(Term x, std::span<const double> points) {
  std::string text = "formula::curve(" + number(std::move(x)).text + ", {";
  for (std::size_t i = 0; i < points.size(); ++i) text.append(i == 0 ? "" : ", ").append(double_text(points[i]));
  return {std::move(text) + "})"};
}

Term term_of(const tables::FormulaStep& step, std::span<Term> of, std::span<const double> numbers,
             const std::vector<std::string>& inputs) {
  const auto take = [of](std::size_t i) -> Term { return std::move(of[i]); };
  switch (step.op) {
    case FormulaOp::number:
      return {double_text(step.number)};
    case FormulaOp::input:
      return {inputs[step.of]};
    case FormulaOp::negate:
      return prefixed("-", number(take(0)), false);
    case FormulaOp::no:
      return prefixed("!", truth(take(0)), true);
    case FormulaOp::add:
      return arithmetic(take(0), "+", take(1), Term::sum);
    case FormulaOp::subtract:
      return arithmetic(take(0), "-", take(1), Term::sum);
    case FormulaOp::multiply:
      return arithmetic(take(0), "*", take(1), Term::product);
    case FormulaOp::divide:
      return arithmetic(take(0), "/", take(1), Term::product);
    case FormulaOp::less:
      return compared(take(0), "<", take(1));
    case FormulaOp::less_equal:
      return compared(take(0), "<=", take(1));
    case FormulaOp::equal:
      return compared(take(0), "==", take(1));
    case FormulaOp::greater_equal:
      return compared(take(0), ">=", take(1));
    case FormulaOp::greater:
      return compared(take(0), ">", take(1));
    case FormulaOp::all:
      return joined(take(0), "&&", take(1), Term::all);
    case FormulaOp::any:
      return joined(take(0), "||", take(1), Term::any);
    case FormulaOp::choose:
      return choice(truth(take(0)), number(take(1)), number(take(2)));
    case FormulaOp::curve:
      return curve(take(0), numbers.subspan(std::size_t{step.of} + 1, static_cast<std::size_t>(numbers[step.of]) * 2));
    default:
      return call(enumerator(step.op).substr(std::string_view("tables::FormulaOp::").size()), of);
  }
}

/// The name of an input, as a formula has it.
std::string input_text(const FormulaInput& input, const model::PlantModel& plant) {
  using Kind = FormulaInput::Kind;
  switch (input.kind) {
    case Kind::output:
      return model::output_name(plant, input.of);
    case Kind::atom: {
      condition::Tree tree;
      tree.kind = condition::Tree::Kind::atom;
      tree.atom = input.atom;
      return model::condition_text(tree, plant);
    }
    case Kind::number:
      return std::string(plant.symbols[input.of].name());
    case Kind::parts:
      return plant.material.location_name(input.of) + "." +
             (input.part == tables::kNone ? "parts" : plant.material.kinds[input.part].name);
    case Kind::weight:
      return plant.material.location_name(input.of) + ".weight";
    case Kind::time:
      break;
  }
  return "time";
}

/// The names of a formula's inputs as parameters.
std::vector<std::string> parameters_of(const condition::Formula& formula, const model::PlantModel& plant) {
  static constexpr std::string_view kTaken[] = {"formula"};
  text::IdentifierScope scope(kTaken);
  std::vector<std::string> names;
  for (const FormulaInput& input : formula.inputs) {
    names.push_back(scope.unique(function_name(input_text(input, plant))));
  }
  return names;
}

/// What a formula is for: the name of its function, and the line above it. Without a name it has no function: what a
/// position shows follows from its unit, and the formula only says what it reads.
struct Title {
  std::string name;
  std::string about;
  bool is_part = false;  ///< one of several formulas of a value
};

void add_titles(std::vector<Title>& titles, const tables::ValueRow& row, const model::Value& value,
                const lower::Values& values) {
  const std::string what =
      fmt::format("{}{}, {}", value.name, value.unit.empty() ? "" : " (" + value.unit + ")", value_kind_name(row.kind));
  const auto add = [&](std::uint32_t formula, const std::string& part) {
    const bool is_part = !part.empty();
    titles[formula] = {value.name + (is_part ? "_" + part : ""), what + (is_part ? ", " + part : ""), is_part};
  };
  for (std::uint32_t f = 0; f < row.formulas && row.kind != tables::ValueKind::position; ++f) {
    std::string part;
    if (row.kind == tables::ValueKind::ramp) part = f == 0 ? "" : f == 1 ? "up" : "down";
    if (row.kind == tables::ValueKind::pid) part = f == 0 ? "of" : "to";
    if (row.kind == tables::ValueKind::linear) part = fmt::format("u{}", f + 1);
    add(row.formula + f, part);
  }
  for (std::uint32_t c = 0; c < row.changes.count; ++c) {
    add(values.changes[row.changes.first + c].formula, row.changes.count == 1 ? "to" : fmt::format("to{}", c + 1));
  }
}

std::vector<Title> titles_of(const lower::EngineTables& tables, const model::PlantModel& plant) {
  const lower::Values& values = tables.values;
  std::vector<Title> titles(values.formulas.size());
  for (std::size_t v = 0; v < values.rows.size(); ++v) add_titles(titles, values.rows[v], plant.values[v], values);
  for (const tables::SignalRow& signal : values.signals) {
    const std::string name(plant.symbols[signal.symbol].name());
    titles[signal.formula] = {name, name};
  }
  for (const tables::RandomTime& time : tables.random_times) {
    if (time.kind != tables::RandomTime::Kind::seconds) continue;
    titles[static_cast<std::size_t>(time.a)] = {"seconds", "The seconds of a transition", true};
  }
  // Values and signals get their names first: what another value has in addition changes none of them.
  text::IdentifierScope scope(text::kGeneratedNames);
  for (const bool parts : {false, true}) {
    for (Title& title : titles) {
      if (title.is_part == parts && !title.name.empty()) title.name = scope.unique(function_name(title.name));
    }
  }
  return titles;
}

}  // namespace

std::string function_name(std::string_view name) {
  std::string result;
  for (const char c : text::to_lower(name)) {
    if (c == '.' || c == ' ' || c == '[' || c == '-') result += '_';
    if (c != '.' && c != ' ' && c != '[' && c != '-' && c != ']' && c != '\'') result += c;
  }
  return result;
}

std::string formula_expression(std::span<const tables::FormulaStep> steps, std::span<const double> numbers,
                               const std::vector<std::string>& inputs) {
  std::vector<Term> stack;
  for (const tables::FormulaStep& step : steps) {
    const std::size_t first = stack.size() - tables::operands_of(step.op);
    Term result = term_of(step, std::span(stack).subspan(first), numbers, inputs);
    stack.resize(first);
    stack.push_back(std::move(result));
  }
  return number(std::move(stack.front())).text;
}

std::string formula_function_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  const std::vector<Title> titles = titles_of(tables, plant);
  RowWriter rows;
  bool first = true;
  for (std::size_t f = 0; f < titles.size(); ++f) {
    if (titles[f].name.empty()) continue;
    const condition::Formula& formula = *tables.values.sources[f];
    const std::vector<std::string> inputs = parameters_of(formula, plant);
    rows.text(std::exchange(first, false) ? "" : "\n")
        .text("  /// ")
        .comment(titles[f].about)
        .text(": ")
        .comment(formula.text);
    rows.text("\n  static double ").text(titles[f].name).text("(");
    for (std::size_t i = 0; i < inputs.size(); ++i) rows.text(i == 0 ? "double " : ", double ").text(inputs[i]);
    rows.text(") noexcept {\n    return ").text(formula_expression(formula.steps, formula.numbers, inputs));
    rows.text(";\n  }\n");
  }
  return rows.take();
}

std::string formula_entry_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const Title& title : titles_of(tables, plant)) {
    if (title.name.empty()) {
      rows.text("    {},  // a position\n");
      continue;
    }
    rows.text("    compiled_formula<&Formulas::").text(title.name).text(", &ModelFormulas::");
    rows.text(title.name).text(">(),\n");
  }
  return rows.take();
}

}  // namespace symplant::emit
