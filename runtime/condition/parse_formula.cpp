// Parses formulas by recursive descent, a function for each level of binding.
#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "symplant/condition/formula.hpp"
#include "symplant/condition/formula_functions.hpp"
#include "symplant/condition/formula_resolve.hpp"
#include "symplant/condition/formula_tokens.hpp"
#include "symplant/condition/lookup.hpp"
#include "symplant/tables/formula.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::condition {
namespace {

using tables::FormulaOp;

/// An operator between two operands; a word if it begins with a letter.
struct Operator {
  std::string_view text;
  FormulaOp op;
};
constexpr std::array kOr{Operator{"or", FormulaOp::any}};
constexpr std::array kAnd{Operator{"and", FormulaOp::all}};
constexpr std::array kComparisons{Operator{"<", FormulaOp::less}, Operator{"<=", FormulaOp::less_equal},
                                  Operator{"=", FormulaOp::equal}, Operator{">=", FormulaOp::greater_equal},
                                  Operator{">", FormulaOp::greater}};
constexpr std::array kSums{Operator{"+", FormulaOp::add}, Operator{"-", FormulaOp::subtract}};
constexpr std::array kProducts{Operator{"*", FormulaOp::multiply}, Operator{"/", FormulaOp::divide}};

constexpr std::array<std::string_view, 5> kWords{"and", "or", "not", "time", "pi"};

/// What to write instead of signs of other languages.
struct Habit {
  std::string_view sign;
  std::string_view instead;
};
constexpr std::array kHabits{Habit{"=", "equal is `a = b`"},
                             Habit{">", "not equal is `not a = b`"},
                             Habit{"!", "not equal is `not a = b`"},
                             Habit{"^", "write `pow(x, y)`"},
                             Habit{"*", "a power is `pow(x, y)`"},
                             Habit{"%", "write `mod(x, y)`"},
                             Habit{"&", "write `and`"},
                             Habit{"|", "write `or`"},
                             Habit{".", "write 0 before it, as in `0.5`"}};

const FormulaFunction* function_of(std::string_view name) {
  const auto found = std::find_if(kFormulaFunctions.begin(), kFormulaFunctions.end(),
                                  [&](const FormulaFunction& function) { return function.name == name; });
  return found == kFormulaFunctions.end() ? nullptr : &*found;
}

std::string usage(const FormulaFunction& function) {
  return "`" + std::string(function.name) + "(" + std::string(function.arguments) + ")`";
}

/// The word or function that a name is in lower case; empty if it is not one, or is in lower case.
std::string_view lower_case_of(std::string_view name) {
  const auto meant = [name](std::string_view word) { return is_word(name, word) && name != word; };
  for (const std::string_view word : kWords) {
    if (meant(word)) return word;
  }
  for (const FormulaFunction& function : kFormulaFunctions) {
    if (meant(function.name)) return function.name;
  }
  return {};
}

class Parser {
 public:
  Parser(std::string_view text, const Names& names) : names_(names), tokens_(text) {
    formula_.text = text;
    advance();
  }

  std::variant<Formula, Fault> run() {
    const bool whole = disjunction() && (token_.kind == Token::Kind::end || fail("an operator or the end"));
    if (!whole) return std::move(*fault_);
    return std::move(formula_);
  }

 private:
  // A member that returns bool returns false after it has set `fault_`.

  bool disjunction() { return binary(&Parser::conjunction, kOr); }
  bool conjunction() { return binary(&Parser::negation, kAnd); }
  bool sum() { return binary(&Parser::product, kSums); }
  bool product() { return binary(&Parser::unary, kProducts); }

  /// Operands of one level, grouped from the left.
  bool binary(bool (Parser::*operand)(), std::span<const Operator> operators) {
    if (!(this->*operand)()) return false;
    while (const auto op = taken(operators)) {
      if (!(this->*operand)() || !emit({*op})) return false;
    }
    return true;
  }

  bool negation() {
    std::size_t count = 0;
    for (; token_.is_name("not"); advance()) ++count;
    if (!comparison()) return false;
    for (; count > 0; --count) formula_.steps.push_back({FormulaOp::no});
    return true;
  }

  bool comparison() {
    if (!sum()) return false;
    const auto op = taken(kComparisons);
    if (!op) return true;
    if (!sum() || !emit({*op})) return false;
    const Token second = token_;
    if (!taken(kComparisons)) return true;
    return fail(second.index(), "comparisons do not chain; write `a < b and b < c`");
  }

  bool unary() {
    std::size_t count = 0;
    for (; token_.is_sign("-"); advance()) ++count;
    const std::size_t first = formula_.steps.size();
    if (!primary()) return false;
    if (first + 1 == formula_.steps.size() && formula_.steps.back().op == FormulaOp::number) {
      if (count % 2 != 0) formula_.steps.back().number = -formula_.steps.back().number;
      return true;
    }
    for (; count > 0; --count) formula_.steps.push_back({FormulaOp::negate});
    return true;
  }

