// Random conditions over everything in a plant.
#include <algorithm>
#include <cctype>

#include "property/random_unit.hpp"

namespace symplant::property {
namespace {

class ConditionWriter {
 public:
  ConditionWriter(Dice& dice, const PlannedPlant& plan, const PlannedUnit& own) : dice_(dice), plan_(plan), own_(own) {}

  std::string condition(std::size_t atoms) {
    if (atoms == 1) {
      const std::string sign = dice_.percent(25) ? "not " : "";
      return sign + atom();
    }
    const std::size_t left = 1 + dice_.below(atoms - 1);
    std::string text = condition(left);
    text += dice_.percent(55) ? " and " : " or ";
    text += condition(atoms - left);
    if (dice_.percent(35)) text = (dice_.percent(40) ? "not (" : "(") + text + ")";
    return text;
  }

 private:
  std::string atom() {
    const PlannedUnit& unit = dice_.percent(25) ? own_ : dice_.pick(plan_.units);
    const std::size_t kind = dice_.below(100);
    if (kind < 45) return cased(unit.path + "." + dice_.pick(unit.states()));
    if (kind < 55) return unit.path + ".moving";
    if (kind < 70 && !unit.operations().empty()) return cased(unit.path + "_O_" + dice_.pick(unit.operations()));
    if (kind < 82) return spare(unit);
    if (kind < 90) return number(unit);
    // The list may name an event `_O_` (random_rows): states are the safe names for those.
    return unit.signals.empty() ? cased(unit.path + "." + dice_.pick(unit.states()))
                                : cased(unit.path + "_I_" + dice_.pick(unit.signals));
  }

  std::string spare(const PlannedUnit& unit) {
    const std::size_t all = plan_.spare_bits.size() + plan_.followers.size();
    const std::size_t index = dice_.below(all);
    if (index < plan_.spare_bits.size()) return quoted(plan_.spare_bits[index]);
    if (index < all) return quoted(plan_.followers[index - plan_.spare_bits.size()]);
    return event(unit);
  }

  std::string event(const PlannedUnit& unit) {
    std::vector<std::string> sure;
    for (const PlannedTask& task : unit.tasks) {
      if (task.event && task.operation) sure.push_back(task.name);
    }
    if (sure.empty()) return cased(unit.path + "." + dice_.pick(unit.states()));
    return cased(unit.path + "_I_" + dice_.pick(sure));
  }

  std::string number(const PlannedUnit& unit) {
    static const std::vector<std::string> kComparisons = {"<", "<=", "=", ">=", ">"};
    static const std::vector<std::string> kOperands = {"0", "1", "2", "3", "5", "2.5", "-1", "300"};
    const bool spare = unit.values.empty() || (!plan_.spare_values.empty() && dice_.percent(30));
    if (spare && plan_.spare_values.empty()) return event(unit);
    std::string name;
    if (spare) {
      name = quoted(dice_.pick(plan_.spare_values).name);
    } else {
      const PlannedValue& value = dice_.pick(unit.values);
      name = unit.path + (value.operation ? "_O_" : "_I_") + value.name;
    }
    const std::string& comparison = dice_.pick(kComparisons);
    return name + " " + comparison + " " + dice_.pick(kOperands);
  }

  /// Names are compared ignoring case.
  std::string cased(std::string name) {
    if (dice_.percent(90)) return name;
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
  }

  static std::string quoted(const std::string& name) {
    const auto plain = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    return std::all_of(name.begin(), name.end(), plain) ? name : "'" + name + "'";
  }

  Dice& dice_;
  const PlannedPlant& plan_;
  const PlannedUnit& own_;
};

}  // namespace

std::string random_condition(Dice& dice, const PlannedPlant& plan, const PlannedUnit& own) {
  const std::size_t kind = dice.below(100);
  const std::size_t atoms = kind < 55 ? 1 : kind < 78 ? 2 : kind < 92 ? 3 + dice.below(2) : 5 + dice.below(6);
  return ConditionWriter(dice, plan, own).condition(atoms);
}

}  // namespace symplant::property
