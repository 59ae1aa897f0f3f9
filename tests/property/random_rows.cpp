// The symbol list of a random plan.
#include <algorithm>

#include "property/random_unit.hpp"

namespace symplant::property {
namespace {

class RowWriter {
 public:
  explicit RowWriter(Dice& dice) : dice_(dice) {}

  void bit(std::string name, bool operation, bool needs_address = false) {
    const std::string initial = dice_.percent(operation ? 5 : 15) ? "TRUE" : dice_.percent(50) ? "FALSE" : "";
    std::string address;
    if (needs_address || !dice_.percent(6)) address = (operation ? "%QX" : "%IX") + std::to_string(next_++);
    rows.push_back({std::move(name), std::move(address), "BOOL", initial});
  }
  void number(std::string name, const PlannedValue& value, bool needs_address) {
    std::string initial;
    if (dice_.percent(40)) initial = std::to_string(dice_.below(8));
    std::string address;
    if (needs_address || dice_.percent(70)) {
      address = (value.operation ? "%Q" : "%I") + std::string(1, size_of(value.type)) + next_number(value.type);
    }
    rows.push_back({std::move(name), std::move(address), value.type, std::move(initial)});
  }
  void unit(const PlannedUnit& unit) {
    for (const PlannedTask& task : unit.tasks) {
      if (task.operation) bit(name(unit, "_O_", task.name), true);
      if (!task.event) continue;
      // The address overrides the name if the name differs.
      const bool odd = !task.operation && dice_.percent(5);
      bit(name(unit, odd ? "_O_" : "_I_", task.name), false, odd);
      if (!odd && !task.operation && dice_.percent(2)) bit(name(unit, "_O_", task.name), false, true);
    }
    for (const std::string& task : unit.commands) bit(name(unit, "_O_", task), true);
    for (const std::string& task : unit.signals) bit(name(unit, "_I_", task), false);
    for (const PlannedValue& value : unit.values) {
      number(name(unit, value.operation ? "_O_" : "_I_", value.name), value, false);
    }
  }

  std::vector<Row> rows;

 private:
  static char size_of(const std::string& type) {
    if (type == "SINT" || type == "USINT" || type == "BYTE") return 'B';
    if (type == "INT" || type == "UINT" || type == "WORD") return 'W';
    if (type == "LINT" || type == "ULINT" || type == "LWORD" || type == "LREAL") return 'L';
    return 'D';
  }
  /// A number after all existing ones: %IL3 lies on the registers of %ID6 and %ID7.
  std::string next_number(const std::string& type) {
    const std::size_t registers = size_of(type) == 'L' ? 4 : size_of(type) == 'D' ? 2 : 1;
    const std::size_t number = (next_ + registers - 1) / registers;
    next_ = (number + 1) * registers;
    return std::to_string(number);
  }
  static std::string name(const PlannedUnit& unit, const char* direction, const std::string& task) {
    return unit.path + direction + task;
  }

  Dice& dice_;
  std::size_t next_ = 0;
};

/// Gives rows the addresses of other rows of their kind.
void share_addresses(Dice& dice, std::vector<Row>& rows) {
  const std::size_t pairs = 1 + dice.below(1 + rows.size() / 6);
  for (std::size_t i = 0; i < pairs; ++i) {
    Row& row = rows[dice.below(rows.size())];
    const Row& other = rows[dice.below(rows.size())];
    if (row.address.empty() || other.address.empty() || row.type != other.type) continue;
    if (row.address[1] == other.address[1]) row.address = other.address;
  }
}

}  // namespace

std::vector<Row> random_rows(Dice& dice, const PlannedPlant& plan) {
  RowWriter writer(dice);
  for (const PlannedUnit& unit : plan.units) writer.unit(unit);
  for (const std::string& name : plan.spare_bits) writer.bit(name, dice.percent(35), true);
  for (const std::string& name : plan.followers) writer.bit(name, false, true);
  for (const PlannedValue& value : plan.spare_values) writer.number(value.name, value, true);
  if (dice.percent(30)) dice.shuffle(writer.rows);
  if (dice.percent(35)) share_addresses(dice, writer.rows);
  return std::move(writer.rows);
}

}  // namespace symplant::property
