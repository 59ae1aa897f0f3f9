// model_hash: equal for equal tables, another as soon as anything differs.
#include "symplant/core/digest.hpp"

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "support/catch.hpp"

namespace symplant::test {
namespace {

using core::PlantTables;

/// Tables with a row of every kind.
struct Sample {
  std::vector<core::Transition> transitions{{0, 1, 0}, {1, 0, core::kNoOperation}};
  std::vector<std::uint64_t> enter{1, 2};
  std::vector<std::uint64_t> leave{1, 2};
  std::vector<std::uint8_t> targets{1};
  std::vector<core::UnitRow> units{{0, 0, 0, 0, 0}};
  std::vector<core::TransitionTimes> times{{0, 5}, {0, 6}, {7, 0}};
  std::vector<core::SymbolRow> symbols{
      {0, 0, 3, 2,
       core::symbol_kind(core::DataType::boolean, core::Direction::operation, core::AddressForm::number, true)}};
  std::vector<core::InitialValue> initial{{0, 1}};
  std::vector<core::SharedAddress> shared{{0, 0}};
  std::uint8_t rest = core::kNoState;
  core::Actuation actuation = core::Actuation::latched;
  std::string name = "plant";
  std::string unit_names{"U\0", 2};
  std::string state_names{"A\0B\0", 4};
  std::string symbol_names{"S\0Y3\0", 5};
  std::string list = "list.csv";
  std::uint32_t bits = 64;

  std::uint64_t hash() const {
    const std::vector<core::TypeRow> types{{1, 2, 2, rest, actuation, transitions, enter, leave, targets}};
    return core::model_hash({name, types, units, times, symbols, initial, shared, bits, bits, 0, 0, unit_names,
                             state_names, symbol_names, list});
  }
};

TEST_CASE("every field of every row counts for the hash") {
  const std::vector<std::function<void(Sample&)>> changes{
      [](Sample& s) { s.transitions[0].from = 1; },
      [](Sample& s) { s.transitions[0].to = 0; },
      [](Sample& s) { s.transitions[1].on = 0; },
      [](Sample& s) { s.enter[1] = 3; },
      [](Sample& s) { s.leave[1] = 3; },
      [](Sample& s) { s.targets[0] = 0; },
      [](Sample& s) { s.rest = 0; },
      [](Sample& s) { s.actuation = core::Actuation::spring; },
      [](Sample& s) { s.units[0].type = 1; },
      [](Sample& s) { s.units[0].operation_bit = 1; },
      [](Sample& s) { s.units[0].event_bit = 1; },
      [](Sample& s) { s.units[0].times = 1; },
      [](Sample& s) { s.units[0].initial = 1; },
      [](Sample& s) { s.times[1].takes = 7; },
      [](Sample& s) { s.times[2].after = 8; },
      [](Sample& s) { s.symbols[0].index = 1; },
      [](Sample& s) { s.symbols[0].unit = core::kNoUnit; },
      [](Sample& s) { s.symbols[0].number = 4; },
      [](Sample& s) {
        s.symbols[0].kind =
            core::symbol_kind(core::DataType::int_, core::Direction::operation, core::AddressForm::number, true);
      },
      [](Sample& s) {
        s.symbols[0].kind =
            core::symbol_kind(core::DataType::boolean, core::Direction::event, core::AddressForm::number, true);
      },
      [](Sample& s) {
        s.symbols[0].kind =
            core::symbol_kind(core::DataType::boolean, core::Direction::operation, core::AddressForm::none, true);
      },
      [](Sample& s) {
        s.symbols[0].kind =
            core::symbol_kind(core::DataType::boolean, core::Direction::operation, core::AddressForm::number, false);
      },
      [](Sample& s) { s.initial[0].value = 0; },
      [](Sample& s) { s.initial[0].symbol = 1; },
      [](Sample& s) { s.shared[0].leader = 1; },
      [](Sample& s) { s.name = "plane"; },
      [](Sample& s) { s.unit_names[0] = 'V'; },
      [](Sample& s) { s.state_names[0] = 'C'; },
      [](Sample& s) { s.symbol_names[0] = 'T'; },
      [](Sample& s) { s.bits = 128; },
      [](Sample& s) { s.units.push_back(s.units[0]); },
      [](Sample& s) { s.initial.clear(); },
  };
  std::set<std::uint64_t> hashes{Sample{}.hash()};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Sample sample;
    changes[i](sample);
    INFO("change " << i);
    CHECK(hashes.insert(sample.hash()).second);
  }
}

TEST_CASE("where the list lies and in which line a symbol stands do not count") {
  Sample sample;
  const std::uint64_t before = sample.hash();
  sample.list = "other.csv";
  sample.symbols[0].row = 99;
  CHECK(sample.hash() == before);
}

}  // namespace
}  // namespace symplant::test
