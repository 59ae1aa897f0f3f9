// Reads pairs of states and operations from a VCD file of symplant.
#include "suite/state_pairs.hpp"

#include <algorithm>
#include <sstream>
#include <string>
#include <unordered_map>

namespace symplant::suite {
namespace {

constexpr std::uint32_t kNoState = static_cast<std::uint32_t>(-1);

/// A run so far: the state of each device, and which operations are on.
class Seen {
 public:
  explicit Seen(const trace::PlantNames& names)
      : names_(names), states_(names.tables().units.size(), kNoState), first_(states_.size() + 1, 0) {
    const auto& tables = names.tables();
    for (std::uint32_t unit = 0; unit < states_.size(); ++unit) {
      units_.emplace(names.unit(unit), unit);
      first_[unit + 1] = first_[unit] + tables.types[tables.units[unit].type].states;
    }
    for (std::uint32_t symbol = 0; symbol < tables.symbols.size(); ++symbol) {
      if (!names.is_operation(symbol) || tables.symbols[symbol].type() != tables::DataType::boolean) continue;
      operations_.emplace(names.symbol(symbol), static_cast<std::uint32_t>(operations_.size()));
    }
    pairs_.assign(std::size_t{first_.back()} * operations_.size(), false);
  }

  void variable(const std::string& kind, const std::string& code, const std::string& name) {
    if (kind == "string") {
      if (const auto found = units_.find(name); found != units_.end()) unit_of_[code] = found->second;
    } else if (const auto found = operations_.find(name); found != operations_.end()) {
      operation_of_[code] = found->second;
    }
  }

  void state(const std::string& code, const std::string& name) {
    const auto found = unit_of_.find(code);
    if (found == unit_of_.end()) return;
    const std::uint32_t unit = found->second;
    states_[unit] = kNoState;
    for (std::uint32_t state = 0; state < first_[unit + 1] - first_[unit]; ++state) {
      if (names_.state(unit, static_cast<std::uint8_t>(state)) == name) states_[unit] = first_[unit] + state;
    }
    if (states_[unit] == kNoState) return;
    for (const std::uint32_t operation : on_) add(states_[unit], operation);
  }

  void bit(const std::string& code, bool on) {
    const auto found = operation_of_.find(code);
    if (found == operation_of_.end()) return;
    std::erase(on_, found->second);
    if (!on) return;
    on_.push_back(found->second);
    for (const std::uint32_t state : states_) {
      if (state != kNoState) add(state, found->second);
    }
  }

  std::vector<std::uint64_t> all() const {
    std::vector<std::uint64_t> numbers;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (pairs_[i]) numbers.push_back(i);
    }
    return numbers;
  }

 private:
  void add(std::uint32_t state, std::uint32_t operation) {
    pairs_[std::size_t{state} * operations_.size() + operation] = true;
  }

  const trace::PlantNames& names_;
  std::vector<std::uint32_t> states_;  ///< of each device: a number among the states of all, kNoState while it moves
  std::vector<std::uint32_t> first_;   ///< the number of each device's first state
  std::unordered_map<std::string_view, std::uint32_t> units_;
  std::unordered_map<std::string_view, std::uint32_t> operations_;
  std::unordered_map<std::string, std::uint32_t> unit_of_;
  std::unordered_map<std::string, std::uint32_t> operation_of_;
  std::vector<std::uint32_t> on_;
  std::vector<bool> pairs_;
};

}  // namespace

std::vector<std::uint64_t> state_pairs(std::istream& vcd, const trace::PlantNames& names) {
  Seen seen(names);
  std::string line;
  while (std::getline(vcd, line)) {
    if (line.empty() || line[0] == '#') continue;
    if (line[0] == '$') {
      std::istringstream words(line);
      std::string word;
      std::string kind;
      std::string size;
      std::string code;
      std::string name;
      if (words >> word >> kind >> size >> code >> name && word == "$var") seen.variable(kind, code, name);
    } else if (line[0] == 's') {
      const std::size_t blank = line.find(' ');
      if (blank != line.npos) seen.state(line.substr(blank + 1), line.substr(1, blank - 1));
    } else if (line[0] == '0' || line[0] == '1') {
      seen.bit(line.substr(1), line[0] == '1');
    }
  }
  return seen.all();
}

}  // namespace symplant::suite
