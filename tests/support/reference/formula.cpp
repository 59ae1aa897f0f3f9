// Parses and evaluates formulas.
#include "support/reference/formula.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "support/reference/formula_text.hpp"
#include "support/reference/material.hpp"
#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

/// A function, and how many arguments it has: at least and at most.
struct Function {
  std::string_view name;
  std::size_t least;
  std::size_t most;
};
constexpr std::size_t kAny = 1'000'000;
constexpr std::array kFunctions = {
    Function{"abs", 1, 1},   Function{"sign", 1, 1}, Function{"floor", 1, 1},   Function{"ceil", 1, 1},
    Function{"round", 1, 1}, Function{"sqrt", 1, 1}, Function{"exp", 1, 1},     Function{"ln", 1, 1},
    Function{"sin", 1, 1},   Function{"cos", 1, 1},  Function{"tan", 1, 1},     Function{"asin", 1, 1},
    Function{"acos", 1, 1},  Function{"atan", 1, 1}, Function{"pow", 2, 2},     Function{"mod", 2, 2},
    Function{"atan2", 2, 2}, Function{"wrap", 3, 3}, Function{"min", 2, kAny},  Function{"max", 2, kAny},
    Function{"limit", 3, 3}, Function{"if", 3, 3},   Function{"curve", 5, kAny}};

Formula call_of(std::string_view name, std::vector<Formula> children) {
  Formula formula;
  formula.kind = Formula::Kind::call;
  formula.call = name;
  formula.children = std::move(children);
  return formula;
}

class FormulaParser {
 public:
  explicit FormulaParser(std::string_view text) : tokens_(text) {}

  Formula parse() {
    Formula formula = any();
    tokens_.expect_end();
    return formula;
  }

 private:
  Formula any() {
    Formula left = all();
    while (tokens_.accept_word("or")) left = call_of("or", {left, all()});
    return left;
  }
  Formula all() {
    Formula left = negation();
    while (tokens_.accept_word("and")) left = call_of("and", {left, negation()});
    return left;
  }
  Formula negation() {
    if (tokens_.accept_word("not")) return call_of("not", {negation()});
    return comparison();
  }
  Formula comparison() {
    Formula left = sum();
    for (const std::string_view sign : {"<", "<=", "=", ">=", ">"}) {
      if (tokens_.accept_sign(sign)) return call_of(sign, {left, sum()});
    }
    return left;
  }
  Formula sum() {
    Formula left = product();
    while (tokens_.is_sign("+") || tokens_.is_sign("-")) {
      const std::string sign = tokens_.take().text;
      left = call_of(sign, {left, product()});
    }
    return left;
  }
  Formula product() {
    Formula left = unary();
    while (tokens_.is_sign("*") || tokens_.is_sign("/")) {
      const std::string sign = tokens_.take().text;
      left = call_of(sign, {left, unary()});
    }
    return left;
  }
  Formula unary() {
    if (tokens_.accept_sign("-")) return call_of("negate", {unary()});
    return primary();
  }
  Formula primary() {
    Formula formula;
    if (tokens_.accept_sign("(")) {
      formula = any();
      tokens_.expect_sign(")");
      return formula;
    }
    if (tokens_.next().kind == Token::Kind::number) {
      formula.number = double_of(tokens_.take().text);
      return formula;
    }
    for (const Function& function : kFunctions) {
      if (tokens_.is_word(function.name) && tokens_.is_sign_after_next("(")) return function_call(function);
    }
    for (const std::string_view word : {"and", "or", "not"}) {
      if (tokens_.is_word(word)) throw std::runtime_error("an operand expected before `" + std::string(word) + "`");
    }
    if (tokens_.accept_word("time")) {
      formula.kind = Formula::Kind::time;
    } else if (tokens_.accept_word("pi")) {
      formula.number = std::numbers::pi;
    } else {
      formula.kind = Formula::Kind::input;
      formula.name = tokens_.dotted_name();
    }
    return formula;
  }
  Formula function_call(const Function& function) {
    tokens_.take();
    tokens_.expect_sign("(");
    std::vector<Formula> arguments;
    do arguments.push_back(any());
    while (tokens_.accept_sign(","));
    tokens_.expect_sign(")");
    const bool pairs = function.name != "curve" || arguments.size() % 2 == 1;
    if (arguments.size() < function.least || arguments.size() > function.most || !pairs) {
      throw std::runtime_error("`" + std::string(function.name) + "` has another number of arguments");
    }
    return call_of(function.name, std::move(arguments));
  }

  Tokens tokens_;
};