  bool primary() {
    switch (token_.kind) {
      case Token::Kind::number: {
        double number = 0;
        return take_number(number) && emit({FormulaOp::number, 0, number});
      }
      case Token::Kind::name:
      case Token::Kind::quoted:
        return named();
      case Token::Kind::sign:
        if (token_.is_sign("(")) return parenthesized();
        break;
      case Token::Kind::unclosed:
      case Token::Kind::end:
        break;
    }
    return fail("a number, a name or `(`");
  }

  bool parenthesized() {
    if (!open() || !disjunction()) return false;
    return close("an operator or `)`");
  }

  /// A word, a call of a function, or an input.
  bool named() {
    const Token first = token_;
    if (first.text == "''") return fail("a name");
    if (first.is_name("not")) return fail("a number, a name or `(`", "; put `not` and what follows in parentheses");
    if (first.is_name("and") || first.is_name("or")) return fail("a number, a name or `(`");
    advance();
    if (first.kind == Token::Kind::name && token_.is_sign("(")) return call(first);
    Operand operand{{name_of(first)}, {}, {}, first.index()};
    if (first.is_name("pi") && !token_.is_sign(".")) return emit({FormulaOp::number, 0, std::numbers::pi});
    if (first.is_name("time") && !token_.is_sign(".")) return emit(FormulaInput{});
    if (!further_names(operand) || !output_number(operand)) return false;
    auto found = formula_input(operand, names_);
    if (auto* fault = std::get_if<Fault>(&found)) return fail_name(first, operand, std::move(*fault));
    return emit(std::get<FormulaInput>(found));
  }

  bool further_names(Operand& operand) {
    while (token_.is_sign(".")) {
      advance(true);
      const bool is_name =
          (token_.kind == Token::Kind::name || token_.kind == Token::Kind::quoted) && token_.text != "''";
      if (!is_name) return fail("a name");
      operand.names.push_back(name_of(token_));
      advance();
    }
    operand.index = whole(operand.names);
    return true;
  }

  bool output_number(Operand& operand) {
    if (!token_.is_sign("[")) return true;
    advance(true);
    if (token_.kind != Token::Kind::name) return fail("the number of an output");
    operand.output = name_of(token_);
    advance();
    if (!token_.is_sign("]")) return fail("`]`");
    advance();
    return true;
  }

  bool call(const Token& name) {
    const FormulaFunction* function = function_of(name.text);
    if (function == nullptr) return fail_function(name);
    if (!open()) return false;
    std::uint32_t count = 0;
    if (!token_.is_sign(")")) {
      if (function->op == FormulaOp::curve) return curve(name, *function);
      do {
        if (!disjunction()) return false;
        ++count;
        const bool of_many = function->op == FormulaOp::min || function->op == FormulaOp::max;
        if (of_many && count > 1 && !emit({function->op})) return false;
      } while (take_comma());
    }
    if (!close("an operator, `,` or `)`")) return false;
    return arguments(name, *function, count);
  }

  /// Checks the number of arguments, and adds the step of most functions.
  bool arguments(const Token& name, const FormulaFunction& function, std::uint32_t count) {
    const bool of_many = function.op == FormulaOp::min || function.op == FormulaOp::max;
    if (of_many ? count < function.count : count != function.count) {
      if (function.op == FormulaOp::curve) return fail_points(name, function, 0);
      return fail(name.index(), ticked(function.name) + " takes " + std::to_string(function.count) +
                                    (of_many               ? " or more arguments"
                                     : function.count == 1 ? " argument"
                                                           : " arguments") +
                                    ", as in " + usage(function) + ", but has " + std::to_string(count));
    }
    return of_many || emit({function.op});
  }

  /// The arguments of a curve: x, then the points.
  bool curve(const Token& name, const FormulaFunction& function) {
    if (!disjunction()) return false;
    const auto at = static_cast<std::uint32_t>(formula_.numbers.size());
    formula_.numbers.push_back(0);
    while (take_comma()) {
      if (!point(at + 1)) return false;
    }
    if (!close("`,` or `)`")) return false;
    const std::size_t count = formula_.numbers.size() - at - 1;
    if (count < 4 || count % 2 != 0) return fail_points(name, function, count);
    const std::size_t points = count / 2;
    formula_.numbers[at] = static_cast<double>(points);
    return emit({FormulaOp::curve, at});
  }

  /// An x or y of a curve, whose numbers begin at `first`.
  bool point(std::size_t first) {
    const bool negative = token_.is_sign("-");
    if (negative) advance();
    if (token_.kind != Token::Kind::number) return fail("a number", "; the points of `curve` are numbers");
    const Token token = token_;
    double number = 0;
    if (!take_number(number)) return false;
    if (negative) number = -number;
    std::vector<double>& numbers = formula_.numbers;
    const std::size_t count = numbers.size() - first;
    if (count % 2 == 0 && count > 0 && !(numbers[numbers.size() - 2] < number)) {
      return fail(token.index(),
                  "x of this point is not above that of the point before; sort the points of `curve` by x");
    }
    numbers.push_back(number);
    return true;
  }

  // Tokens.

  void advance(bool digits_begin_names = false) { token_ = tokens_.next(digits_begin_names); }

