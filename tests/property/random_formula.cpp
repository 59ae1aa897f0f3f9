// Writes formulas: mostly short and tame, some that divide by 0 or overflow.
#include "property/random_formula.hpp"

#include <algorithm>
#include <cctype>

#include "property/random_material.hpp"

namespace symplant::property {
namespace {

bool is_plain_name(std::string_view name) {
  return !name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) == 0 &&
         std::all_of(name.begin(), name.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; });
}

class FormulaWriter {
 public:
  FormulaWriter(Dice& dice, const FormulaNames& names) : dice_(dice), names_(names) {}

  std::string write(std::size_t size) {
    if (size <= 1) return operand();
    const std::size_t kind = dice_.below(100);
    if (kind < 55) return joined(size, kArithmetic);
    if (kind < 67) return joined(size, kLogic);
    if (kind < 75) {
      const std::string sign = dice_.percent(50) ? "-" : "not ";
      return sign + in_brackets(size - 1);
    }
    return call(size);
  }

 private:
  std::string operand() {
    const std::size_t kind = dice_.below(100);
    if (kind < 40 && !names_.values.empty()) return dice_.pick(names_.values);
    if (kind < 70 && !names_.plant.empty()) return dice_.pick(names_.plant);
    if (kind < 76) return "time";
    if (kind < 78) return "pi";
    if (kind < 80) return dice_.pick(kOdd);
    return random_literal(dice_);
  }

  std::string in_brackets(std::size_t size) { return size <= 1 ? operand() : "(" + write(size) + ")"; }

  /// With and without brackets, so that the order of operators matters. A comparison or a word needs them as an
  /// operand.
  std::string joined(std::size_t size, const std::vector<std::string>& operators) {
    const std::size_t left = 1 + dice_.below(size - 1);
    const std::string sign = dice_.pick(operators);
    const bool bare = operators == kArithmetic && size == 3 && dice_.percent(60);
    if (bare) {
      std::string text = operand();
      text += " " + sign + " " + operand();
      text += " " + dice_.pick(kArithmetic) + " ";
      return text += operand();
    }
    std::string text = in_brackets(left);
    text += " " + sign + " ";
    return text += in_brackets(size - left);
  }

  std::string call(std::size_t size) {
    const std::size_t kind = dice_.below(100);
    std::string text;
    if (kind < 40) {
      text = dice_.pick(kOfOne) + "(";
      text += write(size - 1);
    } else if (kind < 65) {
      const std::size_t left = 1 + dice_.below(size - 1);
      text = dice_.pick(kOfTwo) + "(";
      text += write(left) + ", ";
      text += write(std::max<std::size_t>(1, size - left));
    } else if (kind < 80) {
      text = "if(" + write(size / 2) + ", ";
      text += operand() + ", ";
      text += write(size / 2);
    } else if (kind < 88) {
      text = dice_.pick(kLimits) + "(";
      text += write(size - 1) + ", ";
      text += dice_.pick(kRanges);
    } else {
      text = "curve(" + write(size - 1) + ", ";
      text += dice_.pick(kCurves);
    }
    return text + ")";
  }

  static inline const std::vector<std::string> kArithmetic = {"+", "-", "*", "/", "+", "*", "-"};
  static inline const std::vector<std::string> kLogic = {"<", "<=", "=", ">=", ">", "and", "or"};
  static inline const std::vector<std::string> kOfOne = {"abs",  "sign", "floor", "ceil", "round", "sqrt",
                                                         "exp",  "ln",   "sin",   "cos",  "tan",   "asin",
                                                         "acos", "atan", "sqrt",  "round"};
  static inline const std::vector<std::string> kOfTwo = {"pow", "mod", "atan2", "min", "max", "min", "max"};
  static inline const std::vector<std::string> kLimits = {"limit", "wrap"};
  static inline const std::vector<std::string> kRanges = {"0, 10", "-1, 1", "0, 360", "-5.5, 2.5", "3, 3"};
  static inline const std::vector<std::string> kCurves = {"0, 0, 1, 10", "-1, 5, 0, 2.5, 4, -3", "0, 1, 10, 1, 20, 7"};
  static inline const std::vector<std::string> kOdd = {"0 / 0", "1 / 0", "1e308", "1e-308", "-0", "9007199254740993"};

  Dice& dice_;
  const FormulaNames& names_;
};

}  // namespace

FormulaNames formula_names(const model::PlantModel& model) {
  FormulaNames names;
  names.truths = atoms_of_plant(model);
  for (const std::string& atom : names.truths) {
    if (names.plant.size() < 40) names.plant.push_back(atom);
  }
  for (const model::Unit& unit : model.units) {
    if (is_plain_name(unit.path) && names.plant.size() < 60) names.plant.push_back(std::string(unit.path) + ".moving");
  }
  for (const model::Symbol& symbol : model.symbols) {
    if (symbol.type == tables::DataType::boolean || symbol.name().find('\'') != std::string_view::npos) continue;
    names.numbers.push_back("'" + std::string(symbol.name()) + "'");
  }
  for (std::uint32_t i = 0; i < model.material.locations(); ++i) {
    const std::string name = model.material.location_name(i);
    for (const char* what : {".part", ".parts", ".weight"}) names.plant.push_back(name + what);
    names.plant.push_back(name + "." + model.material.kinds.front().name);
    names.numbers.push_back(name + ".parts");
    names.numbers.push_back(name + ".weight");
  }
  names.plant.insert(names.plant.end(), names.numbers.begin(), names.numbers.end());
  return names;
}

std::string random_literal(Dice& dice) {
  static const std::vector<std::string> kLiterals = {"0",  "1",   "2",   "3",   "0.5", "0.1",
                                                     "10", "2.5", "100", "1e3", "1e-3"};
  return dice.pick(kLiterals);
}

std::string random_formula(Dice& dice, const FormulaNames& names, std::size_t size) {
  return FormulaWriter(dice, names).write(size);
}

std::string random_comparison(Dice& dice, const FormulaNames& names) {
  static const std::vector<std::string> kSigns = {" < ", " <= ", " = ", " >= ", " > "};
  const auto number = [&] {
    const std::string minus = dice.percent(20) ? "-" : "";
    return minus + random_literal(dice);
  };
  const auto other = [&] {
    if (!names.numbers.empty() && dice.percent(25)) return dice.pick(names.numbers);
    return !names.values.empty() && dice.percent(25) ? dice.pick(names.values) : number();
  };
  std::string left =
      names.values.empty() ? (names.numbers.empty() ? "1" : dice.pick(names.numbers)) : dice.pick(names.values);
  std::string right = other();
  if (dice.percent(25)) std::swap(left, right);
  const std::string sign = dice.pick(kSigns);
  if (sign == " = " && dice.percent(60)) right += " +- " + random_literal(dice);
  return left + sign + right;
}

std::string random_value_condition(Dice& dice, const FormulaNames& names) {
  const auto atom = [&] {
    const std::string negated = dice.percent(20) ? "not " : "";
    if (names.truths.empty() || dice.percent(45)) return negated + random_comparison(dice, names);
    return negated + dice.pick(names.truths);
  };
  if (dice.percent(70)) return atom();
  std::string text = atom();
  text += dice.percent(50) ? " and " : " or ";
  return text += atom();
}

}  // namespace symplant::property