double least_of(double a, double b) { return b < a ? b : a; }
double most_of(double a, double b) { return a < b ? b : a; }
double truth_of(bool truth) { return truth ? 1 : 0; }

/// `x` and the points are the arguments.
double curve_of(const std::vector<double>& at) {
  const double x = at[0];
  const std::size_t last = at.size() - 2;
  if (std::isnan(x)) return x;
  if (x <= at[1]) return at[2];
  if (x >= at[last]) return at[last + 1];
  std::size_t i = 1;
  while (x >= at[i + 2]) i += 2;
  return at[i + 1] + (x - at[i]) * (at[i + 3] - at[i + 1]) / (at[i + 2] - at[i]);
}

double of_one(const std::string& name, double x) {
  if (name == "negate") return -x;
  if (name == "not") return truth_of(x == 0);
  if (name == "abs") return std::fabs(x);
  if (name == "sign") return x > 0 ? 1 : x < 0 ? -1 : x;
  if (name == "floor") return std::floor(x);
  if (name == "ceil") return std::ceil(x);
  if (name == "round") return std::nearbyint(x);
  if (name == "sqrt") return std::sqrt(x);
  if (name == "exp") return std::exp(x);
  if (name == "ln") return std::log(x);
  if (name == "sin") return std::sin(x);
  if (name == "cos") return std::cos(x);
  if (name == "tan") return std::tan(x);
  if (name == "asin") return std::asin(x);
  if (name == "acos") return std::acos(x);
  if (name == "atan") return std::atan(x);
  throw std::runtime_error("`" + name + "` of one argument");
}

double of_two(const std::string& name, double a, double b) {
  if (name == "+") return a + b;
  if (name == "-") return a - b;
  if (name == "*") return a * b;
  if (name == "/") return a / b;
  if (name == "<") return truth_of(a < b);
  if (name == "<=") return truth_of(a <= b);
  if (name == "=") return truth_of(a == b);
  if (name == ">=") return truth_of(a >= b);
  if (name == ">") return truth_of(a > b);
  if (name == "and") return truth_of(a != 0 && b != 0);
  if (name == "or") return truth_of(a != 0 || b != 0);
  if (name == "pow") return std::pow(a, b);
  if (name == "mod") return std::fmod(a, b);
  if (name == "atan2") return std::atan2(a, b);
  throw std::runtime_error("`" + name + "` of two arguments");
}

double result_of(const std::string& name, const std::vector<double>& of) {
  if (name == "curve") return curve_of(of);
  if (name == "if") return of[0] != 0 ? of[1] : of[2];
  if (name == "limit") return least_of(most_of(of[0], of[1]), of[2]);
  if (name == "wrap") return of[0] - (of[2] - of[1]) * std::floor((of[0] - of[1]) / (of[2] - of[1]));
  if (name == "min" || name == "max") {
    double found = of[0];
    for (std::size_t i = 1; i < of.size(); ++i) {
      found = name == "min" ? least_of(found, of[i]) : most_of(found, of[i]);
    }
    return found;
  }
  return of.size() == 1 ? of_one(name, of[0]) : of_two(name, of[0], of[1]);
}

}  // namespace

Formula parse_formula(std::string_view text) { return FormulaParser(text).parse(); }

double number_of(const Sight& sight, const Input& input) {
  const World& world = sight.world;
  switch (input.kind) {
    case Input::Kind::output:
      return input.of == sight.jumping ? sight.output : world.values[input.of].outputs[input.part];
    case Input::Kind::bit:
      return truth_of(effective(world.symbols[input.of]) != 0);
    case Input::Kind::number:
      return as_double(sight.rules.model->symbols[input.of].type, effective(world.symbols[input.of]));
    case Input::Kind::settled:
      return truth_of(!world.units[input.of].moving && world.units[input.of].state == input.part);
    case Input::Kind::moving:
      return truth_of(world.units[input.of].moving);
    case Input::Kind::parts:
      return static_cast<double>(parts_at(world.material, input.of, input.part));
    case Input::Kind::weight:
      return weight_at(sight.rules, world, input.of);
  }
  return 0;
}

double evaluate(const Formula& formula, const Sight& sight) {
  switch (formula.kind) {
    case Formula::Kind::number:
      return formula.number;
    case Formula::Kind::time:
      return static_cast<double>(sight.world.time) / 1e9;
    case Formula::Kind::input:
      return number_of(sight, formula.input);
    case Formula::Kind::call:
      break;
  }
  std::vector<double> of;
  for (const Formula& child : formula.children) of.push_back(evaluate(child, sight));
  return result_of(formula.call, of);
}

}  // namespace symplant::reference