  std::optional<FormulaOp> taken(std::span<const Operator> operators) {
    if (token_.kind != Token::Kind::sign && token_.kind != Token::Kind::name) return std::nullopt;
    for (const Operator& each : operators) {
      if (token_.text != each.text) continue;
      advance();
      return each.op;
    }
    return std::nullopt;
  }

  bool take_comma() {
    const bool is_comma = token_.is_sign(",");
    if (is_comma) advance();
    return is_comma;
  }

  bool take_number(double& number) {
    auto read = read_double(token_);
    if (auto* fault = std::get_if<Fault>(&read)) {
      fault_ = std::move(*fault);
      return false;
    }
    number = std::get<double>(read);
    advance();
    return true;
  }

  /// `(`
  bool open() {
    if (++nesting_ > kDeepestNesting) {
      return fail(token_.index(), "more than " + std::to_string(kDeepestNesting) + " nested parentheses");
    }
    advance();
    return true;
  }

  bool close(const std::string& expected) {
    if (!token_.is_sign(")")) return fail(expected);
    --nesting_;
    advance();
    return true;
  }

  // Steps.

  bool emit(const tables::FormulaStep& step) {
    depth_ = depth_ + 1 - tables::operands_of(step.op);
    formula_.steps.push_back(step);
    if (depth_ <= tables::kMostFormulaDepth) return true;
    return fail(token_.index(), "the formula is too nested here: it would hold more than " +
                                    std::to_string(tables::kMostFormulaDepth) +
                                    " numbers at a time; make a part of it a value");
  }

  bool emit(const FormulaInput& input) {
    const Key key{input.kind, input.of, input.part, input.atom.kind, input.atom.of, input.atom.state};
    const auto [found, is_new] = inputs_.try_emplace(key, static_cast<std::uint32_t>(formula_.inputs.size()));
    if (is_new) formula_.inputs.push_back(input);
    return emit({FormulaOp::input, found->second});
  }

  // Faults.

  bool fail(Location index, std::string message) {
    fault_ = Fault{index, std::move(message)};
    return false;
  }

  bool fail(const std::string& expected, const std::string& more = {}) {
    if (token_.kind == Token::Kind::unclosed) {
      return fail(token_.index(), "this quote is not closed; add a `'` after the name");
    }
    if (token_.kind == Token::Kind::end) {
      return fail(token_.index(), "expected " + expected + ", but the formula ends" + more);
    }
    return fail(token_.index(), "expected " + expected + ", but found " + ticked(token_.text) + more + habit());
  }

  /// What may be meant by the token.
  std::string habit() const {
    if (token_.kind == Token::Kind::name) {
      const std::string_view word = lower_case_of(token_.text);
      return word.empty() ? "" : "; words are in lower case, write " + ticked(word);
    }
    const auto found =
        std::find_if(kHabits.begin(), kHabits.end(), [this](const Habit& each) { return token_.is_sign(each.sign); });
    return found == kHabits.end() ? "" : "; " + std::string(found->instead);
  }

  /// A name that is not found may be meant as a word or a function.
  bool fail_name(const Token& first, const Operand& operand, Fault fault) {
    fault_ = std::move(fault);
    fault_->of_name = true;
    if (first.kind != Token::Kind::name || operand.names.size() != 1) return false;
    const std::string_view word = lower_case_of(first.text);
    if (!word.empty()) fault_->message += "; words are in lower case, write " + ticked(word);
    if (const FormulaFunction* function = function_of(first.text)) {
      fault_->message += "; the function is " + usage(*function);
    }
    return false;
  }

  bool fail_function(const Token& name) {
    std::string_view nearest = lower_case_of(name.text);
    tables::NearestName near(name.text);
    for (const FormulaFunction& function : kFormulaFunctions) near.offer(function.name);
    if (nearest.empty()) nearest = near.name();
    return fail(name.index(), missing("function " + ticked(name.text), std::string(nearest)));
  }

  bool fail_points(const Token& name, const FormulaFunction& function, std::size_t count) {
    return fail(name.index(), "`curve` takes x and two or more points, as in " + usage(function) + ", but has " +
                                  std::to_string(count) + " numbers for x and y of points");
  }

  using Key = std::tuple<FormulaInput::Kind, std::uint32_t, std::uint32_t, Atom::Kind, std::uint32_t, std::uint8_t>;

  const Names& names_;
  Tokens tokens_;
  Token token_;
  Formula formula_;
  std::map<Key, std::uint32_t> inputs_;  ///< the index of each input
  std::optional<Fault> fault_;
  std::size_t nesting_ = 0;
  std::uint32_t depth_ = 0;  ///< numbers on the stack after the steps
};

}  // namespace

bool is_formula_word(std::string_view name) {
  const auto is_it = [name](std::string_view word) { return is_word(name, word); };
  return std::any_of(std::begin(kWords), std::end(kWords), is_it) ||
         std::any_of(kFormulaFunctions.begin(), kFormulaFunctions.end(),
                     [&](const FormulaFunction& function) { return is_it(function.name); });
}

std::variant<Formula, Fault> parse_formula(std::string_view text, const Names& names) {
  return Parser(text, names).run();
}

}  // namespace symplant::condition
